// tests/geometry/validity_test.cpp: certificates of validity agree with exact arithmetic.
#include "pliant/geometry/validity/validity.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/exact_validity.h"
#include "pliant/geometry/validity/jacobian.h"
#include "support/exact_jacobian.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::vector<Point> scaled(std::vector<Point> net, double factor) {
  for (Point& p : net) p *= factor;
  return net;
}

/// The same element seen from another corner.
std::vector<Point> rotated(int degree, const std::vector<Point>& net) {
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<Point> result(net.size());
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    result[index(n)] = net[index(layout.index(j, k))];
  }
  return result;
}

}  // namespace

TEST_CASE("the certificate of a linear element is the sign of its area", "[geometry][oracle]") {
  std::map<Validity, int> count;
  for (int seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Point> net(3);
    for (Point& p : net) p = {1e6 + random.integer(-2, 2), random.integer(-2, 2) * 0x1p-40};
    const Rational area = (Rational(net[1].x) - Rational(net[0].x)) * (Rational(net[2].y) - Rational(net[0].y)) -
                          (Rational(net[1].y) - Rational(net[0].y)) * (Rational(net[2].x) - Rational(net[0].x));
    const Validity validity = certify(1, net);
    REQUIRE(validity == by_sign(area));
    ++count[validity];
  }
  for (const Validity v : {Validity::valid, Validity::degenerate, Validity::invalid}) CHECK(count[v] > 100);
}

TEST_CASE("the certificate of a quadratic element is the sign of its exact minimum", "[geometry][oracle]") {
  std::map<std::pair<Validity, Place>, int> count;
  for (int seed = 0; seed < 8000; ++seed) {
    CAPTURE(seed);
    const auto net = random_integer_net(2, seed, 1 + seed % 4, 1 + seed % 5);
    const Minimum minimum = exact_minimum(net);
    const Validity validity = certify(2, net);
    REQUIRE(validity == by_sign(minimum.value));
    ++count[{validity, minimum.place}];
  }
  for (const Place place : {Place::corner, Place::edge, Place::face}) CHECK(count[{Validity::invalid, place}] > 50);
  for (const Place place : {Place::corner, Place::edge}) CHECK(count[{Validity::valid, place}] > 50);
  // No valid element has its minimum inside. det is a form of signature (2, 2) on matrices. If it has an inner minimum,
  // J moves in a plane on which the form is positive definite, and at the minimum J is orthogonal to that plane, so
  // det J <= 0 there.
  CHECK(count[{Validity::valid, Place::face}] == 0);
  CHECK(count[{Validity::degenerate, Place::corner}] > 50);
  CHECK(count[{Validity::degenerate, Place::edge}] > 5);
}

TEST_CASE("quadratic elements of full-length doubles agree with the exact minimum", "[geometry][oracle]") {
  for (int seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    auto net = straight_net(2, {0, 0}, {1, 0}, {0, 1});
    for (Point& p : net) p += random.point(-0.3, 0.3);
    REQUIRE(certify(2, net) == by_sign(exact_minimum(net).value));
  }
}

TEST_CASE("quadratic slivers as thin as a few last places are decided exactly, too", "[geometry][oracle]") {
  std::map<Validity, int> count;
  for (int seed = 0; seed < 2000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Point a = random.point(0.5, 1);
    const Point b = random.point(0.5, 1);
    auto net = straight_net(2, a, b, 0.25 * a + 0.75 * b);
    for (Point& p : net) p += {random.integer(-9, 9) * 0x1p-51, random.integer(-9, 9) * 0x1p-51};
    for (std::size_t n = 3; n < 6; ++n) net[n] = 0.5 * (net[n - 3] + net[(n - 2) % 3]);  // nearly straight
    const Validity validity = certify(2, net);
    REQUIRE(validity == by_sign(exact_minimum(net).value));
    ++count[validity];
  }
  CHECK(count[Validity::valid] > 20);
  CHECK(count[Validity::invalid] > 20);
}

TEST_CASE("floating point and integers give the same certificate", "[geometry][oracle]") {
  for (int seed = 0; seed < 600; ++seed) {
    const int degree = 1 + seed % 6;
    CAPTURE(seed, degree);
    Random random(seed);
    auto net = straight_net(degree, {0, 0}, {1, 0.125}, {0.25, 1});
    const double amount = random.real(0.1, 0.5) / degree;
    for (Point& p : net) p += random.point(-amount, amount);
    REQUIRE(certify(degree, net) == certify_exactly(degree, net, -1).validity);
  }
}

TEST_CASE("cubic and quartic certificates are never contradicted by exact values", "[geometry][oracle]") {
  const int degree = GENERATE(3, 4);
  std::map<Validity, int> count;
  for (int seed = 0; seed < 1500; ++seed) {
    CAPTURE(seed, degree);
    const auto net = random_integer_net(degree, seed, 2, 1 + seed % 3);
    const Validity validity = certify(degree, net);
    int sign = sign_of_sampled_minimum(degree, net, 12);
    if (sign == 0) sign = sign_of_sampled_minimum(degree, net, 100);  // a zero may hide a lower place elsewhere
    REQUIRE(validity == (sign > 0 ? Validity::valid : sign < 0 ? Validity::invalid : Validity::degenerate));
    ++count[validity];
  }
  CHECK(count[Validity::valid] > 200);
  CHECK(count[Validity::invalid] > 200);
}

