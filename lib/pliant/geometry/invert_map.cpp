// lib/pliant/geometry/invert_map.cpp: Newton, and bisection where it fails.
#include "pliant/geometry/invert_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/validity/bisect_net.h"

namespace pliant {
namespace {

/// The map chi of an element, relative to an origin. With the point sought as the origin, the rounding of large
/// coordinates costs no digits near that point, wherever the element lies.
class Map {
 public:
  Map(int degree, std::span<const Point> net, const Point& origin = {}) : degree_(degree) {
    assert(1 <= degree && degree <= max_degree && net.size() >= static_cast<std::size_t>(net_size(degree)));
    for (std::size_t n = 0; n < static_cast<std::size_t>(net_size(degree)); ++n) {
      rows_[2 * n] = net[n].x - origin.x;
      rows_[2 * n + 1] = net[n].y - origin.y;
    }
  }

  struct Derivatives {
    Point value;
    Vector along_2, along_3;
  };
  Derivatives operator()(const Barycentric& xi) const {
    std::array<double, 2> value;
    std::array<double, 2> along_2;
    std::array<double, 2> along_3;
    evaluate_net(degree_, 2, rows_, xi, value, along_2, along_3);
    return {{value[0], value[1]}, {along_2[0], along_2[1]}, {along_3[0], along_3[1]}};
  }

  int degree() const { return degree_; }
  std::span<const double> rows() const {
    return std::span(rows_).first(static_cast<std::size_t>(2 * net_size(degree_)));
  }

