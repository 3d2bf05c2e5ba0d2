// lib/pliant/geometry/spline/bspline_measure.cpp: area and length of a B-spline curve.
#include <array>
#include <cmath>
#include <cstddef>

#include "pliant/geometry/quadrature.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

/// Half the integral of x dy - y dx along a Bézier curve. The integrand is p times a sum of products B^p_i B^(p-1)_j,
/// each of which has the integral weight / (2p), so that the sum is divided by 4.
double bezier_area(int p, std::span<const Point> b) {
  const auto binomial = [](int n, int k) {
    double c = 1;
    for (int i = 1; i <= k; ++i) c = c * (n - k + i) / i;
    return c;
  };
  double sum = 0;
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j < p; ++j) {
      const auto from = static_cast<std::size_t>(j);
      const double weight = binomial(p, i) * binomial(p - 1, j) / binomial(2 * p - 1, i + j);
      sum += weight * cross(b[static_cast<std::size_t>(i)], b[from + 1] - b[from]);
    }
  return sum / 4;
}

double speed_integral(const BSpline& curve, double from, double to) {
  double sum = 0;
  for (const auto& [s, weight] : segment_rule(31)) sum += weight * length(curve.derivative(from + s * (to - from)));
  return sum * (to - from);
}

double refined_length(const BSpline& curve, double from, double to, double whole, int depth) {
  const double middle = from + (to - from) / 2;
  const double left = speed_integral(curve, from, middle), right = speed_integral(curve, middle, to);
  const double change = std::fabs(left + right - whole);
  if (depth == 0 || change <= 1e-14 * (left + right)) return left + right;
  return refined_length(curve, from, middle, left, depth - 1) + refined_length(curve, middle, to, right, depth - 1);
}

}  // namespace

double BSpline::swept_area(double t0, const Point& origin) const {
  std::array<Point, max_curve_degree + 1> buffer;
  const std::span<Point> polygon(buffer.data(), static_cast<std::size_t>(degree_) + 1);
  extract(t0, polygon);
  for (Point& b : polygon) b -= origin;
  return bezier_area(degree_, polygon);
}

double BSpline::area() const {
  // The area of a closed curve does not depend on the origin, and an origin nearby costs fewer digits.
  return area(closed_ ? points_.front() : Point{});
}

double BSpline::area(const Point& origin) const {
  const std::vector<double> all = breaks();
  double sum = 0;
  for (std::size_t s = 0; s + 1 < all.size(); ++s) sum += swept_area(all[s], origin);
  return sum;
}

double BSpline::arc_length() const {
  const std::vector<double> all = breaks();
  double sum = 0;
  for (std::size_t s = 0; s + 1 < all.size(); ++s)
    sum += refined_length(*this, all[s], all[s + 1], speed_integral(*this, all[s], all[s + 1]), 20);
  return sum;
}

}  // namespace pliant
