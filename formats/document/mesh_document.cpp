// formats/document/mesh_document.cpp: the mesh document, formats/mesh.md.
#include "formats/document/mesh_document.h"

#include <string>

#include "formats/document/boundary_document.h"
#include "formats/document/presence.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

double read_positive(JsonReader& in) {
  const double value = in.number();
  if (!(value > 0)) in.fail("should be above zero");
  return value;
}

ConstrainedEdge read_constrained_edge(JsonReader& in) {
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

Field read_field(JsonReader& in) {
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

Criteria read_criteria(JsonReader& in) {
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

MeshData read_mesh_object(JsonReader& in) {
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

void write_field(JsonWriter& out, const Field& field) {
  out.begin_object().name("name").value(field.name).name("components").value(field.components);
  out.name("by_face").value(field.by_face).name("values").begin_array();
  for (const double value : field.values) out.value(value);
  out.end_array();
  if (field.by_face) {
    out.name("places").begin_array();
    for (const auto& [point, face] : field.places) out.value(point).value(face);
    out.end_array();
  }
  out.members(field.extra);
  out.end_object();
}

void write_criteria(JsonWriter& out, const Criteria& criteria) {
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

}  // namespace

MeshData read_mesh(std::string_view json, std::vector<Doubt>* doubts) {
  JsonReader in(json);
  MeshData data = read_mesh_object(in);
  in.finish();
  if (doubts != nullptr) *doubts = in.doubts();
  const std::vector<Fault> faults = check_arrays(data);
  if (!faults.empty()) throw InputError(faults.front().place, faults.front().text);
  return data;
}

void write_mesh(const MeshData& mesh, std::string& out) {
  JsonWriter writer(out);
  writer.begin_object().name("format").value("pliant-mesh").name("version").value(1);
  writer.name("degree").value(mesh.degree).name("time").value(mesh.time);
  writer.name("points").begin_array();
  for (const Point& p : mesh.points) writer.value(p.x).value(p.y);
  writer.end_array().name("triangles").begin_array();
  for (const PointId p : mesh.triangles) writer.value(p);
  writer.end_array().name("triangle_faces").begin_array();
  for (const FaceId f : mesh.triangle_faces) writer.value(f);
  writer.end_array().name("constrained_edges").begin_array();
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    writer.begin_object().name("curve").value(edge.curve).name("span").value(edge.span).name("points").begin_array();
    for (const PointId p : edge.points) writer.value(p);
    writer.end_array().end_object();
  }
  writer.end_array().name("fields").begin_array();
  for (const Field& field : mesh.fields) write_field(writer, field);
  writer.end_array().name("boundary");
  write_boundary_object(writer, mesh.boundary, false);
  writer.name("criteria");
  write_criteria(writer, mesh.criteria);
  writer.members(mesh.extra);
  writer.end_object();
  out += '\n';
}

}  // namespace pliant
