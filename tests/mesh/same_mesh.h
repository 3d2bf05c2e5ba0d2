// tests/mesh/same_mesh.h: compares two meshes, bit for bit, in everything that can be asked of them.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "pliant/mesh/mesh.h"

namespace pliant {

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
inline bool same_bits(const Point& a, const Point& b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }

/// The first difference in words; empty if there is none. Free slots are compared as far as they are visible.
inline std::string difference(const Mesh& a, const Mesh& b) {
  if (a.triangle_slots() != b.triangle_slots()) return "triangle slots";
  if (a.point_slots() != b.point_slots()) return "point slots";
  if (a.triangle_count() != b.triangle_count()) return "triangle count";
  if (!same_bits(a.measured_box().low, b.measured_box().low) ||
      !same_bits(a.measured_box().high, b.measured_box().high))
    return "measured box";
  if (!same_bits(a.tolerance(), b.tolerance())) return "tolerance";
  if (!same_bits(a.size(), b.size()) || !same_bits(a.time, b.time)) return "size or time";
  for (TriangleId t = 0; t < a.triangle_slots(); ++t) {
    const std::string place = " of triangle " + std::to_string(t);
    if (a.face(t) != b.face(t)) return "face" + place;
    for (std::size_t k = 0; k < a.net(t).size(); ++k)
      if (a.net(t)[k] != b.net(t)[k]) return "net" + place;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (a.twin(h) != b.twin(h)) return "twin" + place;
      const ConstraintId c = a.constraint(h);
      if (c != b.constraint(h)) return "constraint" + place;
      if (c != none &&
          (a.constraint_curve(c) != b.constraint_curve(c) || a.constraint_first(c) != b.constraint_first(c) ||
           !same_bits(a.constraint_start(c), b.constraint_start(c))))
        return "record of the constraint" + place;
    }
  }
  for (PointId p = 0; p < a.point_slots(); ++p) {
    const std::string place = " of point " + std::to_string(p);
    if (a.is_point_alive(p) != b.is_point_alive(p) || a.vertex_half_edge(p) != b.vertex_half_edge(p))
      return "half-edge" + place;
    if (!std::ranges::equal(a.pinched_half_edges(p), b.pinched_half_edges(p))) return "components" + place;
    if (a.is_lone_vertex(p) != b.is_lone_vertex(p)) return "loneliness" + place;
    if (!same_bits(a.point(p), b.point(p))) return "position" + place;
    for (int f = 0; f < static_cast<int>(a.fields().size()); ++f)
      for (FaceId face = 0; face < static_cast<FaceId>(a.boundary().faces.size()); ++face)
        if (a.value_index(f, p, face) != b.value_index(f, p, face)) return "index of a value" + place;
  }
  if (a.fields().size() != b.fields().size()) return "number of fields";
  for (std::size_t f = 0; f < a.fields().size(); ++f) {
    const Field &u = a.fields()[f], &v = b.fields()[f];
    if (u.name != v.name || u.components != v.components || u.by_face != v.by_face) return "field " + u.name;
    if (u.values.size() != v.values.size()) return "number of values of " + u.name;
    for (std::size_t k = 0; k < u.values.size(); ++k)
      if (!same_bits(u.values[k], v.values[k])) return "values of " + u.name;
  }
  if (a.boundary().curves.size() != b.boundary().curves.size()) return "number of curves";
  for (std::size_t c = 0; c < a.boundary().curves.size(); ++c) {
    const Curve &u = a.boundary().curves[c], &v = b.boundary().curves[c];
    if (!same_bits(u.removal_error, v.removal_error)) return "removal error";
    if (u.spline.knots() != v.spline.knots() || u.spline.points() != v.spline.points()) return "spline";
  }
  return "";
}

}  // namespace pliant
