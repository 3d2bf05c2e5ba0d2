// lib/pliant/boundary/arrangement/arrangement_graph.cpp: half-edges around nodes, regions, winding numbers.
#include "pliant/boundary/arrangement/arrangement_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/boundary/arrangement/arrangement_merge.h"
#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/curve_points.h"
#include "pliant/boundary/hull_separation.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

constexpr double clear_angle = 1e-6;  // radians; arcs whose hulls are farther apart are sorted by their chords

class GraphBuilder {
 public:
  GraphBuilder(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArcTolerances& tolerances)
      : network_(network), curves_(curves), tolerances_(tolerances) {}

  ArrangementGraph build(const RegionMeaning& meaning) {
    merge_arcs(network_, curves_, tolerances_, graph_);
    sort_around_nodes();
    trace_regions();
    check_planarity();
    if (graph_.broken.empty()) propagate(meaning);
    return std::move(graph_);
  }

 private:
  // Half-edge 2e runs along edge e, 2e + 1 against it; each has a region on its left.
  const Arc& arc(int half) const { return network_.arcs[index(graph_.edges[index(half / 2)].arc)]; }
  int origin(int half) const { return half % 2 == 0 ? arc(half).from : arc(half).to; }
  static int twin(int half) { return half ^ 1; }
  const Point& node(int n) const { return network_.nodes[index(n)]; }

  // ---- Around the nodes ----

  /// The control points from the half-edge's origin on.
  std::span<const Point> polygon(int half, std::array<Point, max_curve_degree + 1>& reversed) const {
    const auto points = network_.polygon(arc(half));
    if (half % 2 == 0) return points;
    std::reverse_copy(points.begin(), points.end(), reversed.begin());
    return {reversed.data(), points.size()};
  }

  /// In which quarter of all directions a monotone arc leaves, counted counter-clockwise from -x. A quarter includes
  /// its first ray.
  static int quarter(const Vector& d) {
    if (d.x < 0) return d.y > 0 ? 3 : 0;
    if (d.x == 0) return d.y > 0 ? 3 : 1;
    return d.y < 0 ? 1 : 2;
  }

