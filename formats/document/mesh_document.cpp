// formats/document/mesh_document.cpp: the mesh document, formats/mesh.md.
#include "formats/document/mesh_document.h"

#include <array>
#include <string>

#include "formats/document/boundary_document.h"
#include "formats/document/cbor/write_cbor.h"
#include "formats/document/presence.h"
#include "formats/document/write_json.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

double read_positive(DocumentReader& in) {
  const double value = in.number();
  if (!(value > 0)) in.fail("should be above zero");
  return value;
}

ConstrainedEdge read_constrained_edge(DocumentReader& in) {
  ConstrainedEdge edge;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "curve"))
      edge.curve = in.integer();
    else if (seen.is(name, "span"))
      edge.span = in.integer();
    else if (seen.is(name, "points"))
      in.integers(edge.points);
    else
      return false;
    return true;
  });
  seen.require({"curve", "span", "points"});
  return edge;
}

Field read_field(DocumentReader& in) {
  Field field;
  Presence seen(in);
  in.object(field.extra, [&](std::string_view name) {
    if (seen.is(name, "name")) {
      field.name = in.string();
    } else if (seen.is(name, "components")) {
      field.components = in.integer();
      if (field.components < 1) in.fail("should be at least 1");
    } else if (seen.is(name, "by_face")) {
      field.by_face = in.boolean();
    } else if (seen.is(name, "values")) {
      in.numbers(field.values);
    } else if (seen.is(name, "places")) {
      in.pairs(field.places);
    } else {
      return false;
    }
    return true;
  });
  seen.require({"name", "values"}, field.extra);
  seen.doubt({"components", "by_face", "places"}, field.extra);
  if (field.by_face && !seen.has("places"))
    in.fail("a field by face needs \"places\"" + Presence::suggest("places", field.extra));
  if (!field.by_face && seen.has("places"))
    in.fail("\"places\" belong to fields by face only" +
            (seen.has("by_face") ? "" : Presence::suggest("by_face", field.extra)));
  return field;
}

Criteria read_criteria(DocumentReader& in) {
  Criteria criteria;
  Presence seen(in);
  in.object(criteria.extra, [&](std::string_view name) {
    if (seen.is(name, "min_angle")) {
      criteria.min_angle = in.number();
      if (!(*criteria.min_angle >= 0 && *criteria.min_angle < 60)) in.fail("should be from 0 to below 60 degrees");
    } else if (seen.is(name, "max_area")) {
      criteria.max_area = read_positive(in);
    } else if (seen.is(name, "face_area")) {
      ExtraMembers unused;
      in.object(unused, [&](std::string_view face) {
        criteria.face_area.emplace_back(std::string(face), read_positive(in));
        return true;
      });
    } else if (seen.is(name, "size")) {
      criteria.size = in.string();
    } else if (seen.is(name, "size_field")) {
      criteria.size_field = in.string();
    } else if (seen.is(name, "max_turning")) {
      criteria.max_turning = read_positive(in);
    } else if (seen.is(name, "accuracy")) {
      criteria.accuracy = read_positive(in);
    } else if (seen.is(name, "min_size")) {
      criteria.min_size = read_positive(in);
    } else if (seen.is(name, "thin")) {
      const std::string thin = in.string();
      if (thin != "keep" && thin != "refine") in.fail("expected \"keep\" or \"refine\"");
      criteria.keeps_thin = thin == "keep";
    } else {
      return false;
    }
    return true;
  });
  seen.doubt_all(
      {"min_angle", "max_area", "face_area", "size", "size_field", "max_turning", "accuracy", "min_size", "thin"},
      criteria.extra, "is kept, but no criterion: nothing goes by it");
  return criteria;
}

MeshData read_mesh_object(DocumentReader& in) {
  MeshData data;
  Presence seen(in);
  in.object(data.extra, [&](std::string_view name) {
    if (seen.is(name, "format")) {
      read_format(in, "pliant-mesh");
    } else if (seen.is(name, "version")) {
      read_version(in);
    } else if (seen.is(name, "degree")) {
      data.degree = in.integer();
      if (data.degree < 1 || data.degree > max_degree)
        in.fail("the degree of a mesh is 1 to " + std::to_string(max_degree));
    } else if (seen.is(name, "time")) {
      data.time = in.number();
    } else if (seen.is(name, "points")) {
      in.points(data.points);
    } else if (seen.is(name, "triangles")) {
      in.integers(data.triangles);
    } else if (seen.is(name, "triangle_faces")) {
      in.integers(data.triangle_faces);
    } else if (seen.is(name, "constrained_edges")) {
      in.array([&] { data.constrained_edges.push_back(read_constrained_edge(in)); });
    } else if (seen.is(name, "fields")) {
      in.array([&] { data.fields.push_back(read_field(in)); });
    } else if (seen.is(name, "boundary")) {
      data.boundary = read_boundary_object(in, false);
    } else if (seen.is(name, "criteria")) {
      data.criteria = read_criteria(in);
    } else {
      return false;
    }
    return true;
  });
  seen.require(
      {"format", "version", "degree", "points", "triangles", "triangle_faces", "constrained_edges", "boundary"},
      data.extra);
  seen.doubt({"time", "fields", "criteria"}, data.extra);
  return data;
}

