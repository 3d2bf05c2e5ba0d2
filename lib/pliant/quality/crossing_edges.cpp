#include "pliant/quality/crossing_edges.h"  // lib/pliant/quality/crossing_edges.cpp: a tree of boxes, then subdivision

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }
constexpr int most_visits = 20000;  // of pieces of one pair of edges

/// A part of an edge. Ends in the interior of the edge belong to no vertex.
struct Piece {
  int degree;
  std::array<Point, max_degree + 1> points;
  PointId first, last;

  std::span<const Point> polygon() const { return std::span(points).first(at(degree + 1)); }
  const Point& start() const { return points[0]; }
  const Point& end() const { return points[at(degree)]; }
  Box box() const {
    Box result;
    for (const Point& p : polygon()) result.extend(p);
    return result;
  }
};

std::pair<Piece, Piece> halves(const Piece& whole) {
  std::pair<Piece, Piece> result{whole, whole};
  auto& [left, right] = result;
  left.last = right.first = none;
  for (int level = 1; level <= whole.degree; ++level) {
    for (int k = 0; k + level <= whole.degree; ++k)
      right.points[at(k)] = 0.5 * (right.points[at(k)] + right.points[at(k + 1)]);
    left.points[at(level)] = right.points[0];
  }
  return result;
}

/// The range of cross(direction, p - origin) over a polygon.
std::pair<double, double> extent(const Vector& direction, const Point& origin, std::span<const Point> polygon) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Point& p : polygon) {
    const double value = cross(direction, p - origin);
    low = std::min(low, value), high = std::max(high, value);
  }
  return {low, high};
}

/// b lies outside the strip along the chord of a that holds a.
bool is_beside(const Piece& a, const Piece& b) {
  const Vector chord = a.end() - a.start();
  const auto [low, high] = extent(chord, a.start(), a.polygon());
  const auto [least, greatest] = extent(chord, a.start(), b.polygon());
  return least > high || greatest < low;
}

/// The ends of b lie on different sides of that strip.
bool spans_strip(const Piece& a, const Piece& b) {
  const Vector chord = a.end() - a.start();
  const auto [low, high] = extent(chord, a.start(), a.polygon());
  const double first = cross(chord, b.start() - a.start()), last = cross(chord, b.end() - a.start());
  return (first < low && last > high) || (first > high && last < low);
}

/// Two pieces with a common vertex have nothing else in common if a line through it parts their control points.
bool parts_at(const Point& vertex, const Piece& a, const Point& a_far, const Piece& b, const Point& b_far) {
  const Vector u = a_far - vertex, v = b_far - vertex;
  const double u_length = length(u), v_length = length(v);
  if (u_length == 0 || v_length == 0) return false;
  const Vector normal = u / u_length - v / v_length;
  for (const Point& p : a.polygon())
    if (p != vertex && dot(p - vertex, normal) <= 0) return false;
  for (const Point& p : b.polygon())
    if (p != vertex && dot(p - vertex, normal) >= 0) return false;
  return true;
}

class PairTest {
 public:
  explicit PairTest(double smallest) : smallest_(smallest) {}

  bool meet(const Piece& a, const Piece& b) {
    visits_ = 0;
    has_common_vertex_ = a.first == b.first || a.first == b.last || a.last == b.first || a.last == b.last;
    return visit(a, b);
  }

 private:
  bool visit(const Piece& a, const Piece& b) {
    const Box a_box = a.box(), b_box = b.box();
    if (!a_box.overlaps(b_box)) return false;
    int common = 0;
    bool is_parted = false;
    for (const bool a_first : {true, false}) {
      for (const bool b_first : {true, false}) {
        const PointId id = a_first ? a.first : a.last;
        if (id == none || id != (b_first ? b.first : b.last)) continue;
        ++common;
        is_parted =
            parts_at(a_first ? a.start() : a.end(), a, a_first ? a.end() : a.start(), b, b_first ? b.end() : b.start());
      }
    }
    if (common == 1 && is_parted) return false;
    if (common == 0 && (is_beside(a, b) || is_beside(b, a))) return false;
    if (spans_strip(a, b) && spans_strip(b, a)) return true;
    // What cannot be parted touches; next to a common vertex that says nothing.
    const double a_size = a_box.size(), b_size = b_box.size();
    if (++visits_ > most_visits || (a_size < smallest_ && b_size < smallest_)) return !has_common_vertex_;
    if (a_size >= b_size) {
      const auto [left, right] = halves(a);
      return visit(left, b) || visit(right, b);
    }
    const auto [left, right] = halves(b);
    return visit(a, left) || visit(a, right);
  }

  double smallest_;
  int visits_ = 0;
  bool has_common_vertex_ = false;
};

/// Pairs of boxes that overlap, by a binary tree over the edges.
class PairCounter {
 public:
  explicit PairCounter(const EdgeCurves& edges) : edges_(edges), order_(edges.ends.size()) {
    Box all;
    for (std::size_t e = 0; e < order_.size(); ++e) {
      Box& box = boxes_.emplace_back();
      for (const Point& p : edges.polygon(e)) box.extend(p);
      all.extend(box.low), all.extend(box.high);
    }
    smallest_ = 1e-12 * all.size();
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!order_.empty()) build(0, order_.size());
  }
  std::int64_t run() {
    if (!nodes_.empty()) within(0);
    return count_;
  }

 private:
  struct Node {
    Box box;
    std::size_t first, last;
    int left = -1, right = -1;
  };

  int build(std::size_t first, std::size_t last) {
    const int n = static_cast<int>(nodes_.size());
    Node node{{}, first, last};
    for (std::size_t k = first; k < last; ++k) {
      node.box.extend(boxes_[order_[k]].low);
      node.box.extend(boxes_[order_[k]].high);
    }
    nodes_.push_back(node);
    if (last - first == 1) return n;
    const Vector extent = node.box.high - node.box.low;
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = order_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last), [&](std::size_t a, std::size_t b) {
                       const Point p = boxes_[a].low + boxes_[a].high, q = boxes_[b].low + boxes_[b].high;
                       return extent.x >= extent.y ? p.x < q.x : p.y < q.y;
                     });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[at(n)].left = left;
    nodes_[at(n)].right = right;
    return n;
  }

  void within(int n) {
    const Node& node = nodes_[at(n)];
    if (node.left < 0) return;
    within(node.left);
    within(node.right);
    between(node.left, node.right);
  }

  void between(int m, int n) {
    const Node &a = nodes_[at(m)], &b = nodes_[at(n)];
    if (!a.box.overlaps(b.box)) return;
    if (a.left < 0 && b.left < 0) {
      count_ += PairTest(smallest_).meet(piece(order_[a.first]), piece(order_[b.first])) ? 1 : 0;
    } else if (b.left < 0 || (a.left >= 0 && a.last - a.first >= b.last - b.first)) {
      between(a.left, n);
      between(a.right, n);
    } else {
      between(m, b.left);
      between(m, b.right);
    }
  }

  Piece piece(std::size_t edge) const {
    Piece result{edges_.degree, {}, edges_.ends[edge].first, edges_.ends[edge].second};
    std::ranges::copy(edges_.polygon(edge), result.points.begin());
    return result;
  }

  const EdgeCurves& edges_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
  double smallest_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace

std::int64_t count_crossings(const EdgeCurves& edges) { return PairCounter(edges).run(); }

}  // namespace pliant
