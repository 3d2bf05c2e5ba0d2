// formats/picture/isolines/arc.cpp: a part of an isoline in one piece of an element, drawn as Bézier curves.
#include "formats/picture/isolines/arc.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

constexpr int arc_samples = 7;  // places between the ends at which a curve is compared with the isoline
constexpr int most_arc_halvings = 10;

Barycentric barycentric_of(const Point& local) { return {1 - local.x - local.y, local.x, local.y}; }

double value_at(const MonotonePiece& piece, const Point& local) {
  double value = 0;
  evaluate_net(piece.field_degree, 1, piece.field, barycentric_of(local), {&value, 1});
  return value;
}

/// The place in the plane of a point of the isoline, and the unit tangent of the isoline there (0 if it has none).
struct OnIsoline {
  Point place;
  Vector tangent;
};
OnIsoline on_isoline(const MonotonePiece& piece, const Point& local) {
  const Barycentric xi = barycentric_of(local);
  double value = 0;
  std::array<double, 1> along_2{}, along_3{};
  evaluate_net(piece.field_degree, 1, piece.field, xi, {&value, 1}, along_2, along_3);
  std::array<double, 2> place{}, map_2{}, map_3{};
  evaluate_net(piece.degree, 2, piece.geometry, xi, place, map_2, map_3);
  const Vector tangent{map_2[0] * along_3[0] - map_3[0] * along_2[0], map_2[1] * along_3[0] - map_3[1] * along_2[0]};
  const double size = length(tangent);
  return {{place[0], place[1]}, size > 0 && std::isfinite(size) ? tangent / size : Vector{}};
}

/// The point of the isoline on the line through `base` along the rise; the nearest end of that line's part in the piece
/// if rounding hides the change of sign.
Point project(const MonotonePiece& piece, const Point& base) {
  // The part of the line in the triangle: each barycentric coordinate is at least 0 there.
  double low = -2, high = 2;
  const Barycentric at = barycentric_of(base), slope{-piece.rise.x - piece.rise.y, piece.rise.x, piece.rise.y};
  for (std::size_t c = 0; c < 3; ++c) {
    if (slope[c] > 0) low = std::max(low, -std::max(0.0, at[c]) / slope[c]);
    if (slope[c] < 0) high = std::min(high, std::max(0.0, at[c]) / -slope[c]);
  }
  double f_low = value_at(piece, base + low * piece.rise), f_high = value_at(piece, base + high * piece.rise);
  if (f_low >= 0) return base + low * piece.rise;
  if (f_high < 0) return base + high * piece.rise;
  for (int round = 0, side = 0; round < 80 && high - low > 0x1p-50; ++round) {
    double t = low - f_low * (high - low) / (f_high - f_low);
    if (!(t > low && t < high)) t = low + (high - low) / 2;
    if (!(t > low && t < high)) break;
    const double f = value_at(piece, base + t * piece.rise);
    if (f == 0) return base + t * piece.rise;
    // False position; the end that stayed twice counts half (the Illinois rule).
    if (f > 0) {
      high = t, f_high = f;
      if (side == 1) f_low /= 2;
      side = 1;
    } else {
      low = t, f_low = f;
      if (side == -1) f_high /= 2;
      side = -1;
    }
  }
  return base + (low + (high - low) / 2) * piece.rise;
}

Point on_cubic(const std::array<Point, 4>& b, double s) {
  const double r = 1 - s;
  return r * r * r * b[0] + 3 * r * r * s * b[1] + 3 * r * s * s * b[2] + s * s * s * b[3];
}
Vector cubic_speed(const std::array<Point, 4>& b, double s) {
  const double r = 1 - s;
  return 3 * (r * r * (b[1] - b[0]) + 2 * r * s * (b[2] - b[1]) + s * s * (b[3] - b[2]));
}

/// The parameter of a cubic's point nearest to p, by Gauss-Newton steps from s.
double nearest(const std::array<Point, 4>& b, const Point& p, double s) {
  for (int round = 0; round < 4; ++round) {
    const Vector speed = cubic_speed(b, s);
    const double size = squared_length(speed);
    if (!(size > 0)) break;
    s = std::clamp(s - dot(on_cubic(b, s) - p, speed) / size, 0.0, 1.0);
  }
  return s;
}

class ArcDrawer {
 public:
  ArcDrawer(const MonotonePiece& piece, double tolerance, std::vector<std::vector<Point>>& curves)
      : piece_(piece), tolerance_(tolerance), curves_(curves) {}

