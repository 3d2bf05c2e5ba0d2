// lib/pliant/mesh/locate.cpp: jump and walk, a tree of boxes when that fails, and a look at the elements around.
#include "pliant/mesh/locate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/hilbert_order.h"

namespace pliant {
namespace {

constexpr double inside_tolerance = 1e-12;  // xi counts as inside if no coordinate is below minus this
constexpr double near_edge = 1e-9;  // a barycentric coordinate below this is near the edge: look at the neighbour too
constexpr int max_attempts = 12;    // a walk tries Newton in at most so many elements
constexpr int max_around = 64;      // around an edge or a vertex at most so many elements are looked at
constexpr long search_steps = 64;   // a search in the tree costs about as much as so many steps of a walk
constexpr long build_steps_per_triangle = 4;  // making the tree costs about as much as so many steps per triangle

double least_of(const Barycentric& xi) { return std::min({xi[0], xi[1], xi[2]}); }

}  // namespace

double Locator::tolerance(const Point& p) const {
  return std::max(1e-14 * mesh_.size(), 4e-15 * std::max(std::fabs(p.x), std::fabs(p.y)));
}

long Locator::most_steps() const {
  return search_steps + static_cast<long>(8 * std::sqrt(static_cast<double>(mesh_.triangle_count())));
}

std::optional<Barycentric> Locator::invert(TriangleId t, const Point& p) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  return invert_map(mesh_.degree(), {net.data(), index(mesh_.net_size())}, p, tolerance(p));
}

/// The same as `invert`, but it is empty only where the element does not contain p, or breaks M3.
std::optional<Barycentric> Locator::search(TriangleId t, const Point& p) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  const ElementSearch search = find_in_element(mesh_.degree(), {net.data(), index(mesh_.net_size())}, p, tolerance(p));
  return search.answer == SearchAnswer::found ? std::optional(search.xi) : std::nullopt;
}

/// The triangle that the logical walk ends in: it contains p, or the walk met the outer boundary or was too long.
TriangleId Locator::walk_logical(const Point& p, TriangleId t, long most_steps) {
  HalfEdgeId entered = none;
  for (long step = 0; step < most_steps; ++step) {
    HalfEdgeId leave = none;
    for (int k = 0; k < 3; ++k) {
      // Alternating the first edge breaks the cycles that a fixed order can run into on non-Delaunay meshes.
      const HalfEdgeId h = half_edge(t, static_cast<int>((k + step) % 3));
      if (h == entered) continue;
      if (orient2d(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)), p) >= 0) continue;
      if (mesh_.twin(h) == none) continue;  // the point may lie round the corner: go on along the boundary
      leave = h;
      break;
    }
    if (leave == none) {
      steps_ += step;
      return t;
    }
    entered = mesh_.twin(leave);
    t = triangle_of(entered);
  }
  steps_ += most_steps;
  return t;
}

std::optional<Location> Locator::walk(const Point& p, TriangleId hint) { return walk(p, hint, most_steps()); }

std::optional<Location> Locator::walk(const Point& p, TriangleId hint, long most_steps) {
  TriangleId t = walk_logical(p, hint, most_steps);
  std::array<TriangleId, max_attempts> visited;
  int tried = 0;
  while (tried < max_attempts) {
    visited[index(tried++)] = t;
    const auto xi = invert(t, p);
    if (!xi) return std::nullopt;
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return (*xi)[index(a)] < (*xi)[index(b)]; });
    if ((*xi)[index(order[0])] >= -inside_tolerance) return Location{t, *xi};
    TriangleId to = none;
    for (const int c : order) {
      if ((*xi)[index(c)] >= -inside_tolerance) break;
      const HalfEdgeId across = mesh_.twin(half_edge(t, (c + 1) % 3));  // opposite corner c
      if (across == none) continue;
      TriangleId* const end = visited.data() + tried;
      if (std::find(visited.data(), end, triangle_of(across)) != end) continue;
      to = triangle_of(across);
      break;
    }
    if (to == none) return std::nullopt;
    t = to;
  }
  return std::nullopt;
}

std::optional<Location> Locator::find(const Point& p, TriangleId hint) {
  if (!is_finite(p) || mesh_.triangle_count() == 0) return std::nullopt;
  auto found = walk_or_search(p, hint);
  if (!found) return std::nullopt;
  found = least_around(p, *found);
  last_ = found->triangle;
  return found;
}

