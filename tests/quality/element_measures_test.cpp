// tests/quality/element_measures_test.cpp: measures of many elements at once are those of each element alone.
#include "pliant/quality/element/element_measures.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/validity/bernstein_range.h"

using namespace pliant;

namespace {

/// Triangles of many sizes that share no points. They are straight, or curved hardly, gently or wildly; some are
/// inverted, flat, or collapsed to a point.
MeshData many_elements(int degree, unsigned seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  MeshData data;
  data.degree = degree;
  data.boundary.faces.push_back({"all", {}});
  const NetLayout& layout = NetLayout::of(degree);
  for (std::size_t t = 0; t < count; ++t) {
    const double size = std::ldexp(1.0, t % 50 == 7 ? -300 : t % 50 == 8 ? 300 : static_cast<int>(random() % 20) - 10);
    std::array<Point, 3> corner;
    for (Point& p : corner) p = size * Point{unit(random), unit(random)};
    if (t % 8 != 0 && cross(corner[1] - corner[0], corner[2] - corner[0]) < 0) std::swap(corner[1], corner[2]);
    if (t % 31 == 0) corner[2] = corner[0] + 0.5 * (corner[1] - corner[0]);
    if (t % 97 == 0) corner[1] = corner[0];
    const double bend = std::array{0.0, 0.0, 0.0, 1e-15, 1e-9, 1e-3, 0.1, 0.3}[random() % 8];
    for (int k = 0; k < layout.size(); ++k) {
      const auto [i, j, l] = layout.exponents(k);
      Point p = (i * corner[0] + j * corner[1] + l * corner[2]) / degree;
      if (k >= 3) p += bend * size * Point{unit(random), unit(random)};
      data.triangles.push_back(static_cast<PointId>(data.points.size()));
      data.points.push_back(p);
    }
    data.triangle_faces.push_back(0);
  }
  return data;
}

/// Equal to the sign of zero; NaN equals NaN.
bool is_same(double a, double b) {
  return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b);
}

}  // namespace

TEST_CASE("measures of many elements are those of each element alone, to the last bit", "[quality][property]") {
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(degree);
  const MeshData data = many_elements(degree, 5, 5000);
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < data.triangle_faces.size(); ++t) all.push_back(static_cast<TriangleId>(t));
  std::size_t next = 0;
  int valid = 0;
  measure_elements(data, all, 1e-3, [&](std::size_t first, std::span<const ElementMeasures> measures) {
    REQUIRE(first == next);
    for (const ElementMeasures& together : measures) {
      CAPTURE(next);
      const auto n = static_cast<std::size_t>(net_size(degree));
      const ElementMeasures alone =
          measure_element(data.boundary, degree, std::span(data.points).subspan(next * n, n), 1e-3);
      REQUIRE(together.validity == alone.validity);
      for (double ElementMeasures::*member :
           {&ElementMeasures::jacobian, &ElementMeasures::jacobian_max, &ElementMeasures::scaled_jacobian,
            &ElementMeasures::shape, &ElementMeasures::logical_tau, &ElementMeasures::control_tau,
            &ElementMeasures::distortion, &ElementMeasures::logical_angle, &ElementMeasures::turning_angle,
            &ElementMeasures::area}) {
        CAPTURE(together.*member, alone.*member);
        REQUIRE(is_same(together.*member, alone.*member));
      }
      for (std::size_t e = 0; e < 3; ++e) REQUIRE(is_same(together.edge_length[e], alone.edge_length[e]));
      valid += alone.validity == Validity::valid ? 1 : 0;
      ++next;
    }
  });
  CHECK(next == all.size());
  CHECK(valid > 2000);
}

TEST_CASE("extrema of polynomials lie in their enclosures, which are as narrow as asked for", "[geometry][property]") {
  const int degree = GENERATE(0, 1, 2, 4, 6);
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(degree, seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> coefficients(static_cast<std::size_t>(net_size(degree)));
    for (double& c : coefficients) c = unit(random);
    const double width = seed % 2 ? 1e-2 : 1e-6;
    const Bounds low = enclose_minimum(degree, coefficients, 1e-15, width);
    const Bounds high = enclose_maximum(degree, coefficients, 1e-15, width);
    REQUIRE(low.upper - low.lower <= 1.01 * width);
    REQUIRE(high.upper - high.lower <= 1.01 * width);
    double least = HUGE_VAL, most = -HUGE_VAL;
    std::vector<double> basis(coefficients.size());
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        bernstein_basis(degree, {double(i) / steps, double(j) / steps, double(steps - i - j) / steps}, basis);
        double value = 0;
        for (std::size_t n = 0; n < basis.size(); ++n) value += basis[n] * coefficients[n];
        least = std::min(least, value);
        most = std::max(most, value);
      }
    // Second derivatives are at most 4 d (d - 1), which bounds how far the minimum may be below the least sample.
    const double slack = 4.0 * degree * degree / (steps * steps);
    REQUIRE(low.lower <= least + 1e-12);
    REQUIRE(low.upper >= least - slack);
    REQUIRE(high.upper >= most - 1e-12);
    REQUIRE(high.lower <= most + slack);
  }
}
