// tests/geometry/predicates_test.cpp: orientation and in-circle agree with rational arithmetic.
#include "pliant/geometry/predicates.h"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace {
using namespace pliant;
using Rational = boost::multiprecision::cpp_rational;

int rational_orient(const Point& a, const Point& b, const Point& c) {
  const Rational ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  const Rational det = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  return det.sign();
}

int rational_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<Rational, 3>, 3> m;
  const std::array<Point, 3> rows{a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational x = Rational(rows[i].x) - Rational(d.x), y = Rational(rows[i].y) - Rational(d.y);
    m[i] = {x, y, x * x + y * y};
  }
  const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det.sign();
}

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : engine_(seed) {}
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  Point point(double scale = 1) { return {scale * unit(), scale * unit()}; }
  Point nudged(Point p) {
    for (int i = below(3); i > 0; --i) p.x = std::nextafter(p.x, unit() * 1e9);
    for (int i = below(3); i > 0; --i) p.y = std::nextafter(p.y, unit() * 1e9);
    return p;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace

TEST_CASE("orientation agrees with rational arithmetic, also for points nearly on a line", "[geometry][property]") {
  RandomPoints random(1);
  for (int i = 0; i < 3000; ++i) {
    const double shift = i % 2 ? 0 : 1e6;
    const Point a = random.point() + Point{shift, 0}, b = random.point() + Point{shift, shift};
    const Point c = random.nudged(a + random.unit() * (b - a));
    CAPTURE(i);
    CHECK(orient2d(a, b, c) == rational_orient(a, b, c));
    CHECK(orient2d(a, b, c) == orient2d(b, c, a));
    CHECK(orient2d(a, b, c) == -orient2d(b, a, c));
  }
}

TEST_CASE("in-circle agrees with rational arithmetic, also for points nearly on a circle", "[geometry][property]") {
  RandomPoints random(2);
  for (int i = 0; i < 1500; ++i) {
    const Point centre = random.point(i % 3 ? 1 : 1e4);
    std::array<Point, 4> p;
    for (Point& q : p) {
      const double angle = 3 * random.unit();
      q = random.nudged(centre + Point{std::cos(angle), std::sin(angle)});
    }
    CAPTURE(i);
    CHECK(in_circle(p[0], p[1], p[2], p[3]) == rational_circle(p[0], p[1], p[2], p[3]));
    CHECK(in_circle(p[0], p[1], p[2], p[3]) == -in_circle(p[1], p[0], p[2], p[3]));
  }
}

TEST_CASE("four corners of a rectangle are on one circle, exactly", "[geometry]") {
  const double x = 0.1, y = 0.7, w = 3.3, h = 1e-3;
  CHECK(in_circle({x, y}, {w, y}, {w, h}, {x, h}) == 0);
  CHECK(in_circle({0, 0}, {1, 0}, {0, 1}, {0.9, 0.9}) == 1);
  CHECK(in_circle({0, 0}, {1, 0}, {0, 1}, {1.1, 1.1}) == -1);
  CHECK(orient2d({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(orient2d({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}) == 0);
}

TEST_CASE("in-circle is exact on grids, and for points slightly off a grid", "[geometry][property]") {
  RandomPoints random(4);
  constexpr std::array spacings{1.0, 0.1, 1e-3, 1.0 / 3, 1e200, 1e-150, 12345.678};
  for (int i = 0; i < 20000; ++i) {
    const double h = spacings[static_cast<std::size_t>(random.below(7))];
    const double shift = h * (i % 4 ? random.below(100) : 0);
    const auto node = [&] { return Point{shift + h * random.below(4), shift + h * random.below(4)}; };
    std::array<Point, 4> p{node(), node(), node(), node()};
    if (i % 3 == 0) {  // a rectangle
      p[1] = {p[2].x, p[0].y};
      p[3] = {p[0].x, p[2].y};
    }
    if (i % 2)
      p[static_cast<std::size_t>(random.below(4))] = random.nudged(p[static_cast<std::size_t>(random.below(4))]);
    CAPTURE(i, h);
    CHECK(in_circle(p[0], p[1], p[2], p[3]) == rational_circle(p[0], p[1], p[2], p[3]));
    CHECK(in_circle(p[0], p[1], p[2], p[3]) == in_circle(p[1], p[2], p[0], p[3]));
  }
}

TEST_CASE("predicates neither underflow nor overflow", "[geometry][property]") {
  RandomPoints random(3);
  constexpr std::array scales{1e300, 1e-300, 5e-324, 1e-310, 1e160, 1e-160, 1.7e308, 1e77, 1.0};
  for (int i = 0; i < 1200; ++i) {
    std::array<Point, 4> p;
    const bool same = i % 2;
    const double scale = scales[static_cast<std::size_t>(random.below(9))];
    for (Point& q : p) {
      const double own = same ? scale : scales[static_cast<std::size_t>(random.below(9))];
      q = i % 3 ? random.point(own) : Point{own * (random.below(3) - 1), own * (random.below(3) - 1)};
    }
    if (i % 5 == 0) p[2] = p[0] / 2 + p[1] / 2;
    CAPTURE(i, scale);
    CHECK(orient2d(p[0], p[1], p[2]) == rational_orient(p[0], p[1], p[2]));
    CHECK(in_circle(p[0], p[1], p[2], p[3]) == rational_circle(p[0], p[1], p[2], p[3]));
  }
}
