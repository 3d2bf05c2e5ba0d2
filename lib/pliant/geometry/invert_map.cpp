#include "pliant/geometry/invert_map.h"  // lib/pliant/geometry/invert_map.cpp: Newton, and bisection where it fails

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

/// The element as rows of two doubles.
class Map {
 public:
  Map(int degree, std::span<const Point> net) : degree_(degree) {
    assert(1 <= degree && degree <= max_degree && net.size() >= static_cast<std::size_t>(net_size(degree)));
    for (std::size_t n = 0; n < static_cast<std::size_t>(net_size(degree)); ++n) {
      rows_[2 * n] = net[n].x;
      rows_[2 * n + 1] = net[n].y;
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

/// The nearest of the same direction from the centre, at most `reach` outside.
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
    if (was_reached || !is_better) break;  // one step beyond the tolerance: nearly free, and then rounding is all
  }
  if (residual <= tolerance && is_within(xi, reach + 1e-12)) return xi;
  return std::nullopt;
}

/// Inside up to rounding, or moved to the boundary where that is still p up to the tolerance.
std::optional<Barycentric> clamped(const Map& map, const Point& p, double tolerance, Barycentric xi) {
  if (std::ranges::min(xi) >= -1e-12) return xi;
  double sum = 0;
  for (double& x : xi) sum += (x = std::max(x, 0.0));
  for (double& x : xi) x /= sum;
  if (distance(map(xi).value, p) <= tolerance) return xi;
  return std::nullopt;
}

struct Piece {
  std::array<Barycentric, 3> corners;
  int depth;
};

Barycentric mean(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Whether the box of the piece's control points comes within the tolerance of p.
bool may_contain(const Map& map, const Piece& piece, const Point& p, double tolerance, Box& box) {
  std::array<double, 2 * net_size(max_degree)> rows;
  sub_net(map.degree(), 2, map.rows(), piece.corners[0], piece.corners[1], piece.corners[2], rows);
  box = {};
  for (std::size_t n = 0; n < map.rows().size(); n += 2) box.extend({rows[n], rows[n + 1]});
  const double slack = tolerance + 1e-15 * (std::fabs(p.x) + std::fabs(p.y));
  return box.low.x - slack <= p.x && p.x <= box.high.x + slack && box.low.y - slack <= p.y && p.y <= box.high.y + slack;
}

}  // namespace

std::optional<Barycentric> invert_map(int degree, std::span<const Point> net, const Point& p, double tolerance,
                                      const Barycentric* start, double reach) {
  return newton(Map(degree, net), p, tolerance, start ? *start : straight_coordinates(net, p), reach);
}

std::optional<Barycentric> invert_map_by_subdivision(int degree, std::span<const Point> net, const Point& p,
                                                     double tolerance) {
  constexpr int greatest_depth = 80;  // two bisections halve the diameter
  constexpr int most_pieces = 20000;
  const Map map(degree, net);
  std::vector<Piece> pieces{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0}};
  for (int count = 0; !pieces.empty() && count < most_pieces; ++count) {
    const Piece piece = pieces.back();
    pieces.pop_back();
    Box box;
    if (!may_contain(map, piece, p, tolerance, box)) continue;
    const auto& [a, b, c] = piece.corners;
    const Barycentric centre{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    if (const auto xi = newton(map, p, tolerance, centre, 0.25))
      if (const auto inside = clamped(map, p, tolerance, *xi)) return inside;
    if (distance(map(centre).value, p) <= tolerance) return centre;
    if (piece.depth == greatest_depth) continue;
    const Barycentric middle = mean(a, b);
    pieces.push_back({{a, c, middle}, piece.depth + 1});
    pieces.push_back({{c, b, middle}, piece.depth + 1});
  }
  return std::nullopt;
}

}  // namespace pliant
