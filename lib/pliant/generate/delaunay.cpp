// lib/pliant/generate/delaunay.cpp: inserts the points in rounds, each along a Hilbert curve.
#include "pliant/generate/delaunay.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/generate/triangulate_boundary.h"
#include "pliant/geometry/predicates.h"

namespace pliant {
namespace {

/// The place of a cell along the Hilbert curve over a grid of 2^16 x 2^16 cells.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t s = 1U << 15; s > 0; s >>= 1) {
    const std::uint32_t right = (x & s) != 0, upper = (y & s) != 0;
    index = 4 * index + ((3 * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

/// Mixes the bits of n. It decides the round in which a point is inserted, which must not depend on where the point
/// lies.
std::uint64_t scatter(std::uint64_t n) {
  n = (n + 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebULL;
  return n ^ (n >> 31);
}

/// Does p lie strictly between a and b? Requires that it lies on their line.
bool is_between(const Point& a, const Point& b, const Point& p) {
  if (a.x != b.x) return (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x);
  return (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
}

}  // namespace

Delaunay::Delaunay(std::span<const Point> points) : points_(points), leaving_(points.size(), -1) {
  const std::size_t triangles = 2 * points.size() + 8;
  origin_.reserve(3 * triangles);
  twin_.reserve(3 * triangles);
  constrained_.reserve(3 * triangles);
  mark_.reserve(triangles);
  fan_.resize(points.size() + 1);
  std::vector<int> order = insertion_order();
  if (!make_first_triangle(order)) return;
  for (std::size_t i = 3; i < order.size(); ++i) insert(order[i]);
}

std::vector<int> Delaunay::insertion_order() const {
  Box box;
  for (const Point& p : points_) box.extend(p);
  const Vector extent = box.high - box.low;
  const double side = std::max({extent.x, extent.y, 1e-300});
  const auto cell = [side](double offset) { return static_cast<std::uint32_t>(65535 * (offset / side)); };
  std::vector<std::pair<std::uint64_t, int>> keys(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    // Half of the points are inserted in the last round, half of the others in the round before, and so on.
    std::uint64_t round = 31;
    for (std::uint64_t bits = scatter(i); (bits & 1) != 0 && round > 0; bits >>= 1) --round;
    const Vector d = points_[i] - box.low;
    keys[i] = {(round << 32) | hilbert_index(cell(d.x), cell(d.y)), static_cast<int>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

/// Brings three points that are not in line to the front, and makes a triangle of them; false if all lie in line.
bool Delaunay::make_first_triangle(std::vector<int>& order) {
  if (order.size() < 3) return false;
  const Point &a = point(order[0]), &b = point(order[1]);
  if (a == b) refuse(order[0], order[1], "are the same point", -1, -1);
  const auto third = std::find_if(order.begin() + 2, order.end(), [&](int v) { return orient2d(a, b, point(v)) != 0; });
  if (third == order.end()) return false;
  std::rotate(order.begin() + 2, third, third + 1);
  if (orient2d(a, b, point(order[2])) < 0) std::swap(order[0], order[1]);
  const int t = add_triangle(order[0], order[1], order[2]);
  std::array<int, 3> ghosts;
  for (int e = 0; e < 3; ++e) {
    ghosts[static_cast<std::size_t>(e)] = add_triangle(target(3 * t + e), origin(3 * t + e), infinite);
    link(3 * t + e, 3 * ghosts[static_cast<std::size_t>(e)]);
  }
  for (std::size_t e = 0; e < 3; ++e)  // ghost e is (target, origin, infinite); ghost e + 1 follows around its target
    link(3 * ghosts[e] + 2, 3 * ghosts[(e + 1) % 3] + 1);
  return true;
}

int Delaunay::add_triangle(int a, int b, int c) {
  const int t = static_cast<int>(mark_.size());
  mark_.push_back(0);
  origin_.resize(origin_.size() + 3);
  twin_.resize(twin_.size() + 3, -1);
  constrained_.resize(constrained_.size() + 3, 0);
  set_triangle(t, a, b, c);
  return t;
}

void Delaunay::set_triangle(int t, int a, int b, int c) {
  int h = 3 * t;
  for (const int v : {a, b, c}) {
    origin_[static_cast<std::size_t>(h)] = v;
    if (v != infinite) leaving_[static_cast<std::size_t>(v)] = h;
    ++h;
  }
}

void Delaunay::link(int h, int g) {
  twin_[static_cast<std::size_t>(h)] = g;
  twin_[static_cast<std::size_t>(g)] = h;
}

/// The edge of the hull that a ghost triangle lies beyond, as seen from outside; -1 for other triangles.
int Delaunay::ghost_edge(int t) const {
  for (int h = 3 * t; h < 3 * t + 3; ++h)
    if (origin(h) == infinite) return next(h);
  return -1;
}

/// The triangle that contains point v, or the ghost beyond the hull if v lies there.
int Delaunay::locate(int v) const {
  const Point& p = point(v);
  int entered = 3 * recent_;
  for (int h = entered;;) {
    if (ghost_edge(h / 3) >= 0) return h / 3;
    bool moved = false;
    for (int e = 0; e < 3 && !moved; ++e, h = next(h)) {
      if (h == entered && e == 0 && entered != 3 * recent_) continue;  // known to lie on the inner side
      if (orient2d(point(origin(h)), point(target(h)), p) < 0) {
        h = entered = twin(h);
        moved = true;
        break;
      }
    }
    if (moved) continue;
    for (int g = 3 * (h / 3); g < 3 * (h / 3) + 3; ++g)
      if (point(origin(g)) == p) refuse(origin(g), v, "are the same point", -1, -1);
    return h / 3;
  }
}

bool Delaunay::conflicts(int t, const Point& p) const {
  const int h = ghost_edge(t);
  if (h < 0) return in_circle(point(origin(3 * t)), point(origin(3 * t + 1)), point(origin(3 * t + 2)), p) > 0;
  const Point &a = point(origin(h)), &b = point(target(h));
  const int side = orient2d(a, b, p);
  return side > 0 || (side == 0 && is_between(a, b, p));
}

/// Replaces the triangles whose circumcircle contains point v, or that are ghosts of hull edges it lies beyond, by a
/// fan around v.
void Delaunay::insert(int v) {
  const Point& p = point(v);
  ++marker_;
  cavity_.clear();
  rim_.clear();
  cavity_.push_back(locate(v));
  mark_[static_cast<std::size_t>(cavity_[0])] = marker_;
  for (std::size_t i = 0; i < cavity_.size(); ++i)
    for (int h = 3 * cavity_[i]; h < 3 * cavity_[i] + 3; ++h) {
      const int t = twin(h) / 3;
      if (mark_[static_cast<std::size_t>(t)] == marker_) continue;
      if (conflicts(t, p)) {
        mark_[static_cast<std::size_t>(t)] = marker_;
        cavity_.push_back(t);
      } else {
        rim_.push_back({origin(h), target(h), twin(h)});
      }
    }
  // The rim has two edges more than the cavity has triangles.
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    int t;
    if (i < cavity_.size()) {
      t = cavity_[i];
      set_triangle(t, rim_[i].from, rim_[i].to, v);
    } else {
      t = add_triangle(rim_[i].from, rim_[i].to, v);
    }
    link(3 * t, rim_[i].beyond);
    fan_[static_cast<std::size_t>(rim_[i].from + 1)] = t;
    if (rim_[i].from != infinite && rim_[i].to != infinite) recent_ = t;
  }
  for (const RimEdge& edge : rim_) {
    const int t = fan_[static_cast<std::size_t>(edge.from + 1)],
              following = fan_[static_cast<std::size_t>(edge.to + 1)];
    link(3 * t + 1, 3 * following + 2);
  }
}

std::vector<std::array<int, 3>> Delaunay::triangles() const {
  std::vector<std::array<int, 3>> result;
  const int count = static_cast<int>(mark_.size());
  result.reserve(static_cast<std::size_t>(count));
  for (int t = 0; t < count; ++t)
    if (ghost_edge(t) < 0) result.push_back({origin(3 * t), origin(3 * t + 1), origin(3 * t + 2)});
  return result;
}

void Delaunay::refuse(int a, int b, const char* how, int c, int d) const {
  const auto name = [this](int v) { return std::to_string(v) + " " + describe_point(point(v)); };
  std::string text = "points " + name(a) + " and " + name(b) + " " + how;
  std::vector<int> others;
  if (c >= 0) others.push_back(c), text += " " + name(c);
  if (d >= 0) others.push_back(d), text += " to " + name(d);
  throw TriangulationError(text, {a, b}, how, std::move(others));
}

}  // namespace pliant