TEST_CASE("a minimum of exactly zero is degenerate wherever it is, and one unit lower invalid", "[geometry][oracle]") {
  const int degree = GENERATE(2, 3, 4);
  // Places inside, on each edge and at a corner; they are dyadic, so that the control points are exact.
  const std::complex<double> centre =
      GENERATE(std::complex<double>(0.25, 0.375), std::complex<double>(0.625, 0), std::complex<double>(0, 0.125),
               std::complex<double>(0.375, 0.625), std::complex<double>(0, 0));
  CAPTURE(degree, centre);
  CHECK(certify(degree, power_net(degree, centre)) == Validity::degenerate);
  // det J is negative only in a disk of radius r with p r^(p - 1) = tilt: corners and edges, or all but the centre,
  // stay positive.
  CHECK(certify(degree, power_net(degree, centre, 0x1p-20)) == Validity::invalid);
}

TEST_CASE("a minimum far below the rounding errors is found positive", "[geometry][oracle]") {
  // The zero of det J is outside by 2^-30, so the minimum is p^4 2^(-60 (p - 1)).
  CHECK(certify(2, power_net(2, {0.375, -0x1p-30})) == Validity::valid);
  CHECK(certify(2, power_net(2, {0.375, 0x1p-30})) == Validity::degenerate);
  CHECK(certify(2, power_net(2, {0.375, -0x1p-30}, 0x1p-28)) == Validity::invalid);
  CHECK(certify(3, power_net(3, {0.375, -0x1p-14})) == Validity::valid);
}

TEST_CASE("certificates do not depend on scale, from 1e-150 to 1e150", "[geometry][property]") {
  for (int seed = 0; seed < 400; ++seed) {
    const int degree = 1 + seed % 4;
    CAPTURE(seed, degree);
    const auto net = random_integer_net(degree, seed, 2, 1 + seed % 4);
    const Validity validity = certify(degree, net);
    CHECK(certify(degree, scaled(net, 0x1p500)) == validity);
    CHECK(certify(degree, scaled(net, 0x1p-500)) == validity);
    CHECK(certify(degree, scaled(net, 0x1p-1060)) == validity);
    CHECK(certify(degree, scaled(net, 0x1p1019)) == validity);
    auto anisotropic = net;
    for (Point& p : anisotropic) p = {p.x * 0x1p500, p.y * 0x1p-500};
    CHECK(certify(degree, anisotropic) == validity);
  }
}

TEST_CASE("certificates do not depend on which corner is first", "[geometry][property]") {
  for (int seed = 0; seed < 600; ++seed) {
    const int degree = 2 + seed % 3;
    CAPTURE(seed, degree);
    const auto net = random_integer_net(degree, seed, 2, 1 + seed % 3);
    const auto second = rotated(degree, net);
    const auto third = rotated(degree, second);
    CHECK(certify(degree, net) == certify(degree, second));
    CHECK(certify(degree, net) == certify(degree, third));
  }
}

TEST_CASE("elements that are valid by construction are certified in every degree", "[geometry][property]") {
  for (int degree = 1; degree <= max_degree; ++degree) {
    for (int seed = 0; seed < 30; ++seed) {
      CAPTURE(degree, seed);
      auto net = random_valid_net(degree, seed);
      CHECK(certify(degree, net) == Validity::valid);
      std::swap(net[0], net[1]);
      CHECK(certify(degree, net) == Validity::invalid);
    }
  }
}

TEST_CASE("an element collapsed to a segment or a point is degenerate", "[geometry]") {
  for (int degree = 1; degree <= 5; ++degree) {
    CAPTURE(degree);
    CHECK(certify(degree, straight_net(degree, {0, 0}, {4, 8}, {1, 2})) == Validity::degenerate);
    CHECK(certify(degree, std::vector<Point>(index(net_size(degree)), Point{0.1, 0.3})) == Validity::degenerate);
  }
}

TEST_CASE("a reflex angle between smoothly joined edges is never valid", "[geometry]") {
  // Corner 0 is smooth: its two edges leave in opposite directions.
  const std::vector<Point> net{{0, 0}, {2, 2}, {-2, 2}, {1, 0}, {0, 3}, {-1, 0}};
  CHECK(certify(2, net) == Validity::degenerate);
}

