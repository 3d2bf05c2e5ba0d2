// lib/pliant/geometry/spline/bspline.cpp: knots, breaks, de Boor, Bézier extraction.
#include "pliant/geometry/spline/bspline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pliant {
namespace {

/// (1 - alpha) a + alpha b; for alpha 0 or 1 a copy, so that repeated knots keep control points bit for bit.
Point between(const Point& a, const Point& b, double alpha) {
  if (alpha == 0) return a;
  if (alpha == 1) return b;
  return (1 - alpha) * a + alpha * b;
}

/// The knots and control points that span k = [t_k, t_k+1) depends on: t_{k-p+1} .. t_{k+p} and d_{k-p} .. d_k.
struct Local {
  std::array<double, 2 * max_curve_degree> knots;
  std::array<Point, max_curve_degree + 1> points;

  double knot(int i) const { return knots[static_cast<std::size_t>(i)]; }
  Point& point(int i) { return points[static_cast<std::size_t>(i)]; }

  /// Step r (of p) of de Boor's algorithm with argument u, which changes points r .. last.
  void step(int p, int r, int last, double u) {
    for (int j = last; j >= r; --j) {
      const double low = knot(j - 1), high = knot(j + p - r);
      point(j) = between(point(j - 1), point(j), (u - low) / (high - low));
    }
  }
};

std::string number(const char* what, std::size_t i) { return std::string(what) + "/" + std::to_string(i); }

/// For example "knots/3 is 0.5"; a message opens with the place of the fault.
std::string knot_is(std::span<const double> knots, std::size_t i) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), knots[i]).ptr;
  return number("knots", i) + " is " + std::string(text.data(), end);
}

/// The first of the knots from .. to - 1 that has more than `limit` copies up to and including itself.
std::optional<std::size_t> too_often(std::span<const double> knots, std::size_t from, std::size_t to, int limit) {
  int count = 0;
  for (std::size_t i = from; i < to; ++i) {
    count = i > from && knots[i] == knots[i - 1] ? count + 1 : 1;
    if (count > limit) return i;
  }
  return std::nullopt;
}

std::optional<std::string> open_fault(int degree, std::span<const double> knots) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t n = knots.size();
  const std::string clamped = "; an open curve of degree " + std::to_string(degree) + " has " +
                              std::to_string(degree + 1) + " equal knots at each end";
  for (std::size_t i = 1; i <= p; ++i) {
    if (knots[i] != knots[0]) return knot_is(knots, i) + ", not the first knot's value" + clamped;
    if (knots[n - 1 - i] != knots[n - 1]) return knot_is(knots, n - 1 - i) + ", not the last knot's value" + clamped;
  }
  if (knots[p + 1] == knots[0]) return knot_is(knots, p + 1) + ", the first knot once too often" + clamped;
  if (knots[n - p - 2] == knots[n - 1]) return knot_is(knots, n - p - 2) + ", the last knot once too often" + clamped;
  if (const auto i = too_often(knots, p + 1, n - p - 1, degree))
    return knot_is(knots, *i) + " once too often; a knot inside a curve of degree " + std::to_string(degree) +
           " is there at most " + std::to_string(degree) + " times";
  return std::nullopt;
}

std::optional<std::string> closed_fault(int degree, std::span<const double> knots) {
  const double first = knots.front(), last = knots.back();
  if (!(first < last)) return "knots span no interval";
  const std::size_t m = knots.size() - 1;
  if (const auto i = too_often(knots, 0, m, degree))
    return knot_is(knots, *i) + " once too often; a knot of a curve of degree " + std::to_string(degree) +
           " is there at most " + std::to_string(degree) + " times";
  const auto seam =
      std::count(knots.begin(), knots.end() - 1, first) + std::count(knots.begin(), knots.end() - 1, last);
  if (seam > degree)
    return knot_is(knots, 0) +
           ", too often together with the knots at the end of the period; a knot of a curve of degree " +
           std::to_string(degree) + " is there at most " + std::to_string(degree) + " times";
  for (std::size_t i = 1; i <= m; ++i) {
    const bool same = knots[i] == knots[i - 1];
    if (!same && (last + (knots[i] - first) == last + (knots[i - 1] - first) ||
                  first - (last - knots[i]) == first - (last - knots[i - 1])))
      return number("knots", i) + " is so close to the knot before that the two are equal a period later or earlier";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> BSpline::fault(int degree, bool closed, std::span<const double> knots,
                                          std::span<const Point> points) {
  if (degree < 1 || degree > max_curve_degree)
    return "degree is " + std::to_string(degree) + ", not 1 to " + std::to_string(max_curve_degree);
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t least = closed ? p : p + 1;
  if (points.size() < least)
    return "points: " + std::to_string(points.size()) + " control points, at least " + std::to_string(least) +
           " are needed";
  const std::size_t expected = closed ? points.size() + 1 : points.size() + p + 1;
  if (knots.size() != expected)
    return "knots: " + std::to_string(knots.size()) + " knots, expected " + std::to_string(expected);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) return number("points", i) + " is not finite";
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) return number("knots", i) + " is not finite";
    if (i > 0 && knots[i] < knots[i - 1])
      return knot_is(knots, i) + ", but " + knot_is(knots, i - 1) + ": knots do not decrease";
  }
  if (!std::isfinite(2 * (knots.back() - knots.front()))) return "knots span more than a double holds";
  return closed ? closed_fault(degree, knots) : open_fault(degree, knots);
}

