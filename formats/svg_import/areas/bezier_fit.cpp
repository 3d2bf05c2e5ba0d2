// formats/svg_import/areas/bezier_fit.cpp: the steps of an outline as Bézier pieces of a degree, within a tolerance.
#include "formats/svg_import/areas/bezier_fit.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace pliant::svg {
namespace {

using Cubic = std::array<Point, 4>;

constexpr double rounding = 1e-14;     // a part of a piece's size: how far sums of decimals bend a straight line
constexpr double vanishing = 1e-9;     // a derivative below this part of a cubic's size counts as zero
constexpr double least_inside = 1e-6;  // an inflection whose parameter is closer than this to an end is not split at
constexpr int max_halvings = 60;
// Pieces that are fitted turn by at most 60 degrees. bspline2mesh cuts those that turn by more where an element beside
// them would not be valid, so that a looser tolerance would end in more triangles.
constexpr double most_turn = std::numbers::pi / 3;
constexpr double least_cosine = 0.5;

double size_of(const Point* p, int count) {
  double size = 0;
  for (int i = 1; i < count; ++i) size = std::max(size, distance(p[0], p[i]));
  return size;
}

bool is_straight(const Point* p, int count, double margin) {
  const double size = size_of(p, count);
  int farthest = 0;
  for (int i = 1; i < count; ++i)
    if (distance(p[0], p[i]) == size) farthest = i;
  const Vector along = p[farthest] - p[0];
  for (int i = 1; i < count; ++i)
    if (std::abs(cross(along, p[i] - p[0])) > margin * size * size) return false;
  return true;
}

void add_line(const Point& p, const Point& q, bool fitted, std::vector<Piece>& out) {
  if (p == q) return;
  Piece piece;
  piece.fitted = fitted;
  piece.points[0] = p;
  piece.points[1] = q;
  out.push_back(piece);
}

/// The parameters in (0, 1) at which the curvature changes sign or the derivative vanishes.
void add_inflections(const Cubic& c, std::vector<double>& out) {
  const Vector a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
  // cross(c', c'') is, up to a factor, f0 (1-t)^2 + f1 t (1-t) + f2 t^2.
  const double f0 = cross(a, b), f1 = cross(a, d), f2 = cross(b, d);
  // With s = t / (1 - t): f2 s^2 + f1 s + f0 = 0.
  const double discriminant = f1 * f1 - 4 * f0 * f2;
  const double scale = f1 * f1 + 4 * std::abs(f0 * f2);
  const auto add = [&](double numerator, double denominator) {
    const double sum = numerator + denominator;
    if (sum == 0) return;
    const double t = numerator / sum;
    if (least_inside < t && t < 1 - least_inside) out.push_back(t);
  };
  if (discriminant < -1e-12 * scale) return;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double q = -(f1 + (f1 < 0 ? -root : root)) / 2;
  add(q, f2);
  if (root > 0) add(f0, q);
  std::sort(out.begin(), out.end());
}

/// The quadratic with the ends and the end tangents of a cubic; empty where the tangents do not meet as they should.
struct TangentFit {
  Point q;
  double error;  ///< upper bound of the distance, from a reparametrization
};

std::optional<TangentFit> fit_tangents(const Cubic& c) {
  const Vector chord = c[3] - c[0];
  Vector first = c[1] - c[0], last = c[3] - c[2];
  const bool stands_first = first == Vector{}, stands_last = last == Vector{};
  if (stands_first) first = c[2] - c[0];
  if (stands_last) last = c[3] - c[1];
  const double turn = cross(first, last);
  if (dot(first, last) < least_cosine * length(first) * length(last)) return std::nullopt;
  const double lambda = cross(chord, last) / turn, mu = cross(first, chord) / turn;
  if (!(lambda > 0 && mu > 0 && std::isfinite(lambda) && std::isfinite(mu))) return std::nullopt;
  const Vector q = lambda * first;
  // The quadratic is run through by s(t), the cubic polynomial with s(0) = 0, s(1) = 1 that makes the derivatives at
  // the ends equal; slopes in [0, 3] make it monotone. The difference of both curves is then of degree 6 with double
  // zeros at the ends, and its Bernstein coefficients bound it.
  const double slope0 = stands_first ? 0 : 1.5 / lambda, slope1 = stands_last ? 0 : 1.5 / mu;
  if (slope0 > 3 || slope1 > 3) return std::nullopt;
  const std::array<double, 4> s{0, slope0 / 3, 1 - slope1 / 3, 1};
  static constexpr std::array<double, 4> binomial3{1, 3, 3, 1};
  static constexpr std::array<double, 7> binomial6{1, 6, 15, 20, 15, 6, 1};
  std::array<Vector, 7> difference{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const double weight = binomial3[i] * binomial3[j] / binomial6[i + j];
      const Vector on_quadratic = ((1 - s[i]) * s[j] + s[i] * (1 - s[j])) * q + s[i] * s[j] * chord;
      difference[i + j] += weight * (c[i] - c[0] - on_quadratic);
    }
  double error = 0;
  for (const Vector& v : difference) error = std::max(error, length(v));
  return TangentFit{c[0] + q, error};
}

}  // namespace

