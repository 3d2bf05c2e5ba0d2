// tests/geometry/jacobian_test.cpp: laws of the net of det J.
#include "pliant/geometry/validity/jacobian.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

using Rational = boost::multiprecision::cpp_rational;

std::vector<double> jacobian_of(int degree, const std::vector<Point>& net) {
  std::vector<double> result(index(net_size(jacobian_degree(degree))));
  jacobian_net(degree, net, result);
  return result;
}

double value_of(int degree, const std::vector<double>& net, const Barycentric& xi) {
  double value = 0;
  evaluate_net(degree, 1, net, xi, {&value, 1});
  return value;
}

/// det J at (i, j, k) / n in rational numbers, by differentiating chi term by term.
Rational exact_jacobian(int degree, const std::vector<Point>& net, int i, int j, int k) {
  const Rational n = i + j + k;
  const Rational xi[3] = {i / n, j / n, k / n};
  const NetLayout& layout = NetLayout::of(degree);
  Rational slope[3][2] = {};  // of x and y, by xi1, xi2, xi3
  for (int m = 0; m < layout.size(); ++m) {
    for (std::size_t c = 0; c < 3; ++c) {
      Rational term = static_cast<long long>(layout.multinomial(m));
      for (std::size_t d = 0; d < 3; ++d) {
        const int e = layout.exponents(m)[d];
        if (d == c) term *= e;
        for (int f = 0; f < (d == c ? e - 1 : e); ++f) term *= xi[d];
      }
      slope[c][0] += term * Rational(net[index(m)].x);
      slope[c][1] += term * Rational(net[index(m)].y);
    }
  }
  return (slope[1][0] - slope[0][0]) * (slope[2][1] - slope[0][1]) -
         (slope[1][1] - slope[0][1]) * (slope[2][0] - slope[0][0]);
}

}  // namespace

TEST_CASE("the Jacobian net takes the exact values of det J", "[geometry][oracle]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const int seed = GENERATE(range(0, 3));
  CAPTURE(degree, seed);
  const auto net = random_valid_net(degree, seed);
  const auto jacobian = jacobian_of(degree, net);
  const double scale = std::fabs(*std::max_element(jacobian.begin(), jacobian.end()));
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; i + j <= 3; ++j) {
      const Barycentric xi{i / 3.0, j / 3.0, (3 - i - j) / 3.0};
      const double exact = exact_jacobian(degree, net, i, j, 3 - i - j).convert_to<double>();
      CHECK(value_of(jacobian_degree(degree), jacobian, xi) == Approx(exact).margin(1e-12 * scale));
      CHECK(jacobian_at(degree, net, xi) == Approx(exact).margin(1e-12 * scale));
    }
  }
}

TEST_CASE("the Jacobian net bounds det J everywhere in the triangle", "[geometry][property]") {
  const int seed = GENERATE(range(0, 50));
  const int degree = 2 + seed % 4;
  CAPTURE(seed, degree);
  const auto net = random_valid_net(degree, seed);
  const auto jacobian = jacobian_of(degree, net);
  const auto [least, greatest] = std::minmax_element(jacobian.begin(), jacobian.end());
  for (const Barycentric& xi : lattice(10)) {
    CHECK(jacobian_at(degree, net, xi) >= *least * (1 - 1e-12));
    CHECK(jacobian_at(degree, net, xi) <= *greatest * (1 + 1e-12));
  }
}

TEST_CASE("a straight element has twice its area in every coefficient", "[geometry]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const auto net = straight_net(degree, {1, 2}, {4, 3}, {2, 7});
  for (const double c : jacobian_of(degree, net)) CHECK(c == Approx(14).epsilon(1e-13));
  CHECK(element_area(degree, net) == Approx(7).epsilon(1e-14));
}

TEST_CASE("the area of an element is what Green's theorem says of its edges", "[geometry][oracle]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const int seed = GENERATE(range(0, 5));
  const auto net = random_valid_net(degree, seed);
  const NetLayout& layout = NetLayout::of(degree);
  double area = 0;  // half the integral of x dy - y dx
  for (int e = 0; e < 3; ++e) {
    std::vector<double> x, y, dx(index(degree)), dy(index(degree)), first(index(2 * degree)), second(index(2 * degree));
    for (int k = 0; k <= degree; ++k) {
      x.push_back(net[index(layout.edge_index(e, k))].x - net[0].x);
      y.push_back(net[index(layout.edge_index(e, k))].y - net[0].y);
    }
    differentiate_segment(degree, x, dx);
    differentiate_segment(degree, y, dy);
    multiply_segment(degree, x, degree - 1, dy, first);
    multiply_segment(degree, y, degree - 1, dx, second);
    area += (integrate_segment(2 * degree - 1, first) - integrate_segment(2 * degree - 1, second)) / 2;
  }
  CHECK(element_area(degree, net) == Approx(area).epsilon(1e-12));
}

TEST_CASE("det J of (z - c)^p + tilt conj z is the known radial function", "[geometry][oracle]") {
  const int p = GENERATE(range(1, max_degree + 1));
  const std::complex<double> centre(0.25, 0.375);
  const double tilt = 0.125;
  const auto net = power_net(p, centre, tilt);
  const auto jacobian = jacobian_of(p, net);
  for (const Barycentric& xi : lattice(7)) {
    const double r = std::abs(std::complex<double>(xi[1], xi[2]) - centre);
    const double expected = p * p * (p * p * (p == 1 ? 1 : std::pow(r, 2 * p - 2)) - tilt * tilt);
    CHECK(value_of(jacobian_degree(p), jacobian, xi) == Approx(expected).margin(1e-11));
  }
}

TEST_CASE("det J changes its sign when two corners are exchanged, and stays when corners rotate",
          "[geometry][property]") {
  const int seed = GENERATE(range(0, 20));
  const int degree = 1 + seed % 5;
  const auto net = random_valid_net(degree, seed);
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<Point> mirrored(net.size()), rotated(net.size());
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    mirrored[index(n)] = net[index(layout.index(j, i))];
    rotated[index(n)] = net[index(layout.index(j, k))];
  }
  CHECK(element_area(degree, mirrored) == Approx(-element_area(degree, net)).epsilon(1e-13));
  CHECK(element_area(degree, rotated) == Approx(element_area(degree, net)).epsilon(1e-13));
  for (const Barycentric& xi : lattice(3)) {
    const double here = jacobian_at(degree, net, xi);
    CHECK(jacobian_at(degree, mirrored, {xi[1], xi[0], xi[2]}) == Approx(-here).epsilon(1e-12));
  }
}
