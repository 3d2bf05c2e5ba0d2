// tests/geometry/swept_validity_test.cpp: safe fractions of motions whose collapse is known.
#include "pliant/geometry/validity/swept_validity.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/geometry/validity/validity.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::vector<Point> between(const std::vector<Point>& from, const std::vector<Point>& to, double t) {
  std::vector<Point> net;
  for (std::size_t n = 0; n < from.size(); ++n) net.push_back((1 - t) * from[n] + t * to[n]);
  return net;
}

}  // namespace

TEST_CASE("a corner that crosses the opposite edge is stopped at the crossing", "[geometry][oracle]") {
  const int degree = GENERATE(range(1, 6));
  const double height = GENERATE(0.125, 1.0, 3.0);
  CAPTURE(degree, height);
  const auto from = straight_net(degree, {0, 0}, {1, 0}, {0, 1});
  const auto to = straight_net(degree, {0, 0}, {1, 0}, {0, -height});
  const double exact = 1 / (1 + height);  // when y is 0
  const double f = safe_fraction(degree, from, to);
  CHECK(f <= exact);
  CHECK(f >= exact - 1e-3);
}

TEST_CASE("rigid translation, growth and small rotation are safe as a whole", "[geometry]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const auto from = random_valid_net(degree, 7 * degree);
  auto to = from;
  for (Point& p : to) p += {30, -20};
  CHECK(safe_fraction(degree, from, to) == 1);
  for (Point& p : to) p *= 5;
  CHECK(safe_fraction(degree, from, to) == 1);
  for (std::size_t n = 0; n < to.size(); ++n) to[n] = from[n] + 0.9 * perpendicular(from[n]);
  CHECK(safe_fraction(degree, from, to) == 1);
  CHECK(safe_fraction(degree, from, from) == 1);
}

TEST_CASE("a straight motion to the half-turned element collapses half way", "[geometry][oracle]") {
  // det J = (1 - 2t)^2 det J(from): positive before and after, zero at t = 1/2 only.
  const int degree = GENERATE(range(1, 5));
  const auto from = random_valid_net(degree, degree);
  const auto to = between(from, from, 0);
  auto turned = to;
  for (Point& p : turned) p = -p;
  const double f = safe_fraction(degree, from, turned);
  CHECK(f <= 0.5);
  CHECK(f >= 0.499);
}

TEST_CASE("an element that is not valid has no safe motion", "[geometry]") {
  const auto good = straight_net(2, {0, 0}, {1, 0}, {0, 1});
  const auto bad = straight_net(2, {0, 0}, {0, 1}, {1, 0});
  const auto flat = straight_net(2, {0, 0}, {1, 0}, {2, 0});
  CHECK(safe_fraction(2, bad, good) == 0);
  CHECK(safe_fraction(2, flat, good) == 0);
  CHECK(safe_fraction(2, bad, bad) == 0);
}

TEST_CASE("an element is valid up to the safe fraction, and not valid soon after it", "[geometry][property]") {
  int stopped = 0;
  for (int seed = 0; seed < 400; ++seed) {
    const int degree = 1 + seed % 4;
    CAPTURE(seed, degree);
    const auto from = random_valid_net(degree, seed);
    Random random(seed + 1000);
    auto to = from;
    for (Point& p : to) p += random.point(-1, 1) * (3.0 / degree);
    const double f = safe_fraction(degree, from, to);
    REQUIRE(f >= 0);
    REQUIRE(f <= 1);
    for (int m = 0; m <= 8; ++m) CHECK(certify(degree, between(from, to, f * m / 8 * (1 - 1e-12))) == Validity::valid);
    if (f == 1) continue;
    ++stopped;
    bool is_blocked = false;
    for (int m = 1; m <= 50; ++m)
      is_blocked = is_blocked || certify(degree, between(from, to, f + 1e-3 * m / 50)) != Validity::valid;
    CHECK(is_blocked);
  }
  CHECK(stopped > 100);
}

TEST_CASE("the safe fraction does not depend on scale", "[geometry][property]") {
  for (int seed = 0; seed < 40; ++seed) {
    const int degree = 1 + seed % 3;
    CAPTURE(seed, degree);
    const auto from = random_valid_net(degree, seed);
    const auto to = random_valid_net(degree, seed + 1);
    auto small_from = from;
    auto small_to = to;
    for (Point& p : small_from) p *= 0x1p-500;
    for (Point& p : small_to) p *= 0x1p-500;
    CHECK(safe_fraction(degree, small_from, small_to) == safe_fraction(degree, from, to));
  }
}

TEST_CASE("an element with a cusp moves, though its corner is never valid", "[geometry]") {
  // The element is between the parabola y = x^2 / 2 and its tangent y = 0.
  const std::vector<Point> from{{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0}, {1, 0.25}, {0.5, 0}};
  auto moved = from;
  for (Point& p : moved) p = Point{0.6 * p.x - 0.3 * p.y, 0.3 * p.x + 0.6 * p.y} + Point{0.1, 0.7};
  CHECK(safe_fraction(2, from, moved) == 0);
  CHECK(safe_fraction(2, from, moved, 0) == 1);
  CHECK(safe_fraction(2, from, moved, 1) == 0);
  CHECK(safe_fraction(2, from, from, 0) == 1);
  auto crossed = from;  // half way to it the parabola crosses its tangent
  for (const std::size_t n : {2, 4}) crossed[n].y = -from[n].y;
  const double f = safe_fraction(2, from, crossed, 0);
  CHECK(f <= 0.5);
  CHECK(f >= 0.499);
}

TEST_CASE("the quick proof for quadratic elements agrees with the certificate at all times, at every size",
          "[geometry][property]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> noise(-1, 1);
  int safe = 0, unsafe = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto from = random_valid_net(2, trial % 50);
    auto to = from;
    const double push = 2 * std::pow(5, -(trial % 5));
    for (Point& p : to) p += push * Vector{noise(random), noise(random)};
    const double fraction = safe_fraction(2, from, to);
    CAPTURE(trial, push, fraction);
    ++(fraction == 1 ? safe : unsafe);
    for (int k = 0; k <= 16 && fraction == 1; ++k) REQUIRE(certify(2, between(from, to, k / 16.0)) == Validity::valid);
    for (const int exponent : {-900, -500, -300, 300, 400}) {
      auto small = from, moved = to;
      for (Point& p : small) p *= std::ldexp(1.0, exponent);
      for (Point& p : moved) p *= std::ldexp(1.0, exponent);
      CHECK(safe_fraction(2, small, moved) == fraction);
    }
  }
  CHECK(safe > 500);
  CHECK(unsafe > 100);
}

TEST_CASE("a motion to a place that is not finite is not safe", "[geometry]") {
  const int degree = GENERATE(range(1, 4));
  const double bad = GENERATE(HUGE_VAL, -HUGE_VAL, std::nan(""));
  const auto from = random_valid_net(degree, 1);
  for (std::size_t n = 0; n < from.size(); ++n) {
    auto to = from;
    to[n].y = bad;
    CAPTURE(degree, bad, n);
    CHECK_FALSE(safe_fraction(degree, from, to) == 1);
    CHECK_FALSE(safe_fraction(degree, to, from) == 1);
  }
}