std::array<Cubic, 2> split(const Cubic& c, double t) {
  const auto mix = [t](const Point& p, const Point& q) { return (1 - t) * p + t * q; };
  const Point ab = mix(c[0], c[1]), bc = mix(c[1], c[2]), cd = mix(c[2], c[3]);
  const Point abc = mix(ab, bc), bcd = mix(bc, cd), middle = mix(abc, bcd);
  return {Cubic{c[0], ab, abc, middle}, Cubic{middle, bcd, cd, c[3]}};
}

/// Adds a cubic whose control points are on a line: its chord, or where it is to be followed back, the lines between
/// the places where it turns round.
void BezierFit::add_straight(const Cubic& c, std::vector<Piece>& out) const {
  if (!follows_back_) return add_line(c[0], c[3], false, out);
  Vector along;
  for (const Point& p : c)
    if (squared_length(p - c[0]) > squared_length(along)) along = p - c[0];
  const double a = dot(along, c[1] - c[0]), b = dot(along, c[2] - c[1]), d = dot(along, c[3] - c[2]);
  std::vector<double> turns;
  if (const double discriminant = b * b - a * d; discriminant > 0) {  // of a (1-t)^2 + 2 b t (1-t) + d t^2
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    turns = {q / (q + d), a / (a + q)};
    std::sort(turns.begin(), turns.end());
  }
  Point at = c[0];
  for (const double t : turns) {
    if (!(least_inside < t && t < 1 - least_inside)) continue;
    const Point turn = split(c, t)[0][3];
    add_line(at, turn, false, out);
    at = turn;
  }
  add_line(at, c[3], false, out);
}

void BezierFit::add_quadratic(const Point& p, const Point& q, const Point& r, std::vector<Piece>& out) {
  const std::array<Point, 3> points{p, q, r};
  if (is_straight(points.data(), 3, rounding))
    return add_straight({p, p + (2.0 / 3) * (q - p), r + (2.0 / 3) * (q - r), r}, out);
  Piece piece;
  piece.degree = 2;
  std::copy(points.begin(), points.end(), piece.points.begin());
  out.push_back(piece);
}

void BezierFit::add_cubic(const Cubic& c, std::vector<Piece>& out) {
  if (is_straight(c.data(), 4, rounding)) return add_straight(c, out);
  const double size = size_of(c.data(), 4);
  std::vector<double> cuts;
  add_inflections(c, cuts);
  bool is_regular = distance(c[0], c[1]) > vanishing * size && distance(c[2], c[3]) > vanishing * size;
  for (const double t : cuts) {
    const auto [before, after] = split(c, t);
    is_regular = is_regular && distance(before[2], after[1]) > vanishing * size;
  }
  if (degree_ >= 3 && is_regular) {
    Piece piece;
    piece.degree = 3;
    piece.points = c;
    out.push_back(piece);
    return;
  }
  Cubic rest = c;
  double done = 0;
  for (const double t : cuts) {
    if (t <= done) continue;
    const auto [before, after] = split(rest, (t - done) / (1 - done));
    fit(before, 0, out);
    rest = after;
    done = t;
  }
  fit(rest, 0, out);
}

