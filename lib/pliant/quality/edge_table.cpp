#include "pliant/quality/edge_table.h"  // lib/pliant/quality/edge_table.cpp: sorting, and Gauss rules on halved pieces

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/quadrature.h"

namespace pliant {
namespace {

using Polygon = std::array<Point, max_degree + 1>;

double gauss_length(std::span<const Point> polygon) {
  const std::size_t legs = polygon.size() - 1;
  double sum = 0;
  for (const SegmentNode& node : segment_rule(11)) {
    Polygon row;
    for (std::size_t k = 0; k < legs; ++k) row[k] = polygon[k + 1] - polygon[k];
    for (std::size_t n = legs - 1; n > 0; --n)
      for (std::size_t k = 0; k < n; ++k) row[k] = (1 - node.s) * row[k] + node.s * row[k + 1];
    sum += node.weight * length(row[0]);
  }
  return sum * static_cast<double>(legs);
}

double length_between(std::span<const Point> polygon, double guess, double tolerance, int depth) {
  const std::size_t n = polygon.size();
  Polygon left, right;
  std::ranges::copy(polygon, right.begin());
  left[0] = right[0];
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t k = 0; k + level < n; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
    left[level] = right[0];
  }
  const auto first = std::span<const Point>(left).first(n), second = std::span<const Point>(right).first(n);
  const double a = gauss_length(first), b = gauss_length(second);
  if (std::fabs(a + b - guess) <= tolerance || depth == 0) return a + b;
  return length_between(first, a, tolerance, depth - 1) + length_between(second, b, tolerance, depth - 1);
}

}  // namespace

EdgeUses edge_uses(const MeshData& data, const std::vector<bool>& is_chosen) {
  struct Use {
    std::pair<PointId, PointId> ends;
    HalfEdgeId half_edge;
    auto operator<=>(const Use&) const = default;
  };
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  std::vector<Use> uses;
  for (std::size_t t = 0; t < is_chosen.size(); ++t) {
    for (int e = 0; is_chosen[t] && e < 3; ++e) {
      const PointId from = data.triangles[t * n + static_cast<std::size_t>(e)];
      const PointId to = data.triangles[t * n + static_cast<std::size_t>((e + 1) % 3)];
      uses.push_back({std::minmax(from, to), half_edge(static_cast<TriangleId>(t), e)});
    }
  }
  std::sort(uses.begin(), uses.end());
  EdgeUses result;
  for (std::size_t k = 0; k < uses.size(); ++k) {
    if (k == 0 || uses[k].ends != uses[k - 1].ends) result.starts.push_back(k);
    result.half_edges.push_back(uses[k].half_edge);
  }
  result.starts.push_back(uses.size());
  return result;
}

std::vector<PointId> edge_ids(const MeshData& data, HalfEdgeId h) {
  const NetLayout& layout = NetLayout::of(data.degree);
  const auto first = static_cast<std::size_t>(triangle_of(h)) * static_cast<std::size_t>(layout.size());
  std::vector<PointId> ids;
  for (int k = 0; k <= data.degree; ++k)
    ids.push_back(data.triangles[first + static_cast<std::size_t>(layout.edge_index(edge_of(h), k))]);
  return ids;
}

std::vector<Point> edge_polygon(const MeshData& data, HalfEdgeId h) {
  std::vector<Point> points;
  for (const PointId p : edge_ids(data, h)) points.push_back(data.points[static_cast<std::size_t>(p)]);
  return points;
}

double curve_length(std::span<const Point> polygon) {
  const double chord = distance(polygon.front(), polygon.back());
  double legs = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k) legs += distance(polygon[k - 1], polygon[k]);
  if (!(legs - chord > 1e-14 * legs)) return chord;  // between the two lies the length
  return length_between(polygon, gauss_length(polygon), 1e-10 * legs, 20);
}

}  // namespace pliant
