#include "pliant/mesh/locate.h"

#include <algorithm>
#include <array>

#include "pliant/geometry/invert_map.h"
#include "pliant/geometry/predicates.h"

namespace pliant {
namespace {

constexpr double inside_tolerance = 1e-12;  // of a barycentric coordinate
constexpr int max_attempts = 12;            // elements in which Newton is tried by one walk
constexpr int leaf_size = 4;

std::array<Point, net_size(max_degree)> buffer_for(const Mesh& mesh, TriangleId t) {
  std::array<Point, net_size(max_degree)> net;
  mesh.gather_points(t, net);
  return net;
}

int least_coordinate(const Barycentric& xi) {
  return static_cast<int>(std::min_element(xi.begin(), xi.end()) - xi.begin());
}

/// The triangle that the logical walk ends in: it contains p, or the walk met the outer boundary or went in circles.
TriangleId walk_logical(const Mesh& mesh, const Point& p, TriangleId t) {
  const long limit = 10 + 4L * mesh.triangle_count();
  HalfEdgeId entered = none;
  for (long step = 0; step < limit; ++step) {
    HalfEdgeId leave = none;
    for (int k = 0; k < 3; ++k) {
      // Alternating the first edge breaks the cycles that a fixed order can run into on non-Delaunay meshes.
      const HalfEdgeId h = half_edge(t, static_cast<int>((k + step) % 3));
      if (h == entered) continue;
      if (orient2d(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), p) >= 0) continue;
      if (mesh.twin(h) == none) continue;  // the point may lie round the corner: go on along the boundary
      leave = h;
      break;
    }
    if (leave == none) return t;
    entered = mesh.twin(leave);
    t = triangle_of(entered);
  }
  return t;
}

}  // namespace

std::optional<Location> Locator::walk(const Point& p, TriangleId hint) {
  TriangleId t = walk_logical(mesh_, p, hint);
  const double tolerance = 1e-14 * mesh_.size();
  std::array<TriangleId, max_attempts> visited;
  int tried = 0;
  while (tried < max_attempts) {
    visited[static_cast<std::size_t>(tried++)] = t;
    const auto net = buffer_for(mesh_, t);
    const auto xi = invert_map(mesh_.degree(), {net.data(), static_cast<std::size_t>(mesh_.net_size())}, p, tolerance);
    if (!xi) return std::nullopt;
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return (*xi)[static_cast<std::size_t>(a)] < (*xi)[static_cast<std::size_t>(b)]; });
    if ((*xi)[static_cast<std::size_t>(order[0])] >= -inside_tolerance) return Location{t, *xi};
    TriangleId to = none;
    for (const int c : order) {
      if ((*xi)[static_cast<std::size_t>(c)] >= -inside_tolerance) break;
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
  if (hint == none || hint >= mesh_.triangle_slots() || !mesh_.is_alive(hint)) {
    hint = 0;
    while (!mesh_.is_alive(hint)) ++hint;
  }
  if (auto found = walk(p, hint)) return found;
  return search_tree(p);
}

void Locator::build_tree() {
  order_.clear();
  tree_.clear();
  std::vector<Box> boxes(static_cast<std::size_t>(mesh_.triangle_slots()));
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    if (!mesh_.is_alive(t)) continue;
    order_.push_back(t);
    for (const PointId q : mesh_.net(t)) boxes[static_cast<std::size_t>(t)].extend(mesh_.point(q));
  }
  const double margin = inside_tolerance * mesh_.size();
  tree_.push_back({Box{}, 0, static_cast<int>(order_.size()), true});
  for (std::size_t n = 0; n < tree_.size(); ++n) {  // grows as nodes are split
    const int first = tree_[n].first, last = tree_[n].last;
    Box box;
    for (int k = first; k < last; ++k) {
      const Box& b = boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])];
      box.extend(b.low - Point{margin, margin});
      box.extend(b.high + Point{margin, margin});
    }
    tree_[n].box = box;
    if (last - first <= leaf_size) continue;
    const bool wide = box.high.x - box.low.x > box.high.y - box.low.y;
    const int middle = (first + last) / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](TriangleId a, TriangleId b) {
          const Point ca = boxes[static_cast<std::size_t>(a)].low + boxes[static_cast<std::size_t>(a)].high;
          const Point cb = boxes[static_cast<std::size_t>(b)].low + boxes[static_cast<std::size_t>(b)].high;
          const double va = wide ? ca.x : ca.y, vb = wide ? cb.x : cb.y;
          return va != vb ? va < vb : a < b;
        });
    const int child = static_cast<int>(tree_.size());
    tree_.push_back({Box{}, first, middle, true});
    tree_.push_back({Box{}, middle, last, true});
    tree_[n].leaf = false;
    tree_[n].first = child;
    tree_[n].last = child + 1;
  }
}

std::optional<Location> Locator::search_tree(const Point& p) {
  if (tree_.empty()) build_tree();
  const double tolerance = 1e-14 * mesh_.size();
  std::vector<int> stack{0};
  while (!stack.empty()) {
    const Node& node = tree_[static_cast<std::size_t>(stack.back())];
    stack.pop_back();
    if (!node.box.contains(p)) continue;
    if (!node.leaf) {
      stack.push_back(node.last);
      stack.push_back(node.first);
      continue;
    }
    for (int k = node.first; k < node.last; ++k) {
      const TriangleId t = order_[static_cast<std::size_t>(k)];
      const auto net = buffer_for(mesh_, t);
      const std::span<const Point> points{net.data(), static_cast<std::size_t>(mesh_.net_size())};
      auto xi = invert_map(mesh_.degree(), points, p, tolerance);
      if (!xi || (*xi)[static_cast<std::size_t>(least_coordinate(*xi))] < -inside_tolerance)
        xi = invert_map_by_subdivision(mesh_.degree(), points, p, tolerance);
      if (xi && (*xi)[static_cast<std::size_t>(least_coordinate(*xi))] >= -inside_tolerance) return Location{t, *xi};
    }
  }
  return std::nullopt;
}

}  // namespace pliant