std::optional<Location> Locator::walk_or_search(const Point& p, TriangleId hint) {
  if (is_triangle(hint))
    if (auto found = walk(p, hint, tree_.empty() ? most_steps() : search_steps)) return found;
  if (tree_.empty() && steps_ <= build_steps_per_triangle * mesh_.triangle_count())
    if (auto found = walk(p, nearest_of_some(p), most_steps())) return found;
  return search_tree(p);
}

/// The nearest of n^(1/3) triangles, taken evenly by number (jump and walk: Mücke, Saias, Zhu).
TriangleId Locator::nearest_of_some(const Point& p) {
  const auto some = static_cast<std::int64_t>(std::cbrt(mesh_.triangle_count())) + 1;
  TriangleId nearest = none;
  double least = HUGE_VAL;
  for (std::int64_t k = 0; k < some; ++k) {
    auto t = static_cast<TriangleId>(k * mesh_.triangle_slots() / some);
    while (!mesh_.is_alive(t)) t = t + 1 < mesh_.triangle_slots() ? t + 1 : 0;
    const Vector off = p - mesh_.point(mesh_.corner(t, 0));
    const double far = std::fabs(off.x) + std::fabs(off.y);
    if (nearest == none || far < least) nearest = t, least = far;
  }
  steps_ += some;
  return nearest;
}

std::optional<Location> Locator::search_tree(const Point& p) {
  if (tree_.empty()) tree_.build(mesh_, mesh_.tolerance());
  std::optional<Location> found;
  tree_.visit(p, [&](TriangleId t) {
    const auto xi = search(t, p);
    if (xi) found = Location{t, *xi};
    return xi.has_value();
  });
  return found;
}

/// The element with the least number that contains p, among those that meet in the edge or vertex that p is near. They
/// are reached by crossing the edges near p, and by the half-edges known at a pinched vertex.
Location Locator::least_around(const Point& p, const Location& found) const {
  Location least = found;
  if (least_of(found.xi) > near_edge) return least;
  std::array<Location, max_around> around;
  around[0] = found;
  int known = 1;
  const auto consider = [&](TriangleId t) {
    if (known == max_around || !is_triangle(t)) return;
    if (std::any_of(around.data(), around.data() + known, [t](const Location& l) { return l.triangle == t; })) return;
    auto xi = invert(t, p);
    // Newton may find another xi, beyond the element, that the map takes to p as well.
    if (!xi || least_of(*xi) < -near_edge) xi = search(t, p);
    if (!xi) return;
    around[index(known++)] = {t, *xi};
    if (t < least.triangle && least_of(*xi) >= -inside_tolerance) least = {t, *xi};
  };
  for (int k = 0; k < known; ++k) {
    const Location here = around[index(k)];
    for (int c = 0; c < 3; ++c) {
      const HalfEdgeId across = mesh_.twin(half_edge(here.triangle, (c + 1) % 3));  // opposite corner c
      if (here.xi[index(c)] <= near_edge && across != none) consider(triangle_of(across));
      if (here.xi[index(c)] >= 1 - 2 * near_edge)
        for (const HalfEdgeId h : mesh_.pinched_half_edges(mesh_.corner(here.triangle, c))) consider(triangle_of(h));
    }
  }
  return least;
}

void Locator::find_all(std::span<const Point> points, std::span<std::optional<Location>> found) {
  assert(points.size() == found.size());
  constexpr std::size_t most = std::size_t{1} << 20;
  std::vector<std::uint64_t> order;  // place on Hilbert's curve, and the point's number in the lower 32 bits
  for (std::size_t first = 0; first < points.size(); first += most) {
    const std::size_t count = std::min(most, points.size() - first);
    const std::span<const Point> block = points.subspan(first, count);
    Box box;
    for (const Point& p : block)
      if (is_finite(p)) box.extend(p);
    const HilbertOrder place(box, 16);
    order.clear();
    for (std::size_t k = 0; k < count; ++k) order.push_back(is_finite(block[k]) ? place(block[k]) << 32 | k : k);
    std::sort(order.begin(), order.end());
    for (const std::uint64_t entry : order) {
      const std::size_t k = entry & 0xffffffffu;
      found[first + k] = find(block[k], last_);
    }
  }
}

}  // namespace pliant
