// formats/document/boundary_document.cpp: the boundary document, formats/boundary.md.
#include "formats/document/boundary_document.h"

#include <optional>
#include <string>

#include "formats/document/cbor/write_cbor.h"
#include "formats/document/mesh_document.h"
#include "formats/document/presence.h"
#include "formats/document/recognize.h"
#include "formats/document/write_json.h"

namespace pliant {
namespace {

Face read_face(DocumentReader& in) {
  Face face;
  Presence seen(in);
  in.object(face.extra, [&](std::string_view name) {
    if (!seen.is(name, "name")) return false;
    face.name = in.string();
    return true;
  });
  seen.require({"name"}, face.extra);
  return face;
}

int read_index_or_null(DocumentReader& in) {
  if (in.null()) return -1;
  const int index = in.integer();
  if (index < 0) in.fail("should be an index from 0, or null");
  return index;
}

/// The members of a B-spline before it is known that they make one.
struct SplineMembers {
  int degree = 0;
  bool closed = false;
  std::vector<double> knots;
  std::vector<Point> points;

  BSpline make(const DocumentReader& in, const std::string& name) {
    if (const std::optional<std::string> fault = BSpline::fault(degree, closed, knots, points)) {
      // A fault that opens with its place ("knots/7 is less than knots/6") extends the pointer.
      const std::string first = fault->substr(0, fault->find(' '));
      const bool placed = first.starts_with("knots/") || first.starts_with("points/");
      in.fail((name.empty() ? "" : "curve '" + name + "': ") + *fault, placed ? "/" + first : std::string());
    }
    return {degree, closed, std::move(knots), std::move(points)};
  }
};

Curve read_curve(DocumentReader& in) {
  Curve curve;
  SplineMembers spline;
  Presence seen(in);
  in.object(curve.extra, [&](std::string_view name) {
    if (seen.is(name, "name")) {
      curve.name = in.string();
    } else if (seen.is(name, "degree")) {
      spline.degree = in.integer();
      if (spline.degree < 1 || spline.degree > max_curve_degree)
        in.fail("the degree of a curve is 1 to " + std::to_string(max_curve_degree));
    } else if (seen.is(name, "closed")) {
      spline.closed = in.boolean();
    } else if (seen.is(name, "knots")) {
      in.numbers(spline.knots);
    } else if (seen.is(name, "points")) {
      in.points(spline.points);
    } else if (seen.is(name, "start")) {
      curve.start = read_index_or_null(in);
    } else if (seen.is(name, "end")) {
      curve.end = read_index_or_null(in);
    } else if (seen.is(name, "left")) {
      curve.left = read_index_or_null(in);
    } else if (seen.is(name, "right")) {
      curve.right = read_index_or_null(in);
    } else if (seen.is(name, "removal_error")) {
      curve.removal_error = in.number();
      if (curve.removal_error < 0) in.fail("should not be negative");
    } else {
      return false;
    }
    return true;
  });
  seen.require({"name", "degree", "closed", "knots", "points"}, curve.extra);
  seen.doubt({"start", "end", "left", "right", "removal_error"}, curve.extra);
  const bool has_ends = curve.start != no_vertex || curve.end != no_vertex;
  if (spline.closed && has_ends) in.fail("a closed curve has no ends: start and end should be null");
  if (!spline.closed && (curve.start == no_vertex || curve.end == no_vertex))
    in.fail("an open curve should name the vertices start and end" +
            Presence::suggest(curve.start == no_vertex ? "start" : "end", curve.extra));
  curve.spline = spline.make(in, curve.name);
  return curve;
}

/// Indices of vertices and faces, which can stand in the document before what they refer to.
void check_indices(const DocumentReader& in, const BoundaryComplex& boundary) {
  const auto check = [&](int index, std::size_t count, const char* of, const std::string& place) {
    if (index >= 0 && static_cast<std::size_t>(index) >= count)
      in.fail("is " + std::to_string(index) + ", but there are " + std::to_string(count) + " " + of, place);
  };
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const Curve& curve = boundary.curves[c];
    const std::string place = "/curves/" + std::to_string(c);
    check(curve.start, boundary.vertices.size(), "vertices", place + "/start");
    check(curve.end, boundary.vertices.size(), "vertices", place + "/end");
    check(curve.left, boundary.faces.size(), "faces", place + "/left");
    check(curve.right, boundary.faces.size(), "faces", place + "/right");
  }
  for (std::size_t i = 0; i < boundary.cusps.size(); ++i) {
    const std::string place = "/cusps/" + std::to_string(i);
    if (boundary.cusps[i] < 0) in.fail("should be the index of a vertex", place);
    check(boundary.cusps[i], boundary.vertices.size(), "vertices", place);
  }
}

void write_index_or_null(DocumentWriter& out, int index) {
  if (index < 0)
    out.null();
  else
    out.value(index);
}

void write_curve(DocumentWriter& out, const Curve& curve) {
  out.begin_object().name("name").value(curve.name);
  out.name("degree").value(curve.spline.degree()).name("closed").value(curve.spline.closed());
  const auto& knots = curve.spline.knots();
  const auto& points = curve.spline.points();
  out.name("knots").numbers(std::vector<double>(knots.begin(), knots.end()));
  out.name("points").points(std::vector<Point>(points.begin(), points.end()));
  out.name("start");
  write_index_or_null(out, curve.start);
  out.name("end");
  write_index_or_null(out, curve.end);
  out.name("left");
  write_index_or_null(out, curve.left);
  out.name("right");
  write_index_or_null(out, curve.right);
  out.name("removal_error").value(curve.removal_error);
  out.members(curve.extra);
  out.end_object();
}

}  // namespace

