// lib/pliant/quality/tangent_jump.cpp: tangents of splines by de Boor's algorithm, tangents of edges by polygon legs.
#include "pliant/quality/tangent_jump.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace pliant {
namespace {

/// The tangent of a polygon at its start or its end, in the polygon's direction: the vector between that end and the
/// first control point from there that differs from it.
Vector end_leg(const MeshData& data, std::span<const PointId> ids, bool from_end) {
  const std::size_t n = ids.size();
  const auto point = [&](std::size_t k) {
    return data.points[static_cast<std::size_t>(ids[from_end ? n - 1 - k : k])];
  };
  for (std::size_t k = 1; k < n; ++k)
    if (point(k) != point(0)) return from_end ? point(0) - point(k) : point(k) - point(0);
  return {};
}

struct LargestAngle {
  std::optional<double> value;
  void see(const Vector& before, const Vector& after) {
    if (before == Vector{} || after == Vector{}) return;
    // Divided by their lengths, small derivatives have products that do not underflow. atan2 is exact near zero.
    const Vector u = before / length(before), v = after / length(after);
    value = std::max(value.value_or(0), std::fabs(std::atan2(cross(u, v), dot(u, v))));
  }
};

}  // namespace

std::optional<double> tangent_jump(const MeshData& data) {
  LargestAngle largest;
  std::vector<std::vector<const ConstrainedEdge*>> edges(data.boundary.curves.size());
  for (std::size_t c = 0; c < edges.size(); ++c)
    edges[c].resize(static_cast<std::size_t>(data.boundary.curves[c].spline.span_count()));
  for (const ConstrainedEdge& edge : data.constrained_edges)
    edges[static_cast<std::size_t>(edge.curve)][static_cast<std::size_t>(edge.span)] = &edge;
  for (std::size_t c = 0; c < edges.size(); ++c) {
    const BSpline& spline = data.boundary.curves[c].spline;
    const std::vector<double> breaks = spline.breaks();
    const std::size_t spans = edges[c].size();
    for (std::size_t s = spline.closed() ? 0 : 1; s < spans; ++s) {
      if (spline.multiplicity(breaks[s]) >= spline.degree()) continue;
      const double before = s == 0 ? spline.last_parameter() : breaks[s];
      largest.see(spline.derivative(before, true), spline.derivative(breaks[s]));
      const ConstrainedEdge *from = edges[c][(s + spans - 1) % spans], *to = edges[c][s];
      if (from != nullptr && to != nullptr)
        largest.see(end_leg(data, from->points, true), end_leg(data, to->points, false));
    }
  }
  return largest.value;
}

}  // namespace pliant