TEST_CASE("a cusp's corner is forgiven there and nowhere else", "[geometry]") {
  // The element is between the parabola y = x^2 / 2 and its tangent y = 0, which meet at corner 0 with angle 0.
  const std::vector<Point> cusp{{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0}, {1, 0.25}, {0.5, 0}};
  CHECK(certify(2, cusp) == Validity::degenerate);
  CHECK(certify_cusp(2, cusp, 0) == Validity::valid);
  CHECK(certify_cusp(2, cusp, 1) == Validity::degenerate);
  CHECK(certify_cusp(2, rotated(2, cusp), 1) == Validity::valid);
  CHECK(certify_cusp(2, rotated(2, rotated(2, cusp)), 2) == Validity::valid);
  for (const double scale : {0x1p-500, 0x1p500}) CHECK(certify_cusp(2, scaled(cusp, scale), 0) == Validity::valid);

  auto crossed = cusp;  // the parabola starts below its "tangent"
  crossed[5].y = -0x1p-50;
  CHECK(certify_cusp(2, crossed, 0) == Validity::invalid);
  auto open = cusp;
  open[5].y = 0x1p-50;
  CHECK(certify_cusp(2, open, 0) == Validity::valid);
  CHECK(certify(2, open) == Validity::valid);
  auto both = cusp;  // a second zero, at corner 2
  both[4] = {1, 0.5};
  CHECK(certify_cusp(2, both, 0) != Validity::valid);
}

TEST_CASE("cusps of higher degree are certified", "[geometry]") {
  // The same region is elevated exactly: with multiples of 12 the control points stay integers.
  const NetLayout& layout = NetLayout::of(3);
  const std::vector<Point> low = scaled({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0}, {1, 0.25}, {0.5, 0}}, 12);
  std::vector<Point> net(10);
  for (int n = 0; n < 10; ++n) {
    const auto [i, j, k] = layout.exponents(n);
    Point sum;
    if (i > 0) sum += i * low[index(NetLayout::of(2).index(i - 1, j))];
    if (j > 0) sum += j * low[index(NetLayout::of(2).index(i, j - 1))];
    if (k > 0) sum += k * low[index(NetLayout::of(2).index(i, j))];
    net[index(n)] = {sum.x / 3, sum.y / 3};
  }
  CHECK(certify(3, net) == Validity::degenerate);
  CHECK(certify_cusp(3, net, 0) == Validity::valid);
  CHECK(certify_cusp(3, net, 1) == Validity::degenerate);
}

TEST_CASE("forgiving a corner of a quadratic element changes the certificate only if det J is 0 there",
          "[geometry][property]") {
  // Forgiving a corner changes nothing where det J is not zero there.
  int cusps = 0;
  for (int seed = 0; seed < 5000; ++seed) {
    CAPTURE(seed);
    const auto net = random_integer_net(2, seed, 1 + seed % 3, 1 + seed % 4);
    const double corner = jacobian_at(2, net, {1, 0, 0});  // exact: small integers
    const Validity forgiving = certify_cusp(2, net, 0);
    const Validity strict = certify(2, net);
    if (corner != 0) {
      REQUIRE(forgiving == strict);
    } else if (strict == Validity::invalid) {
      REQUIRE(forgiving == Validity::invalid);
    } else {
      ++cusps;
      double least = HUGE_VAL;
      for (const Barycentric& xi : lattice(32))
        if (xi[0] != 1) least = std::fmin(least, jacobian_at(2, net, xi));
      if (forgiving == Validity::valid) REQUIRE(least > 0);
    }
  }
  CHECK(cusps > 20);
}

TEST_CASE("the range of det J encloses its extrema to the width that was asked for", "[geometry][oracle]") {
  for (int seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const auto net = random_integer_net(2, seed, 2, 3);
    std::vector<double> coefficients(6);
    jacobian_net(2, net, coefficients);
    double greatest = 0;
    for (const double c : coefficients) greatest = std::fmax(greatest, std::fabs(c));
    const double width = seed % 2 ? 1e-3 : 1e-9;
    const JacobianRange range = jacobian_range(2, net, width);
    const Rational least = exact_minimum(net).value;
    REQUIRE(Rational(range.least.lower) <= least);
    REQUIRE(least <= Rational(range.least.upper));
    REQUIRE(range.least.upper - range.least.lower <= width * greatest * 1.001);
    auto mirrored = net;
    for (Point& p : mirrored) p.x = -p.x;
    const Rational most = -exact_minimum(mirrored).value;
    REQUIRE(Rational(range.greatest.lower) <= most);
    REQUIRE(most <= Rational(range.greatest.upper));
    REQUIRE(range.greatest.upper - range.greatest.lower <= width * greatest * 1.001);
  }
}

TEST_CASE("the range of det J holds for every degree and scale", "[geometry][property]") {
  for (int degree = 1; degree <= max_degree; ++degree) {
    for (const double scale : {1.0, 1e-150, 1e150}) {
      CAPTURE(degree, scale);
      const auto net = scaled(random_valid_net(degree, degree), scale);
      const JacobianRange range = jacobian_range(degree, net);
      CHECK(range.least.lower > 0);
      CHECK(range.least.upper >= range.least.lower);
      for (const Barycentric& xi : lattice(8)) {
        CHECK(jacobian_at(degree, net, xi) >= range.least.lower * (1 - 1e-12));
        CHECK(jacobian_at(degree, net, xi) <= range.greatest.upper * (1 + 1e-12));
      }
      CHECK(range.greatest.upper - range.greatest.lower <= 1.1e-3 * range.greatest.upper);
    }
  }
}