void BezierFit::fit(const Cubic& c, int depth, std::vector<Piece>& out) {
  if (const auto found = fit_tangents(c); found && found->error <= tolerance_) {
    error_ = std::max(error_, found->error);
    Piece piece;
    piece.degree = 2;
    piece.fitted = true;
    piece.points = {c[0], found->q, c[3], {}};
    if (is_straight(piece.points.data(), 3, rounding)) return add_line(c[0], c[3], true, out);
    out.push_back(piece);
    return;
  }
  // Next to an inflection or a cusp the remaining part becomes straight, or small, before a parabola fits.
  const double size = size_of(c.data(), 4);
  const Vector chord = c[3] - c[0];
  const double chord_squared = squared_length(chord);
  double off = size;
  const auto is_between = [&](const Point& p) {
    const double along = dot(chord, p - c[0]);
    return 0 <= along && along <= chord_squared;
  };
  if (is_between(c[1]) && is_between(c[2]) && chord_squared > 0)
    off = std::max(std::abs(cross(chord, c[1] - c[0])), std::abs(cross(chord, c[2] - c[0]))) / std::sqrt(chord_squared);
  if (off <= tolerance_ || depth >= max_halvings) {
    error_ = std::max(error_, off);
    return add_line(c[0], c[3], true, out);
  }
  const auto [before, after] = split(c, 0.5);
  fit(before, depth + 1, out);
  fit(after, depth + 1, out);
}

void BezierFit::add_arc(const Point& start, const Point& center, const Vector& u, const Vector& v, double from,
                        double sweep, const Point& end, std::vector<Piece>& out) {
  // The greatest factor by which the map from the unit circle lengthens.
  const double uu = squared_length(u), vv = squared_length(v), uv = dot(u, v);
  const double greatest = std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2);
  const double least = greatest > 0 ? std::abs(cross(u, v)) / greatest : 0;
  if (least <= rounding * greatest) return add_line(start, end, false, out);  // a transform has flattened the ellipse
  // A piece of angle 2h on the unit circle: the parabola is off by 2 sin^4(h/2) / cos(h) at its middle, the cubic by
  // at most 2/27 sin^6(h/2) / cos^2(h/2) (Dokken, Daehlen, Lyche and Morken, 1990).
  const auto error_of = [&](double h) {
    const double s = std::sin(h / 2), s2 = s * s;
    return greatest * (degree_ >= 3 ? 2.0 / 27 * s2 * s2 * s2 / (1 - s2) : 2 * s2 * s2 / std::cos(h));
  };
  const double angle = std::abs(sweep);
  const double order = degree_ >= 3 ? 6 : 4, factor = degree_ >= 3 ? 2.0 / 27 / 64 : 1.0 / 8;
  const double h_fit = std::pow(tolerance_ / (greatest * factor), 1 / order);
  constexpr double most_h = most_turn / 2;
  constexpr double most_pieces = 1e6;
  double count = std::clamp(std::ceil(angle / 2 / std::min(h_fit, most_h) * (1 - 1e-9)), 1.0, most_pieces);
  while (error_of(angle / 2 / count) > tolerance_ && count < most_pieces) count += std::ceil(count / 64);
  const double h = angle / 2 / count;
  error_ = std::max(error_, error_of(h));
  const double side = sweep < 0 ? -1 : 1;
  const auto at = [&](double t) { return center + u * std::cos(t) + v * std::sin(t); };
  const auto along = [&](double t) { return side * (v * std::cos(t) - u * std::sin(t)); };
  Point before = start;
  double t = from;
  for (long i = 1; i <= static_cast<long>(count); ++i) {
    const double next = from + sweep * (static_cast<double>(i) / count);
    const Point after = i == static_cast<long>(count) ? end : at(next);
    Piece piece;
    piece.fitted = true;
    if (degree_ >= 3) {
      const double leg = 4.0 / 3 * std::tan(h / 2);
      piece.degree = 3;
      piece.points = {before, at(t) + leg * along(t), at(next) - leg * along(next), after};
    } else {
      const double middle = (t + next) / 2;
      piece.degree = 2;
      piece.points = {before, center + (u * std::cos(middle) + v * std::sin(middle)) / std::cos(h), after, {}};
    }
    out.push_back(piece);
    before = after;
    t = next;
  }
}

}  // namespace pliant::svg