  /// The point of a monotone arc at the distance `radius` from its start, relative to the start.
  static Vector at_radius(std::span<const Point> polygon, double radius) {
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
      const double middle = low + (high - low) / 2;
      (distance(bezier_point(polygon, middle), polygon.front()) < radius ? low : high) = middle;
    }
    return bezier_point(polygon, high) - polygon.front();
  }

  /// Does `a` come before `b`, counter-clockwise from -x about their common origin? Arcs stay in one quarter and meet
  /// at nodes only, so their order is that of the points where they cross any circle about the node.
  bool comes_before(int a, int b) const {
    std::array<Point, max_curve_degree + 1> room_a, room_b;
    const auto p = polygon(a, room_a), q = polygon(b, room_b);
    Vector to_a = p.back() - p.front(), to_b = q.back() - q.front();
    const int quarter_a = quarter(to_a), quarter_b = quarter(to_b);
    if (quarter_a != quarter_b) return quarter_a < quarter_b;
    if (!cones_apart(p, q, clear_angle)) {
      const double radius = 0.6 * std::min(length(to_a), length(to_b));
      to_a = at_radius(p, radius);
      to_b = at_radius(q, radius);
    }
    const double turn = cross(to_a, to_b);
    return turn != 0 ? turn > 0 : a < b;
  }

  void sort_around_nodes() {
    around_.resize(network_.nodes.size());
    for (int half = 0; half < 2 * static_cast<int>(graph_.edges.size()); ++half)
      around_[index(origin(half))].push_back(half);
    place_.resize(2 * graph_.edges.size());
    for (std::vector<int>& halves : around_) {
      // This is an insertion sort because comparisons that rounding makes inconsistent do it no harm but a wrong order.
      for (std::size_t i = 1; i < halves.size(); ++i)
        for (std::size_t j = i; j > 0 && comes_before(halves[j], halves[j - 1]); --j)
          std::swap(halves[j], halves[j - 1]);
      for (std::size_t i = 0; i < halves.size(); ++i) place_[index(halves[i])] = static_cast<int>(i);
      graph_.crowded_nodes += halves.size() > 2;
    }
  }

  // ---- Regions ----

  /// The half-edge that follows along the region on the left: the next one, clockwise, after the twin.
  int next(int half) const {
    const int back = twin(half);
    const std::vector<int>& halves = around_[index(origin(back))];
    const int place = place_[index(back)];
    return halves[index(place == 0 ? static_cast<int>(halves.size()) - 1 : place - 1)];
  }

  void trace_regions() {
    region_.assign(2 * graph_.edges.size(), -1);
    for (int start = 0; start < static_cast<int>(region_.size()); ++start) {
      if (region_[index(start)] >= 0) continue;
      for (int half = start; region_[index(half)] < 0; half = next(half)) region_[index(half)] = regions_;
      ++regions_;
    }
  }

  /// Checks Euler's formula for each component, and finds the component's leftmost node.
  void check_planarity() {
    component_.assign(network_.nodes.size(), -1);
    std::vector<int> stack;
    for (std::size_t start = 0; start < around_.size(); ++start) {
      if (component_[start] >= 0 || around_[start].empty()) continue;
      const int name = static_cast<int>(leftmost_.size());
      int leftmost = static_cast<int>(start), half_edges = 0, nodes = 0;
      std::vector<int> faces;
      component_[start] = name;
      stack.push_back(static_cast<int>(start));
      while (!stack.empty()) {
        const int n = stack.back();
        stack.pop_back();
        ++nodes;
        if (std::array{node(n).x, node(n).y} < std::array{node(leftmost).x, node(leftmost).y}) leftmost = n;
        for (const int half : around_[index(n)]) {
          ++half_edges;
          faces.push_back(region_[index(half)]);
          const int other = origin(twin(half));
          if (component_[index(other)] >= 0) continue;
          component_[index(other)] = name;
          stack.push_back(other);
        }
      }
      std::sort(faces.begin(), faces.end());
      const auto count = std::unique(faces.begin(), faces.end()) - faces.begin();
      if (nodes - half_edges / 2 + static_cast<int>(count) != 2) graph_.broken.push_back(leftmost);
      leftmost_.push_back(leftmost);
    }
    graph_.regions = regions_ - static_cast<long>(leftmost_.size());
  }

  /// The winding numbers at the leftmost node of each component, with respect to the other components.
  std::vector<Winding> windings_from_outside() const {
    std::vector<Winding> winding(leftmost_.size());
    if (leftmost_.size() < 2) return winding;
    Box all;
    for (const Point& p : network_.nodes) all.extend(p);
    std::vector<Box> boxes(graph_.edges.size());
    for (std::size_t e = 0; e < boxes.size(); ++e)
      for (const Point& p : network_.polygon(arc(static_cast<int>(2 * e)))) boxes[e].extend(p);
    for (const int n : leftmost_) {
      Box ray;
      ray.extend(node(n));
      ray.extend({all.low.x, node(n).y});
      boxes.push_back(ray);
    }
    const int edges = static_cast<int>(graph_.edges.size());
    visit_overlapping_pairs(boxes, [&](int e, int ray) {
      if (e >= edges || ray < edges) return true;
      const int c = ray - edges, n = leftmost_[index(c)];
      if (component_[index(arc(2 * e).from)] != c)
        add_winding(winding[index(c)], graph_.edges[index(e)].jump, crossing(network_.polygon(arc(2 * e)), node(n)));
      return true;
    });
    return winding;
  }

  /// How the arc crosses the ray from p to -x: -1 upwards (p lies on its right), 1 downwards, 0 not at all.
  static int crossing(std::span<const Point> polygon, const Point& p) {
    const bool from_above = polygon.front().y > p.y, to_above = polygon.back().y > p.y;
    if (from_above == to_above) return 0;
    const auto [least, greatest] =
        std::minmax_element(polygon.begin(), polygon.end(), [](const Point& q, const Point& r) { return q.x < r.x; });
    if (least->x >= p.x) return 0;
    if (greatest->x < p.x) return from_above ? 1 : -1;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      ((bezier_point(polygon, middle).y > p.y) == from_above ? low : high) = middle;
    }
    return bezier_point(polygon, low).x < p.x ? (from_above ? 1 : -1) : 0;
  }

  /// Finds the winding numbers of all regions, from the outside of each component inwards, and from them the faces.
  void propagate(const RegionMeaning& meaning) {
    std::vector<Winding> winding(index(regions_));
    std::vector<bool> known(index(regions_), false);
    std::vector<std::vector<int>> halves_of(index(regions_));
    for (std::size_t half = 0; half < region_.size(); ++half)
      halves_of[index(region_[half])].push_back(static_cast<int>(half));
    const std::vector<Winding> from_outside = windings_from_outside();
    std::vector<int> stack;
    for (std::size_t c = 0; c < leftmost_.size(); ++c) {
      // At the leftmost node the direction -x is after the last half-edge and before the first.
      const int outer = region_[index(around_[index(leftmost_[c])].back())];
      winding[index(outer)] = from_outside[c];
      known[index(outer)] = true;
      stack.push_back(outer);
    }
    while (!stack.empty()) {
      const int here = stack.back();
      stack.pop_back();
      for (const int half : halves_of[index(here)]) {
        const int there = region_[index(twin(half))];
        Winding beyond = winding[index(here)];
        add_winding(beyond, graph_.edges[index(half / 2)].jump, half % 2 == 0 ? -1 : 1);
        if (!known[index(there)]) {
          known[index(there)] = true;
          winding[index(there)] = std::move(beyond);
          stack.push_back(there);
        } else if (winding[index(there)] != beyond) {
          graph_.broken.push_back(origin(half));
        }
      }
    }
    std::vector<int> owners(index(regions_));
    std::transform(winding.begin(), winding.end(), owners.begin(), meaning.owner);
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      GraphEdge& edge = graph_.edges[e];
      edge.left = owners[index(region_[2 * e])];
      edge.right = owners[index(region_[2 * e + 1])];
      const bool is_seen = std::any_of(edge.lines.begin(), edge.lines.end(), [&](int line) {
        const auto shows = [&](int side) { return meaning.shows(line, winding[index(side)], owners[index(side)]); };
        return shows(region_[2 * e]) || shows(region_[2 * e + 1]);
      });
      edge.is_drawn = is_seen && (edge.left != outside || edge.right != outside);
      graph_.bare_lines += is_seen && !edge.is_drawn ? 1 : 0;
    }
  }

  const ArcNetwork& network_;
  std::span<const SidedCurve> curves_;
  ArcTolerances tolerances_;
  ArrangementGraph graph_;
  std::vector<std::vector<int>> around_;  // half-edges that leave a node, counter-clockwise from -x
  std::vector<int> place_;                // the index of each half-edge among those around its origin
  std::vector<int> region_;               // the region on the left of each half-edge
  int regions_ = 0;
  std::vector<int> component_;  // the component of each node
  std::vector<int> leftmost_;   // the leftmost node of each component
};

}  // namespace

ArrangementGraph build_graph(const ArcNetwork& network, std::span<const SidedCurve> curves,
                             const ArcTolerances& tolerances, const RegionMeaning& meaning) {
  return GraphBuilder(network, curves, tolerances).build(meaning);
}

}  // namespace pliant