BSpline::BSpline(int degree, bool closed, std::vector<double> knots, std::vector<Point> points)
    : degree_(degree), closed_(closed), knots_(std::move(knots)), points_(std::move(points)) {
  assert(!fault(degree_, closed_, knots_.to_vector(), points_.to_vector()));
}

double BSpline::first_parameter() const { return knots_.front(); }
double BSpline::last_parameter() const { return knots_.back(); }

double BSpline::knot(int i) const {
  const int m = static_cast<int>(points_.size());
  const auto at = [this](int j) { return knots_[static_cast<std::size_t>(j)]; };
  if (!closed_ || (0 <= i && i <= m)) return at(i);
  // Differences are measured from the seam, so that copies of the seam's own knot are equal to it bit for bit.
  const double first = knots_.front(), last = knots_.back();
  if (i < 0) {
    const int periods = (-i - 1) / m;
    return first - periods * (last - first) - (last - at(i + (periods + 1) * m));
  }
  const int periods = i / m - 1;
  return last + periods * (last - first) + (at(i - (periods + 1) * m) - first);
}

const Point& BSpline::point(int i) const {
  const int m = static_cast<int>(points_.size());
  if (closed_ && (i < 0 || i >= m)) i = (i % m + m) % m;
  return points_[static_cast<std::size_t>(i)];
}

int BSpline::interval(double t) const {
  const auto begin = knots_.begin();
  if (closed_) {
    if (t >= knots_.back()) t = knots_.front();
    return std::max(0, static_cast<int>(std::upper_bound(begin, knots_.end(), t) - begin) - 1);
  }
  const int last = static_cast<int>(points_.size()) - 1;
  return std::clamp(static_cast<int>(std::upper_bound(begin, knots_.end(), t) - begin) - 1, degree_, last);
}

std::vector<double> BSpline::breaks() const {
  std::vector<double> result = knots_;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

int BSpline::span_count(int most) const {
  int count = 0;
  for (std::size_t i = 1; i < knots_.size() && count < most; ++i) count += knots_[i - 1] < knots_[i];
  return count;
}

double BSpline::span_end(double t0) const {
  if (closed_ && t0 >= last_parameter()) t0 = first_parameter();
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), t0);
  return after == knots_.end() ? last_parameter() : *after;
}

double BSpline::span_before(double t1) const {
  if (closed_ && t1 <= first_parameter()) t1 = last_parameter();
  const auto at = std::lower_bound(knots_.begin(), knots_.end(), t1);
  return at == knots_.begin() ? first_parameter() : *(at - 1);
}

int BSpline::multiplicity(double t) const {
  const auto count = [this](double value, bool whole) {
    const auto [low, high] = std::equal_range(knots_.begin(), whole ? knots_.end() : knots_.end() - 1, value);
    return static_cast<int>(high - low);
  };
  if (closed_ && (t == first_parameter() || t == last_parameter()))
    return count(first_parameter(), false) + count(last_parameter(), false);
  return count(t, true);
}

Point BSpline::evaluate(double t) const {
  if (!closed_ && t >= last_parameter()) return points_.back();
  if (closed_ && t >= last_parameter()) t = first_parameter();
  const int p = degree_, k = interval(t);
  // At a knot of multiplicity s only the first p - s steps do anything.
  int s = 0;
  while (s < p && knot(k - s) == t) ++s;
  Local local;
  const int last = p - s;
  for (int j = 0; j <= last; ++j) local.point(j) = point(k - p + j);
  for (int j = 0; j < p + last; ++j) local.knots[static_cast<std::size_t>(j)] = knot(k - p + 1 + j);
  for (int r = 1; r <= last; ++r) local.step(p, r, last, t);
  return local.point(last);
}

Vector BSpline::derivative(double t, bool from_left) const {
  const int p = degree_;
  int k = interval(t);
  if (closed_ && t >= last_parameter()) t = first_parameter();
  if (from_left && (closed_ || t > first_parameter()))
    while (knot(k) >= t) --k;  // on a closed curve this may cross the seam
  Local local;                 // the derivative has degree p - 1; its knots are the curve's without the two outermost
  for (int j = 1; j <= p; ++j) {
    const int i = k - p + j;
    local.point(j - 1) = p / (knot(i + p) - knot(i)) * (point(i) - point(i - 1));
  }
  for (int j = 0; j < 2 * (p - 1); ++j) local.knots[static_cast<std::size_t>(j)] = knot(k - p + 2 + j);
  for (int r = 1; r < p; ++r) local.step(p - 1, r, p - 1, t);
  return local.point(p - 1);
}

void BSpline::extract(double t0, std::span<Point> out) const {
  const int p = degree_;
  assert(out.size() == static_cast<std::size_t>(p) + 1);
  const int k = interval(t0);
  const double from = knot(k), to = knot(k + 1);
  Local whole;
  for (int j = 0; j <= p; ++j) whole.point(j) = point(k - p + j);
  for (int j = 0; j < 2 * p; ++j) whole.knots[static_cast<std::size_t>(j)] = knot(k - p + 1 + j);
  // Both spans at a break take its point from the same function, so that they agree bit for bit.
  out.front() = evaluate(from);
  out.back() = evaluate(to);
  for (int b = 1; b < p; ++b) {  // the blossom with `from` as p - b of its arguments and `to` as b of them
    Local local = whole;
    for (int r = 1; r <= p; ++r) local.step(p, r, p, r <= p - b ? from : to);
    out[static_cast<std::size_t>(b)] = local.point(p);
  }
}

}  // namespace pliant