  void draw(const ArcEnd& from, const ArcEnd& to, int depth) {
    std::array<Point, arc_samples> through;
    Point middle{};
    for (int k = 0; k < arc_samples; ++k) {
      const double s = double(k + 1) / (arc_samples + 1);
      const Point local = project(piece_, (1 - s) * from.local + s * to.local);
      through[static_cast<std::size_t>(k)] = on_isoline(piece_, local).place;
      if (k == arc_samples / 2) middle = local;
    }
    if (is_straight(from.place, to.place, through)) {
      curves_.push_back({from.place, to.place});
      return;
    }
    std::array<Point, 4> cubic = fitted(from, to, through);
    if (error(cubic, through) <= tolerance_ / 2) {
      curves_.push_back({cubic.begin(), cubic.end()});
    } else if (depth == most_arc_halvings) {
      curves_.push_back({from.place, to.place});
    } else {
      const ArcEnd split{middle, through[arc_samples / 2]};
      draw(from, split, depth + 1);
      draw(split, to, depth + 1);
    }
  }

 private:
  using Through = std::array<Point, arc_samples>;

  bool is_straight(const Point& a, const Point& b, const Through& through) const {
    const double size = distance(a, b);
    return std::all_of(through.begin(), through.end(), [&](const Point& p) {
      return size > 0 ? std::abs(cross(b - a, p - a)) <= 0.01 * tolerance_ * size && dot(p - a, b - a) >= 0 &&
                            dot(b - p, b - a) >= 0
                      : distance(p, a) <= 0.01 * tolerance_;
    });
  }

  /// The cubic with the arc's ends and tangents whose lengths of control legs fit the points best.
  std::array<Point, 4> fitted(const ArcEnd& from, const ArcEnd& to, const Through& through) const {
    const Point &a = from.place, &b = to.place;
    Vector out = on_isoline(piece_, from.local).tangent, in = on_isoline(piece_, to.local).tangent;
    const Vector chord = distance(a, b) > 0 ? (b - a) / distance(a, b) : Vector{};
    if (squared_length(out) == 0) out = chord;
    if (squared_length(in) == 0) in = chord;
    std::array<double, arc_samples> s{};
    double length_so_far = 0;
    for (std::size_t k = 0; k < arc_samples; ++k)
      s[k] = length_so_far += distance(k == 0 ? a : through[k - 1], through[k]);
    length_so_far += distance(through.back(), b);
    for (double& each : s) each /= length_so_far > 0 ? length_so_far : 1;
    std::array<Point, 4> cubic{a, a + length_so_far / 3 * out, b - length_so_far / 3 * in, b};
    for (int round = 0; round < 4; ++round) {
      double oo = 0, oi = 0, ii = 0, ro = 0, ri = 0;
      for (std::size_t k = 0; k < arc_samples; ++k) {
        const double r = 1 - s[k], b1 = 3 * r * r * s[k], b2 = 3 * r * s[k] * s[k];
        const Vector rest = through[k] - ((r * r * r + b1) * a + (b2 + s[k] * s[k] * s[k]) * b);
        oo += b1 * b1, oi -= b1 * b2 * dot(out, in), ii += b2 * b2;
        ro += b1 * dot(rest, out), ri -= b2 * dot(rest, in);
      }
      const double determinant = oo * ii - oi * oi;
      const double leg_out = (ro * ii - ri * oi) / determinant, leg_in = (ri * oo - ro * oi) / determinant;
      if (!(leg_out > 0 && leg_in > 0 && leg_out < 3 * length_so_far && leg_in < 3 * length_so_far)) break;
      cubic = {a, a + leg_out * out, b - leg_in * in, b};
      for (std::size_t k = 0; k < arc_samples; ++k) s[k] = nearest(cubic, through[k], s[k]);
    }
    return cubic;
  }

  double error(const std::array<Point, 4>& cubic, const Through& through) const {
    double most = 0;
    for (std::size_t k = 0; k < arc_samples; ++k) {
      const double s = nearest(cubic, through[k], double(k + 1) / (arc_samples + 1));
      most = std::max(most, distance(on_cubic(cubic, s), through[k]));
    }
    return most;
  }

  const MonotonePiece& piece_;
  double tolerance_;
  std::vector<std::vector<Point>>& curves_;
};

}  // namespace

void draw_arc(const MonotonePiece& piece, const ArcEnd& from, const ArcEnd& to, double tolerance,
              std::vector<std::vector<Point>>& curves) {
  if (from.place == to.place && from.local == to.local) return;
  ArcDrawer(piece, tolerance, curves).draw(from, to, 0);
}

}  // namespace pliant
