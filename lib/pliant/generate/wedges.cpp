// lib/pliant/generate/wedges.cpp: compares the tangents at each vertex; finds places by their distance from a corner.
#include "pliant/generate/wedges.h"

#include <algorithm>
#include <cmath>

#include "pliant/generate/tame_spans.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double same_radius = 1e-12;  // relative: ends whose distances from a corner differ by less are level
constexpr double few_ulps = 1e-14;     // the same in coordinates: the last bit of a parameter moves a point by as much
constexpr double most_tilt =
    0.2;  // ends are also level if their distances differ by less than this share of their distance from each other

}  // namespace

Wedges::Wedges(const BoundaryComplex& boundary, const BoundarySpans& spans) : spans_(spans) {
  const auto vertices = static_cast<int>(boundary.vertices.size());
  std::vector<std::vector<std::pair<int, Vector>>> leaving(index(vertices));
  for (std::size_t i = 0; i < spans_.size(); ++i)
    for (const int node : {spans_[i].from, spans_[i].to})
      if (node < vertices)
        leaving[index(node)].emplace_back(spans_[i].curve, tangent_at_end(spans_.polygon(i), node == spans_[i].from));
  for (int node = 0; node < vertices; ++node)
    for (const auto& [a, along_a] : leaving[index(node)])
      for (const auto& [b, along_b] : leaving[index(node)]) {
        if (a >= b || !is_narrow(along_a, along_b)) continue;
        corners_[{a, b}].push_back(node);
        corners_of_[a].push_back(node);
        corners_of_[b].push_back(node);
      }
  for (const Point& node : spans_.nodes())
    rounding_ = std::max({rounding_, few_ulps * std::fabs(node.x), few_ulps * std::fabs(node.y)});
}

int Wedges::nearest(std::size_t i, const std::vector<int>& corners) const {
  const Box box = spans_.box(i);
  const Point middle = 0.5 * (box.low + box.high);
  const auto away = [&](int node) { return distance(spans_.nodes()[index(node)], middle); };
  return *std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return away(a) < away(b); });
}

int Wedges::corner_between(std::size_t i, std::size_t j) const {
  const auto found = corners_.find(std::minmax(spans_[i].curve, spans_[j].curve));
  return found == corners_.end() ? -1 : nearest(i, found->second);
}

std::optional<std::array<Wedges::End, 2>> Wedges::ends(std::size_t i, int corner) const {
  const std::span<const Point> polygon = spans_.polygon(i);
  const Point& from = spans_.nodes()[index(corner)];
  std::array<End, 2> both{End{distance(polygon.front(), from), polygon.front()},
                          End{distance(polygon.back(), from), polygon.back()}};
  const double sign = both[1].radius > both[0].radius ? 1 : -1;
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    const Vector leg = sign * (polygon[k + 1] - polygon[k]);
    for (const Point& p : {polygon[k], polygon[k + 1]})
      if (!(p == from) && !(dot(leg, p - from) > 0)) return std::nullopt;
  }
  if (sign < 0) std::swap(both[0], both[1]);
  return both;
}

bool Wedges::are_level(const End& a, const End& b) const {
  const double off = std::fabs(a.radius - b.radius), least = same_radius * std::max(a.radius, b.radius) + rounding_;
  return off <= std::max(least, most_tilt * distance(a.place, b.place));
}

double Wedges::place_at(std::size_t i, int corner, double radius) const {
  const std::span<const Point> polygon = spans_.polygon(i);
  const Point& from = spans_.nodes()[index(corner)];
  const bool leads_away = distance(polygon.front(), from) < distance(polygon.back(), from);
  std::vector<double> flat;
  for (const Point& b : polygon) flat.insert(flat.end(), {b.x, b.y});
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double s = (low + high) / 2;
    std::array<double, 2> value;
    evaluate_polygon(static_cast<int>(polygon.size()) - 1, 2, flat, s, value);
    ((distance(from, {value[0], value[1]}) < radius) == leads_away ? low : high) = s;
  }
  return (low + high) / 2;
}

double Wedges::middle_of(std::size_t i) const {
  const auto found = corners_of_.find(spans_[i].curve);
  if (found == corners_of_.end()) return 0.5;
  const int corner = nearest(i, found->second);
  const auto both = ends(i, corner);
  return both ? place_at(i, corner, ((*both)[0].radius + (*both)[1].radius) / 2) : 0.5;
}

}  // namespace pliant