void write_field(DocumentWriter& out, const Field& field) {
  out.begin_object().name("name").value(field.name).name("components").value(field.components);
  out.name("by_face").value(field.by_face).name("values").numbers(field.values);
  if (field.by_face) out.name("places").pairs(field.places);
  out.members(field.extra);
  out.end_object();
}

void write_criteria(DocumentWriter& out, const Criteria& criteria) {
  out.begin_object();
  if (criteria.min_angle) out.name("min_angle").value(*criteria.min_angle);
  if (criteria.max_area) out.name("max_area").value(*criteria.max_area);
  if (!criteria.face_area.empty()) {
    out.name("face_area").begin_object();
    for (const auto& [face, area] : criteria.face_area) out.name(face).value(area);
    out.end_object();
  }
  if (criteria.size) out.name("size").value(*criteria.size);
  if (criteria.size_field) out.name("size_field").value(*criteria.size_field);
  if (criteria.max_turning) out.name("max_turning").value(*criteria.max_turning);
  if (criteria.accuracy) out.name("accuracy").value(*criteria.accuracy);
  if (criteria.min_size) out.name("min_size").value(*criteria.min_size);
  if (criteria.keeps_thin) out.name("thin").value(*criteria.keeps_thin ? "keep" : "refine");
  out.members(criteria.extra);
  out.end_object();
}

/// Throws where a number of the mesh is not finite: before anything of it is written.
void require_finite_mesh(const MeshData& mesh) {
  require_finite({&mesh.time, 1});
  for (const Point& p : mesh.points) require_finite(std::array{p.x, p.y});
  for (const Field& field : mesh.fields) require_finite(field.values);
  // The rest is tried out, and the bytes thrown away.
  const DocumentSink nowhere = [](std::string_view) {};
  std::string unused;
  CborWriter writer(unused, &nowhere);
  write_boundary_object(writer, mesh.boundary, false);
  write_criteria(writer, mesh.criteria);
  for (const Field& field : mesh.fields) writer.members(field.extra);
  writer.members(mesh.extra);
}

void write_mesh_object(DocumentWriter& out, const MeshData& mesh) {
  out.begin_object().name("format").value("pliant-mesh").name("version").value(1);
  out.name("degree").value(mesh.degree).name("time").value(mesh.time);
  out.name("points").points(mesh.points);
  out.name("triangles").integers(mesh.triangles);
  out.name("triangle_faces").integers(mesh.triangle_faces);
  out.name("constrained_edges").begin_array();
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    out.begin_object().name("curve").value(edge.curve).name("span").value(edge.span);
    out.name("points").integers(edge.points).end_object();
  }
  out.end_array().name("fields").begin_array();
  for (const Field& field : mesh.fields) write_field(out, field);
  out.end_array().name("boundary");
  write_boundary_object(out, mesh.boundary, false);
  out.name("criteria");
  write_criteria(out, mesh.criteria);
  out.members(mesh.extra);
  out.end_object().end();
}

void write_to(const MeshData& mesh, std::string& out, DocumentForm form, const DocumentSink* sink) {
  if (form == DocumentForm::cbor) {
    CborWriter writer(out, sink);
    write_mesh_object(writer, mesh);
  } else {
    JsonWriter writer(out, sink);
    write_mesh_object(writer, mesh);
  }
}

}  // namespace

MeshData read_mesh(std::string_view document, ReaderNotes* notes) {
  const auto in = reader_of(document);
  MeshData data = read_mesh_object(*in);
  in->finish();
  if (notes != nullptr) *notes = {in->doubts(), in->number_arrays()};
  const std::vector<Fault> faults = check_arrays(data);
  if (!faults.empty()) throw InputError(faults.front().place, faults.front().text);
  return data;
}

void write_mesh(const MeshData& mesh, std::string& out, DocumentForm form) { write_to(mesh, out, form, nullptr); }

void write_mesh(const MeshData& mesh, DocumentForm form, const DocumentSink& sink) {
  require_finite_mesh(mesh);
  std::string pieces;
  write_to(mesh, pieces, form, &sink);
}

}  // namespace pliant