void read_format(DocumentReader& in, std::string_view format) {
  const std::string found = in.string();
  if (found == format) return;
  const std::string other = describe_other_format(found);
  in.fail("is \"" + found + "\", not \"" + std::string(format) + "\"" + (other.empty() ? "" : ": " + other));
}

void read_version(DocumentReader& in) {
  const int version = in.integer();
  if (version != 1) in.fail("is " + std::to_string(version) + "; this reader knows version 1");
}

BoundaryComplex read_boundary_object(DocumentReader& in, bool alone) {
  BoundaryComplex boundary;
  Presence seen(in);
  in.object(boundary.extra, [&](std::string_view name) {
    if (seen.is(name, "format"))
      read_format(in, "pliant-boundary");
    else if (seen.is(name, "version"))
      read_version(in);
    else if (seen.is(name, "vertices"))
      in.points(boundary.vertices);
    else if (seen.is(name, "faces"))
      in.array([&] { boundary.faces.push_back(read_face(in)); });
    else if (seen.is(name, "curves"))
      in.array([&] { boundary.curves.push_back(read_curve(in)); });
    else if (seen.is(name, "cusps"))
      in.integers(boundary.cusps);
    else
      return false;
    return true;
  });
  if (alone) seen.require({"format", "version"}, boundary.extra);
  seen.require({"vertices", "faces", "curves"}, boundary.extra);
  seen.doubt({"cusps"}, boundary.extra);
  check_indices(in, boundary);
  return boundary;
}

void write_boundary_object(DocumentWriter& out, const BoundaryComplex& boundary, bool alone) {
  out.begin_object();
  if (alone) out.name("format").value("pliant-boundary").name("version").value(1);
  out.name("vertices").points(boundary.vertices).name("faces").begin_array();
  for (const Face& face : boundary.faces) {
    out.begin_object().name("name").value(face.name);
    out.members(face.extra);
    out.end_object();
  }
  out.end_array().name("curves").begin_array();
  for (const Curve& curve : boundary.curves) write_curve(out, curve);
  out.end_array().name("cusps").integers(boundary.cusps).members(boundary.extra);
  out.end_object();
}

BoundaryComplex read_boundary(std::string_view document, ReaderNotes* notes) {
  const auto in = reader_of(document);
  BoundaryComplex boundary = read_boundary_object(*in, true);
  in->finish();
  if (notes != nullptr) *notes = {in->doubts(), in->number_arrays()};
  return boundary;
}

void write_boundary(const BoundaryComplex& boundary, std::string& out, DocumentForm form) {
  const auto write = [&](auto&& writer) {
    write_boundary_object(writer, boundary, true);
    writer.end();
  };
  if (form == DocumentForm::cbor)
    write(CborWriter(out));
  else
    write(JsonWriter(out));
}

}  // namespace pliant