 private:
  int degree_;
  std::array<double, 2 * net_size(max_degree)> rows_;
};

Barycentric straight_coordinates(std::span<const Point> net, const Point& p) {
  const Vector along_2 = net[1] - net[0];
  const Vector along_3 = net[2] - net[0];
  const double area = cross(along_2, along_3);
  const double xi2 = cross(p - net[0], along_3) / area;
  const double xi3 = cross(along_2, p - net[0]) / area;
  if (!std::isfinite(xi2) || !std::isfinite(xi3)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  return {1 - xi2 - xi3, xi2, xi3};
}

bool is_within(const Barycentric& xi, double reach) {
  return std::ranges::all_of(xi, [reach](double x) { return x >= -reach && x <= 1 + reach; });
}

/// xi itself if no coordinate is below -reach; otherwise the last point for which this holds on the way from the centre
/// to xi.
Barycentric pull_inside(Barycentric xi, double reach) {
  const double least = std::ranges::min(xi);
  if (least >= -reach) return xi;
  const double factor = (1.0 / 3 + reach) / (1.0 / 3 - least);
  for (double& x : xi) x = 1.0 / 3 + factor * (x - 1.0 / 3);
  return xi;
}

Barycentric moved(const Barycentric& xi, double d2, double d3) {
  const double xi2 = xi[1] + d2;
  const double xi3 = xi[2] + d3;
  return {1 - xi2 - xi3, xi2, xi3};
}

std::optional<Barycentric> newton(const Map& map, const Point& p, double tolerance, Barycentric xi, double reach) {
  constexpr int most_steps = 40;
  constexpr int most_halvings = 12;
  xi = pull_inside(xi, reach);
  auto here = map(xi);
  double residual = distance(here.value, p);
  for (int step = 0; step < most_steps; ++step) {
    const double area = cross(here.along_2, here.along_3);
    const Vector rest = p - here.value;
    const double d2 = cross(rest, here.along_3) / area;
    const double d3 = cross(here.along_2, rest) / area;
    const bool was_reached = residual <= tolerance;
    if (!std::isfinite(d2) || !std::isfinite(d3)) break;
    bool is_better = false;
    double fraction = 1;
    for (int halving = 0; halving <= (was_reached ? 0 : most_halvings) && !is_better; ++halving, fraction /= 2) {
      const Barycentric next = pull_inside(moved(xi, fraction * d2, fraction * d3), reach);
      const auto there = map(next);
      const double next_residual = distance(there.value, p);
      if (next_residual < residual * (1 - fraction / 4)) {
        is_better = true;
        xi = next;
        here = there;
        residual = next_residual;
      }
    }
    // One step is made beyond the tolerance: it costs next to nothing and leaves little more than rounding.
    if (was_reached || !is_better) break;
  }
  if (residual <= tolerance && is_within(xi, reach + 1e-12)) return xi;
  return std::nullopt;
}

/// xi if it is inside up to rounding; otherwise xi moved to the boundary, if it then still maps to p within the
/// tolerance.
std::optional<Barycentric> clamped(const Map& map, const Point& p, double tolerance, Barycentric xi) {
  if (std::ranges::min(xi) >= -1e-12) return xi;
  double sum = 0;
  for (double& x : xi) sum += (x = std::max(x, 0.0));
  for (double& x : xi) x /= sum;
  if (distance(map(xi).value, p) <= tolerance) return xi;
  return std::nullopt;
}

Barycentric mean(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// How bisect_net takes the mean of two control points.
struct PointMean {
  static void add(Point& a, const Point& b) { a = 0.5 * (a + b); }
  static void align(Point&, int) {}
};

constexpr double unit_roundoff = 0x1p-53;

/// A piece of an element. Its control points are relative to the point sought, which is the origin here.
struct MapPiece {
  std::array<Barycentric, 3> corners;
  double error;  // bound of the rounding error in each coordinate of its control points
};

/// Questions to the control points of a piece.
class PieceTest {
 public:
  PieceTest(int degree, std::span<const Point> lattice_net, double error)
      : degree_(degree),
        net_(lattice_net),
        error_(error),
        a_(net_[0]),
        b_(net_[static_cast<std::size_t>(lattice_index(degree, 0))]),
        c_(net_[static_cast<std::size_t>(lattice_index(degree, degree))]) {
    for (const Point& q : net_) greatest_ = std::max({greatest_, std::fabs(q.x), std::fabs(q.y)});
  }

  /// Greatest |coordinate| of the control points.
  double greatest() const { return greatest_; }

  /// Whether a line separates the origin from all control points, by more than rounding can account for. The lines
  /// tried run along the axes; along the sides of the piece's straight triangle, so that even slender pieces are
  /// separated unless they are near; and across the direction to the piece, which separates all small pieces.
  bool is_separated() const {
    return separates({1, 0}) || separates({0, 1}) || separates(perpendicular(b_ - a_)) ||
           separates(perpendicular(c_ - b_)) || separates(perpendicular(a_ - c_)) || separates(a_ + b_ + c_);
  }

  /// Whether the piece differs so little from its straight triangle that Newton converges from the coordinates there.
  bool is_flat() const {
    const Vector ab = b_ - a_, ac = c_ - a_, bc = c_ - b_;
    const double most = 0.25 * std::fabs(cross(ab, ac));
    for (int r = 0, n = 0; r <= degree_; ++r)
      for (int k = 0; k <= r; ++k, ++n) {
        const Vector straight = ((degree_ - r) * a_ + (r - k) * b_ + k * c_) / degree_;
        const Vector off = net_[static_cast<std::size_t>(n)] - straight;
        if (!(std::max({std::fabs(cross(ab, off)), std::fabs(cross(ac, off)), std::fabs(cross(bc, off))}) <= most))
          return false;
      }
    return true;
  }

  /// The origin's barycentric coordinates in the straight triangle of the piece.
  Barycentric straight() const {
    const std::array<Point, 3> corners{a_, b_, c_};
    return straight_coordinates(corners, {0, 0});
  }

 private:
  /// Whether all control points are on one side of the line through the origin perpendicular to d. A computed product
  /// with a control point is wrong by at most (|d.x| + |d.y|) (error + 3u greatest); the margin is somewhat more.
  bool separates(const Vector& d) const {
    const double margin = (std::fabs(d.x) + std::fabs(d.y)) * (error_ + 4 * unit_roundoff * greatest_);
    if (dot(d, net_[0]) > margin) return std::ranges::all_of(net_, [&](const Point& q) { return dot(d, q) > margin; });
    return std::ranges::all_of(net_, [&](const Point& q) { return dot(d, q) < -margin; });
  }

  int degree_;
  std::span<const Point> net_;
  double error_;
  double greatest_ = 0;
  Point a_, b_, c_;
};

/// The part of find_in_element that bisects. `map` and `net` are relative to the point sought, and scaled; `net` is in
/// lattice order.
ElementSearch search_pieces(const Map& map, std::span<const Point> net, double tolerance) {
  constexpr int most_pieces = 20000;
  const Point origin{0, 0};
  const int degree = map.degree();
  const std::size_t n = net.size();
  std::vector<Point> nets(net.begin(), net.end());
  std::vector<MapPiece> pieces{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 4 * unit_roundoff}};
  std::array<Point, max_degree + 1> row;
  for (int count = 0; !pieces.empty() && count < most_pieces; ++count) {
    const MapPiece piece = pieces.back();
    const std::size_t first = nets.size() - n;
    const PieceTest test(degree, std::span(nets).subspan(first), piece.error);
    if (test.is_separated()) {
      pieces.pop_back();
      nets.resize(first);
      continue;
    }
    const auto& [a, b, c] = piece.corners;
    if (test.is_flat()) {
      const Barycentric w = test.straight();
      Barycentric start;
      for (std::size_t k = 0; k < 3; ++k) start[k] = w[0] * a[k] + w[1] * b[k] + w[2] * c[k];
      if (const auto xi = newton(map, origin, tolerance, start, 0.25))
        if (const auto inside = clamped(map, origin, tolerance, *xi)) return {SearchAnswer::found, *inside};
    }
    if (test.greatest() <= 0.5 * tolerance)
      return {SearchAnswer::found, {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3}};
    const double error = piece.error + (degree + 1) * unit_roundoff * test.greatest();
    const Barycentric middle = mean(a, b);
    std::array<Point, net_size(max_degree)> parent;
    std::copy_n(nets.begin() + static_cast<std::ptrdiff_t>(first), n, parent.begin());
    nets.resize(first + 2 * n);
    bisect_net<PointMean>(degree, parent.data(), nets.data() + first, nets.data() + first + n, row.data());
    pieces.back() = {{a, c, middle}, error};
    pieces.push_back({{c, b, middle}, error});
  }
  return {pieces.empty() ? SearchAnswer::absent : SearchAnswer::undecided, {}};
}

}  // namespace

std::optional<Barycentric> invert_map(int degree, std::span<const Point> net, const Point& p, double tolerance,
                                      const Barycentric* start, double reach) {
  return newton(Map(degree, net, p), {}, tolerance, start ? *start : straight_coordinates(net, p), reach);
}

ElementSearch find_in_element(int degree, std::span<const Point> net, const Point& p, double tolerance) {
  const auto n = static_cast<std::size_t>(net_size(degree));
  Box box;
  for (const Point& q : net.first(n)) box.extend(q);
  const double reach = std::max({box.high.x - p.x, p.x - box.low.x, box.high.y - p.y, p.y - box.low.y});
  if (reach == 0) return {SearchAnswer::found, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
  // Newton may find a point that is just outside the element with coordinates above -1e-12, which counts as found. So a
  // point is only called absent without asking Newton if it is farther away than this, relative to the reach.
  const double near = degree * 1e-11;
  const double slack = near * reach;
  if (p.x < box.low.x - slack || p.x > box.high.x + slack || p.y < box.low.y - slack || p.y > box.high.y + slack)
    return {SearchAnswer::absent, {}};
  // Control points are taken relative to p and scaled by a power of two, so that neither the place nor the size of the
  // element costs precision.
  const double scale = std::ldexp(1.0, std::clamp(-std::ilogb(reach), -1000, 1000));
  std::array<Point, net_size(max_degree)> relative, in_order;
  for (std::size_t k = 0; k < n; ++k) relative[k] = scale * (net[k] - p);
  const std::vector<int>& order = lattice_order(degree);
  for (std::size_t k = 0; k < n; ++k) in_order[static_cast<std::size_t>(order[k])] = relative[k];
  if (PieceTest(degree, std::span(in_order).first(n), near).is_separated()) return {SearchAnswer::absent, {}};
  if (const auto xi = invert_map(degree, net, p, tolerance); xi && std::ranges::min(*xi) >= -1e-12)
    return {SearchAnswer::found, *xi};
  return search_pieces(Map(degree, std::span(relative).first(n)), std::span(in_order).first(n),
                       std::max(scale * tolerance, 64 * degree * unit_roundoff));
}

}  // namespace pliant
