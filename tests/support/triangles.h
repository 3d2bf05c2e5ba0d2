// tests/support/triangles.h: control nets of single elements, random by seed or with a known det J.
#pragma once
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant::samples {

/// Random numbers that are the same on every platform (std::uniform_real_distribution does not promise that).
class Random {
 public:
  explicit Random(int seed) : engine_(static_cast<std::uint64_t>(seed) * 0x9E3779B97F4A7C15u + 1) {}
  /// A number in [low, high).
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  /// An integer in low..high.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  Point point(double low, double high) {
    const double x = real(low, high);
    return {x, real(low, high)};
  }
  /// A point inside the triangle.
  Barycentric barycentric() {
    double a = real(0, 1);
    double b = real(0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return {1 - a - b, a, b};
  }

 private:
  std::mt19937_64 engine_;
};

/// The points (i, j, k) / n of the triangle.
inline std::vector<Barycentric> lattice(int n) {
  std::vector<Barycentric> points;
  for (int i = n; i >= 0; --i)
    for (int j = n - i; j >= 0; --j)
      points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n, static_cast<double>(n - i - j) / n});
  return points;
}

/// The straight triangle abc as a net of any degree.
inline std::vector<Point> straight_net(int degree, const Point& a, const Point& b, const Point& c) {
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<Point> net;
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    net.push_back((i * a + j * b + k * c) / degree);
  }
  return net;
}

/// A curved element that is valid by construction. Every control point of a unit equilateral triangle is moved by at
/// most amount / degree in x and in y. So the partials change by at most 2 sqrt(2) amount, and for amount <= 0.1 each
/// of their cross products stays above 0.866 - 2 * 0.283 - 0.08 > 0. Then the element is turned, enlarged and moved.
inline std::vector<Point> random_valid_net(int degree, int seed, double amount = 0.1) {
  Random random(seed);
  std::vector<Point> net = straight_net(degree, {0, 0}, {1, 0}, {0.5, std::sqrt(0.75)});
  const double angle = random.real(0, 6.28);
  const double size = random.real(0.1, 10);
  const Point shift = random.point(-5, 5);
  for (Point& p : net) {
    p += random.point(-amount / degree, amount / degree);
    p = Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y} * size +
        shift;
  }
  return net;
}

/// Any element: a straight right triangle of the given size plus integers of -range..range; exact in doubles.
inline std::vector<Point> random_integer_net(int degree, int seed, int size, int range) {
  Random random(seed);
  const double p = degree * size;
  std::vector<Point> net = straight_net(degree, {0, 0}, {p, 0}, {0, p});
  for (Point& q : net) {
    q.x += random.integer(-range, range);
    q.y += random.integer(-range, range);
  }
  return net;
}

/// The net of p ((z - centre)^p + tilt conj(z)), where z = x + iy on the unit right triangle and p is the degree. Its
/// det J = p^2 (p^2 |z - centre|^(2p - 2) - tilt^2) is least at the centre. Control points are products of differences
/// between corners and the centre, which are exact in doubles if these are short dyadics.
inline std::vector<Point> power_net(int degree, std::complex<double> centre, double tilt = 0) {
  using Complex = std::complex<double>;
  const Complex corners[3] = {Complex(0, 0) - centre, Complex(1, 0) - centre, Complex(0, 1) - centre};
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<Point> net;
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    Complex z = 1;  // the blossom of z^p is the product of its arguments
    for (int m = 0; m < i; ++m) z *= corners[0];
    for (int m = 0; m < j; ++m) z *= corners[1];
    for (int m = 0; m < k; ++m) z *= corners[2];
    z *= degree;
    z += tilt * Complex(j, -k);
    net.push_back({z.real(), z.imag()});
  }
  return net;
}

}  // namespace pliant::samples
