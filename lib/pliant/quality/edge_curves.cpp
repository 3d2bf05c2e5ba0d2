// lib/pliant/quality/edge_curves.cpp: arc lengths by Gauss rules, on halved pieces where one rule is not enough.
#include "pliant/quality/edge_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

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
    sum += node.weight * std::sqrt(squared_length(row[0]));
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

/// The length of a parabola that bends gently; nothing for any other. Its speed is |v|, where v goes linearly from the
/// first leg to the second. As a function of the parameter, |v| is analytic except at two points of the complex plane.
/// Their distance from [0, 1] is the least |v| divided by the length by which v changes. If it is at least 2, six Gauss
/// nodes are right to 1e-11.
std::optional<double> gentle_length(std::span<const Point> polygon) {
  const Vector first = polygon[1] - polygon[0], second = polygon[2] - polygon[1], change = second - first;
  const double turn = squared_length(change);
  const double s = std::clamp(-dot(first, change) / turn, 0.0, 1.0);
  if (!(squared_length(first + s * change) > 4 * turn)) return std::nullopt;
  static const std::span<const SegmentNode> rule = segment_rule(11);
  double sum = 0;
  for (const SegmentNode& node : rule) sum += node.weight * std::sqrt(squared_length(first + node.s * change));
  return 2 * sum;
}

/// The length of a curve whose squared lengths over- or underflow: scales it by a power of two first. Infinite if the
/// size is not finite.
double length_at_any_scale(std::span<const Point> polygon, double size) {
  if (!std::isfinite(size)) return HUGE_VAL;
  if (size == 0) return 0;
  const int exponent = std::ilogb(size);
  Polygon scaled;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector from_first = polygon[k] - polygon[0];
    scaled[k] = {std::ldexp(from_first.x, -exponent), std::ldexp(from_first.y, -exponent)};
  }
  return std::ldexp(curve_length(std::span<const Point>(scaled).first(polygon.size())), exponent);
}

}  // namespace

std::vector<PointId> edge_ids(const MeshData& data, HalfEdgeId h) {
  const NetLayout& layout = NetLayout::of(data.degree);
  const auto first = static_cast<std::size_t>(triangle_of(h)) * static_cast<std::size_t>(layout.size());
  std::vector<PointId> ids;
  for (int k = 0; k <= data.degree; ++k)
    ids.push_back(data.triangles[first + static_cast<std::size_t>(layout.edge_index(edge_of(h), k))]);
  return ids;
}

void edge_polygon(const MeshData& data, HalfEdgeId h, std::span<Point> polygon) {
  const NetLayout& layout = NetLayout::of(data.degree);
  const PointId* net =
      &data.triangles[static_cast<std::size_t>(triangle_of(h)) * static_cast<std::size_t>(layout.size())];
  for (int k = 0; k <= data.degree; ++k)
    polygon[static_cast<std::size_t>(k)] = data.points[static_cast<std::size_t>(net[layout.edge_index(edge_of(h), k)])];
}

double edge_length(int degree, std::span<const Point> net, int e) {
  Polygon polygon;
  const auto first = static_cast<std::size_t>(e), second = static_cast<std::size_t>((e + 1) % 3);
  const auto inner = static_cast<std::size_t>(degree - 1);
  polygon[0] = net[first];
  for (std::size_t k = 0; k < inner; ++k) polygon[k + 1] = net[3 + first * inner + k];
  polygon[inner + 1] = net[second];
  return curve_length(std::span<const Point>(polygon).first(inner + 2));
}

double curve_length(std::span<const Point> polygon) {
  const Vector whole = polygon.back() - polygon.front();
  double legs = 0;
  double size = std::max(std::fabs(whole.x), std::fabs(whole.y));
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const Vector leg = polygon[k] - polygon[k - 1];
    size = std::max({size, std::fabs(leg.x), std::fabs(leg.y)});
  }
  if (!(size >= 0x1p-400 && size <= 0x1p400)) return length_at_any_scale(polygon, size);
  const double chord = std::sqrt(squared_length(whole));
  for (std::size_t k = 1; k < polygon.size(); ++k) legs += std::sqrt(squared_length(polygon[k] - polygon[k - 1]));
  if (!(legs - chord > 1e-14 * legs)) return chord;  // the length lies between the chord and the sum of the legs
  if (polygon.size() == 3)
    if (const std::optional<double> length = gentle_length(polygon)) return *length;
  // The curve is taken relative to its start: far from the origin, rounding would never let two estimates agree.
  Polygon relative;
  for (std::size_t k = 0; k < polygon.size(); ++k) relative[k] = polygon[k] - polygon[0];
  const auto from_start = std::span<const Point>(relative).first(polygon.size());
  return length_between(from_start, gauss_length(from_start), 1e-10 * legs, 20);
}

}  // namespace pliant
