// lib/pliant/boundary/gap_pieces.cpp: parts of Bézier curves, and what bounds the distance between two.
#include "pliant/boundary/gap_pieces.h"

#include <algorithm>
#include <cmath>

namespace pliant {

GapPiece whole_piece(std::span<const Point> polygon) {
  GapPiece piece;
  piece.degree = static_cast<int>(polygon.size()) - 1;
  std::ranges::copy(polygon, piece.points.begin());
  return piece;
}

std::pair<GapPiece, GapPiece> halves(const GapPiece& piece) {
  GapPiece left = piece, right = piece;
  const int p = piece.degree;
  for (int r = 1; r <= p; ++r) {
    for (int i = p; i >= r; --i) left.at(i) = 0.5 * (left.at(i - 1) + left.at(i));
    right.at(p - r) = left.at(p);
  }
  left.to = right.from = piece.from + (piece.to - piece.from) / 2;
  return {left, right};
}

GapPiece end_of(const GapPiece& piece, bool start) {
  GapPiece end;
  end.degree = 0;
  end.at(0) = piece.at(start ? 0 : piece.degree);
  end.from = end.to = start ? piece.from : piece.to;
  return end;
}

double angle_between(const Vector& a, const Vector& b) {
  if (a == Vector{} || b == Vector{}) return 0;
  return std::atan2(std::fabs(cross(a, b)), dot(a, b));
}

double turning(std::span<const Point> polygon) {
  double sum = 0;
  Vector last{};
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const Vector leg = polygon[k] - polygon[k - 1];
    if (leg == Vector{}) continue;
    sum += angle_between(last, leg);
    last = leg;
  }
  return sum;
}

Vector outward_leg(std::span<const Point> polygon, bool from_start) {
  const std::size_t n = polygon.size();
  for (std::size_t k = 1; k < n; ++k) {
    const Vector leg = from_start ? polygon[k] - polygon[0] : polygon[n - 1 - k] - polygon[n - 1];
    if (!(leg == Vector{})) return leg;
  }
  return {};
}

double polygon_length(std::span<const Point> polygon) {
  double sum = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k) sum += distance(polygon[k - 1], polygon[k]);
  return sum;
}

namespace {

/// The parameter of the place on a segment that is nearest to p.
double nearest_on(const Point& from, const Vector& along, const Point& p) {
  const double square = squared_length(along);
  return square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
}

}  // namespace

ChordDistance chord_distance(const GapPiece& a, const GapPiece& b) {
  const Point &p = a.at(0), &q = b.at(0);
  const Vector along_a = a.at(a.degree) - p, along_b = b.at(b.degree) - q;
  ChordDistance nearest{HUGE_VAL, 0, 0};
  const auto offer = [&](double u, double v) {
    const double apart = distance(p + u * along_a, q + v * along_b);
    if (apart < nearest.distance) nearest = {apart, u, v};
  };
  // Two segments that do not cross are nearest at an end of one of them.
  offer(0, nearest_on(q, along_b, p));
  offer(1, nearest_on(q, along_b, p + along_a));
  offer(nearest_on(p, along_a, q), 0);
  offer(nearest_on(p, along_a, q + along_b), 1);
  const double turn = cross(along_a, along_b);
  if (turn != 0) {
    const double u = cross(q - p, along_b) / turn, v = cross(q - p, along_a) / turn;
    if (u >= 0 && u <= 1 && v >= 0 && v <= 1) nearest = {0, u, v};
  }
  return nearest;
}

double height_over_chord(const GapPiece& piece) {
  const Point& from = piece.at(0);
  const Vector chord = piece.at(piece.degree) - from;
  double height = 0;
  for (int i = 1; i < piece.degree; ++i)
    height = std::max(height, distance(piece.at(i), from + nearest_on(from, chord, piece.at(i)) * chord));
  return height;
}

int slope_of_distance(const GapPiece& piece, const GapPiece& other) {
  // The slope is bilinear in the derivative, which lies in the hull of the legs, and in the way from the other place,
  // which lies in the hull of the differences.
  bool grows = piece.degree > 0, falls = grows;
  for (int k = 1; k <= piece.degree && (grows || falls); ++k) {
    const Vector leg = piece.at(k) - piece.at(k - 1);
    for (const Point& p : piece.polygon())
      for (const Point& q : other.polygon()) {
        const double slope = dot(leg, p - q);
        grows = grows && slope > 0;
        falls = falls && slope < 0;
      }
  }
  return grows ? 1 : falls ? -1 : 0;
}

CurvePlace evaluate_piece(const GapPiece& piece, double u) {
  const int p = piece.degree;
  std::array<Point, max_curve_degree + 1> row = piece.points;
  const auto at = [&row](int i) -> Point& { return row[static_cast<std::size_t>(i)]; };
  CurvePlace result{};
  for (int n = p; n >= 0; --n) {  // n + 1 points are left
    if (n == 2) result.second = static_cast<double>(p * (p - 1)) * (at(2) - 2 * at(1) + at(0));
    if (n == 1) result.first = static_cast<double>(p) * (at(1) - at(0));
    for (int i = 0; i < n; ++i) at(i) = (1 - u) * at(i) + u * at(i + 1);
  }
  result.place = at(0);
  return result;
}

std::pair<double, double> polish(const GapPiece& a, const GapPiece& b, double u, double v) {
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps; ++step) {
    const CurvePlace x = evaluate_piece(a, u), y = evaluate_piece(b, v);
    const Vector apart = x.place - y.place;
    const double fu = dot(x.first, apart), fv = -dot(y.first, apart);
    const double uu = squared_length(x.first) + dot(x.second, apart), uv = -dot(x.first, y.first);
    const double vv = squared_length(y.first) - dot(y.second, apart);
    double du = 0, dv = 0;
    if (a.degree > 0 && b.degree > 0) {
      // Least squares with a little damping: where the curves run parallel, the equations are dependent.
      const double damping = 1e-14 * (uu * uu + 2 * uv * uv + vv * vv);
      const double m11 = uu * uu + uv * uv + damping, m12 = uv * (uu + vv), m22 = uv * uv + vv * vv + damping;
      const double r1 = -(uu * fu + uv * fv), r2 = -(uv * fu + vv * fv), det = m11 * m22 - m12 * m12;
      if (!(det > 0)) break;
      du = (r1 * m22 - r2 * m12) / det;
      dv = (m11 * r2 - m12 * r1) / det;
    }
    // A place at the end of its piece that would leave it stays there, and the other one goes on alone.
    const auto leaves = [](double w, double dw) { return (w == 0 && dw < 0) || (w == 1 && dw > 0); };
    const auto alone = [](double slope, double bend) { return bend != 0 ? -slope / bend : 0; };
    if (a.degree == 0 || leaves(u, du)) {
      du = 0;
      dv = b.degree > 0 ? alone(fv, vv) : 0;
    } else if (b.degree == 0 || leaves(v, dv)) {
      dv = 0;
      du = alone(fu, uu);
    }
    const double next_u = std::clamp(u + du, 0.0, 1.0), next_v = std::clamp(v + dv, 0.0, 1.0);
    const bool rests = std::fabs(next_u - u) + std::fabs(next_v - v) < 1e-15;
    u = next_u;
    v = next_v;
    if (rests) break;
  }
  return {u, v};
}

}  // namespace pliant
