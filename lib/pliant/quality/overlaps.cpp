// lib/pliant/quality/overlaps.cpp: crossings, and winding numbers by horizontal rays.
#include "pliant/quality/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/quality/crossing_edges.h"
#include "pliant/quality/edge_curves.h"
#include "pliant/quality/element/strips.h"

namespace pliant {
namespace {

using Polygon = std::array<Point, max_degree + 1>;

/// How often the curve crosses the horizontal ray from `from` to the right: upward crossings less downward ones. A
/// point at the height of the ray counts as below it, so that curves which share an end there agree.
int crossings_to_the_right(std::span<const Point> polygon, const Point& from, int depth = 0) {
  Box box;
  for (const Point& p : polygon) box.extend(p);
  if (box.low.y > from.y || box.high.y <= from.y || box.high.x < from.x) return 0;
  constexpr int greatest_depth = 60;
  if (box.low.x > from.x || depth == greatest_depth)
    return (polygon.back().y > from.y ? 1 : 0) - (polygon.front().y > from.y ? 1 : 0);
  Polygon left, right;
  const std::size_t n = polygon.size();
  std::ranges::copy(polygon, right.begin());
  left[0] = right[0];
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t k = 0; k + level < n; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
    left[level] = right[0];
  }
  return crossings_to_the_right(std::span<const Point>(left).first(n), from, depth + 1) +
         crossings_to_the_right(std::span<const Point>(right).first(n), from, depth + 1);
}

class OverlapSearch {
 public:
  OverlapSearch(const MeshData& data, const HalfEdges& half_edges, int most)
      : data_(data), half_edges_(half_edges), most_(index(std::max(most, 0))) {}

  Overlaps run() {
    for (const HalfEdgeId h : data_.half_edges())
      if (half_edges_.twin(h) == none) outer_.push_back(h);
    find_crossing_edges();
    find_covered_loops();
    return std::move(result_);
  }

 private:
  void add(const OverlapPlace& place) {
    ++result_.count;
    if (result_.places.size() < most_) result_.places.push_back(place);
  }

  void find_crossing_edges() {
    EdgeCurves edges;
    edges.degree = data_.degree;
    std::vector<HalfEdgeId> half_edges;
    const auto add_edge = [&](std::span<const PointId> ids, HalfEdgeId h) {
      edges.ends.emplace_back(ids.front(), ids.back());
      for (const PointId p : ids) edges.points.push_back(data_.points[index(p)]);
      half_edges.push_back(h);
    };
    std::vector<HalfEdgeId> listed;
    for (const ConstrainedEdge& edge : data_.constrained_edges) {
      const auto [forward, backward] = half_edges_.along(edge.points);
      listed.insert(listed.end(), {forward, backward});
      add_edge(edge.points, forward != none ? forward : backward);
    }
    std::ranges::sort(listed);
    for (const HalfEdgeId h : outer_)
      if (!std::ranges::binary_search(listed, h)) add_edge(edge_ids(data_, h), h);
    const auto triangle = [](HalfEdgeId h) { return h == none ? TriangleId{none} : triangle_of(h); };
    for (const Crossing& crossing : find_crossings(edges)) {
      const HalfEdgeId a = half_edges[crossing.first], b = half_edges[crossing.second];
      add({triangle(a), triangle(b), crossing.place});
      crossing_.insert(crossing_.end(), {a, b});
    }
    std::ranges::sort(crossing_);
  }

  /// The boundary half-edge that follows h, found by going around the end of h; none if the document is no manifold
  /// there.
  HalfEdgeId next_on_loop(HalfEdgeId h) {
    HalfEdgeId g = next(h);
    for (; budget_ > 0; --budget_) {
      if (half_edges_.twin(g) == none) return g;
      g = next(half_edges_.twin(g));
    }
    return none;
  }

  /// A point of the element beside the middle of the half-edge, just inside.
  Point point_beside(HalfEdgeId h) const {
    constexpr double inside = 0x1p-10;
    Barycentric xi;
    xi[index(edge_of(h))] = xi[index(edge_of(next(h)))] = 0.5 - inside / 2;
    xi[index(edge_of(previous(h)))] = inside;
    std::array<double, net_size(max_degree)> basis;
    bernstein_basis(data_.degree, xi, basis);
    Point sum;
    const std::size_t n = index(net_size(data_.degree));
    for (std::size_t k = 0; k < n; ++k)
      sum += basis[k] * data_.points[index(data_.triangles[index(triangle_of(h)) * n + k])];
    return sum;
  }

  void find_covered_loops() {
    const std::size_t n = index(data_.degree) + 1;
    std::vector<Point> polygons(outer_.size() * n);
    std::vector<Box> boxes(outer_.size());
    for (std::size_t k = 0; k < outer_.size(); ++k) {
      const std::span<Point> polygon = std::span(polygons).subspan(k * n, n);
      edge_polygon(data_, outer_[k], polygon);
      for (const Point& p : polygon) boxes[k].extend(p);
    }
    const Strips strips(boxes);
    std::map<HalfEdgeId, bool> is_passed;  // for each outer half-edge: whether its loop is done
    for (const HalfEdgeId h : outer_) is_passed.emplace_hint(is_passed.end(), h, false);
    budget_ = 3 * std::ssize(data_.triangle_faces);
    for (const HalfEdgeId start : outer_) {
      if (is_passed[start]) continue;
      bool crosses = false;  // if so, the winding number changes along the loop
      for (HalfEdgeId h = start; h != none && !is_passed[h]; h = next_on_loop(h)) {
        is_passed[h] = true;
        crosses = crosses || std::ranges::binary_search(crossing_, h);
      }
      if (crosses) continue;
      const Point place = point_beside(start);
      int cover = 0;
      for (const std::size_t k : strips.at(place.y))
        cover += crossings_to_the_right(std::span<const Point>(polygons).subspan(k * n, n), place);
      if (cover != 1) add({triangle_of(start), none, place});
    }
  }

  const MeshData& data_;
  const HalfEdges& half_edges_;
  std::size_t most_;
  std::vector<HalfEdgeId> outer_;     // half-edges without a twin, ascending
  std::vector<HalfEdgeId> crossing_;  // half-edges of edges that cross others, sorted
  std::int64_t budget_ = 0;           // steps around vertices that are left: around a non-manifold they may never end
  Overlaps result_;
};

}  // namespace

Overlaps find_overlaps(const MeshData& data, const HalfEdges& half_edges, int most) {
  return OverlapSearch(data, half_edges, most).run();
}

}  // namespace pliant
