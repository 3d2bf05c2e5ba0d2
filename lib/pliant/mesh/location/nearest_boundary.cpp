// lib/pliant/mesh/location/nearest_boundary.cpp: bisects the squared distance along the outer edges near a place.
#include "pliant/mesh/location/nearest_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr int most_bisections = 12;  // pieces of 2^-12 of an edge are left to Newton
constexpr int most_newton_steps = 20;
constexpr double rounding = 1e-14;  // of the greatest squared distance: coefficients are not more exact

using Polygon = std::array<Point, max_degree + 1>;
using Squares = std::array<double, 2 * max_degree + 1>;

/// A place on an edge, by its parameter, and the square of its distance.
struct Foot {
  double s = 0, square = HUGE_VAL;
};

double squared(const Vector& v) { return dot(v, v); }

/// The curve relative to the point sought, and its first two derivatives at s.
struct Local {
  Vector place, first, second;
};
Local evaluate(int degree, const Polygon& polygon, double s) {
  Polygon row = polygon;
  Local local{};
  for (int level = degree; level > 0; --level) {
    if (level == 2) local.second = degree * (degree - 1) * (row[2] - 2 * row[1] + row[0]);
    if (level == 1) local.first = degree * (row[1] - row[0]);
    for (int k = 0; k < level; ++k) row[index(k)] = (1 - s) * row[index(k)] + s * row[index(k + 1)];
  }
  local.place = row[0];
  return local;
}

/// The Bernstein coefficients, of degree 2p, of the squared distance.
Squares squared_distance(int degree, const Polygon& polygon) {
  std::array<double, 2 * max_degree + 1> once{}, twice{};
  once[0] = twice[0] = 1;
  for (int k = 1; k <= degree; ++k) once[index(k)] = once[index(k - 1)] * (degree - k + 1) / k;
  for (int k = 1; k <= 2 * degree; ++k) twice[index(k)] = twice[index(k - 1)] * (2 * degree - k + 1) / k;
  Squares squares{};
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      squares[index(i + j)] +=
          once[index(i)] * once[index(j)] / twice[index(i + j)] * dot(polygon[index(i)], polygon[index(j)]);
  return squares;
}

/// Newton's method for the foot of a perpendicular, from s; never farther away than there but by rounding. Near the
/// foot the distance hardly changes, so that the slope tells better than the distance which place is nearer.
Foot descend(int degree, const Polygon& polygon, double s) {
  constexpr double same = 1 + 1e-12;
  Local at = evaluate(degree, polygon, s);
  Foot best{s, squared(at.place)};
  double slope = dot(at.place, at.first);
  for (int step = 0; step < most_newton_steps; ++step) {
    const double speed = squared(at.first), bend = speed + dot(at.place, at.second);
    if (speed == 0) break;
    s = std::clamp(best.s - slope / (bend > 0 ? bend : speed), 0.0, 1.0);
    if (s == best.s) break;
    at = evaluate(degree, polygon, s);
    const double square = squared(at.place), next = dot(at.place, at.first);
    if (!(square < best.square || (square <= same * best.square && std::abs(next) < std::abs(slope)))) break;
    best = {s, square};
    slope = next;
  }
  return best;
}

/// The nearest place of one edge, if its squared distance is below `bound`; else any place that is not.
Foot nearest_on_edge(int degree, const Polygon& polygon, double bound) {
  struct Piece {
    double start, width;
    int depth;
    Squares squares;
  };
  const std::size_t last = index(2 * degree);
  Foot best{0, squared(polygon[0])};
  if (const double end = squared(polygon[index(degree)]); end < best.square) best = {1, end};
  std::vector<Piece> pieces{{0, 1, 0, squared_distance(degree, polygon)}};
  const double noise = rounding * *std::max_element(pieces[0].squares.begin(),
                                                    pieces[0].squares.begin() + 1 + static_cast<std::ptrdiff_t>(last));
  double upper = std::min(bound, best.square);
  while (!pieces.empty()) {
    const Piece piece = pieces.back();
    pieces.pop_back();
    if (*std::min_element(piece.squares.begin(), piece.squares.begin() + 1 + static_cast<std::ptrdiff_t>(last)) >
        upper + noise)
      continue;
    if (piece.depth == most_bisections) {
      const Foot foot = descend(degree, polygon, piece.start + 0.5 * piece.width);
      if (foot.square < best.square) best = foot;
      upper = std::min(upper, best.square);
      continue;
    }
    Piece left{piece.start, 0.5 * piece.width, piece.depth + 1, {}}, right = left;
    right.start += right.width;
    Squares row = piece.squares;
    for (std::size_t k = 0; k <= last; ++k) {
      left.squares[k] = row[0];
      right.squares[last - k] = row[last - k];
      for (std::size_t i = 0; i + k < last; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
    }
    upper = std::min(upper, right.squares[0] + noise);
    // The half whose end is nearer is looked at first, so that it bounds the other one.
    const bool left_first = left.squares[0] < right.squares[last];
    pieces.push_back(left_first ? right : left);
    pieces.push_back(left_first ? left : right);
  }
  return best;
}

double squared_distance(const Box& box, const Point& p) {
  const double x = std::max({box.low.x - p.x, p.x - box.high.x, 0.0});
  const double y = std::max({box.low.y - p.y, p.y - box.high.y, 0.0});
  return x * x + y * y;
}

}  // namespace

NearestBoundary::NearestBoundary(const Mesh& mesh) : mesh_(mesh) {
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || mesh.twin(h) != none) continue;
    Box box;
    for (int k = 0; k <= mesh.degree(); ++k) box.extend(mesh.point(mesh.edge_point(h, k)));
    edges_.push_back(h);
    boxes_.push_back(box);
  }
}

NearestPlace NearestBoundary::find(const Point& p) const {
  std::size_t nearest = 0;
  double least = HUGE_VAL;
  for (std::size_t e = 0; e < boxes_.size(); ++e)
    if (const double d = squared_distance(boxes_[e], p); d < least) nearest = e, least = d;
  Foot best;
  std::size_t found = nearest;
  const auto look_at = [&](std::size_t e) {
    Polygon polygon{};
    for (int k = 0; k <= mesh_.degree(); ++k) polygon[index(k)] = mesh_.point(mesh_.edge_point(edges_[e], k)) - p;
    const Foot foot = nearest_on_edge(mesh_.degree(), polygon, best.square);
    if (foot.square < best.square) best = foot, found = e;
  };
  look_at(nearest);
  for (std::size_t e = 0; e < boxes_.size(); ++e)
    if (e != nearest && squared_distance(boxes_[e], p) < best.square) look_at(e);
  const HalfEdgeId h = edges_[found];
  Barycentric xi{};
  xi[index(edge_of(h))] = 1 - best.s;
  xi[index((edge_of(h) + 1) % 3)] = best.s;
  return {{triangle_of(h), xi}, std::sqrt(best.square)};
}

}  // namespace pliant
