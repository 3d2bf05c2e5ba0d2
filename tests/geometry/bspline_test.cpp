// tests/geometry/bspline_test.cpp: laws of B-splines: knot insertion and removal, evaluation, extraction.
#include "pliant/geometry/spline/bspline.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/control_net.h"

namespace {
using namespace pliant;

/// A curve with 1 to 8 spans of unequal length, repeated knots (of a closed curve at the seam too), random points.
BSpline random_curve(int degree, bool closed, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto up_to = [&random](int n) { return 1 + static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<double> breaks{3 * unit(random) - 1};
  for (int i = closed ? std::max(3, degree) : up_to(8); i > 0; --i)
    breaks.push_back(breaks.back() + 0.05 + unit(random));
  std::vector<double> knots;
  const auto repeat = [&knots](double t, int times) { knots.insert(knots.end(), static_cast<std::size_t>(times), t); };
  const int seam = up_to(degree), at_start = up_to(seam);
  repeat(breaks.front(), closed ? at_start : degree + 1);
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) repeat(breaks[i], unit(random) < 0.5 ? 1 : up_to(degree));
  repeat(breaks.back(), closed ? seam - at_start + 1 : degree + 1);
  const std::size_t count = closed ? knots.size() - 1 : knots.size() - static_cast<std::size_t>(degree) - 1;
  std::vector<Point> points(count);
  for (Point& p : points) p = {unit(random), unit(random)};
  REQUIRE_FALSE(BSpline::fault(degree, closed, knots, points));
  return BSpline(degree, closed, knots, points);
}

std::vector<double> parameters(const BSpline& curve, int steps = 60) {
  std::vector<double> all = curve.breaks();
  for (int i = 1; i < steps; ++i) all.push_back(curve.first_parameter() + curve.period() * i / steps);
  return all;
}

double greatest_distance(const BSpline& a, const BSpline& b) {
  double most = 0;
  for (const double t : parameters(a)) most = std::max(most, distance(a.evaluate(t), b.evaluate(t)));
  return most;
}

std::vector<Point> extracted(const BSpline& curve, double t0) {
  std::vector<Point> polygon(static_cast<std::size_t>(curve.degree()) + 1);
  curve.extract(t0, polygon);
  return polygon;
}

Point bezier(std::vector<Point> b, double s) {
  for (std::size_t n = b.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) b[i] = (1 - s) * b[i] + s * b[i + 1];
  return b[0];
}

/// The r-th derivative of a Bézier curve of parameter length h at one end.
Point end_derivative(std::vector<Point> b, int r, double h, bool at_end) {
  for (int n = 0; n < r; ++n) {
    const double factor = static_cast<double>(b.size() - 1) / h;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) b[i] = factor * (b[i + 1] - b[i]);
    b.pop_back();
  }
  return at_end ? b.back() : b.front();
}

const BSpline unit_square(1, true, {0, 1, 2, 3, 4}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});

}  // namespace

#define EVERY_CURVE                            \
  const int degree = GENERATE(1, 2, 3, 4, 5);  \
  const bool closed = GENERATE(false, true);   \
  for (unsigned seed = 0; seed < 60; ++seed) { \
    CAPTURE(degree, closed, seed);             \
    const BSpline curve = random_curve(degree, closed, seed);
#define END_EVERY_CURVE }

TEST_CASE("knot insertion keeps the curve, its first knot and its parameter range", "[geometry][property]") {
  EVERY_CURVE
  std::vector<double> places = parameters(curve, 7);
  for (const double t : places) {
    if (!closed && (t == curve.first_parameter() || t == curve.last_parameter())) continue;
    if (curve.multiplicity(t) == degree) continue;
    BSpline finer = curve;
    finer.insert_knot(t);
    CHECK_FALSE(BSpline::fault(degree, closed, finer.knots().to_vector(), finer.points().to_vector()));
    CHECK(finer.multiplicity(t) == curve.multiplicity(t) + 1);
    CHECK(finer.first_parameter() == curve.first_parameter());
    CHECK(finer.last_parameter() == curve.last_parameter());
    CHECK(greatest_distance(curve, finer) < 1e-14);
  }
  END_EVERY_CURVE
}

TEST_CASE("insertions and removals taken back leave the curve bit for bit, round the seam too",
          "[geometry][property]") {
  const bool closed = GENERATE(false, true);
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(closed, degree);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int inserted = 0, removed = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const BSpline before = random_curve(degree, closed, seed);
    const std::vector<double> breaks = before.breaks();
    BSpline curve = before;
    BSpline::Edits edits;
    const double t = seed % 4 == 0 ? breaks[1] : before.first_parameter() + unit(random) * before.period();
    if (before.multiplicity(t) < degree) {
      ++inserted;
      curve.insert_knot(t, &edits);
      CHECK(greatest_distance(before, curve) < 1e-13);
      CHECK(curve.multiplicity(t) == before.multiplicity(t) + 1);
    }
    for (const double knot : {breaks[seed % breaks.size()], breaks[0], breaks[1]})
      if (curve.remove_break(knot, &edits)) ++removed;
    CHECK_FALSE(BSpline::fault(degree, closed, curve.knots().to_vector(), curve.points().to_vector()));
    for (; !edits.empty(); edits.pop_back()) curve.take_back(edits.back());
    CHECK(curve.points() == before.points());
    CHECK(curve.knots() == before.knots());
  }
  CHECK(inserted > 10);
  CHECK(removed > 100);
}

TEST_CASE("removal undoes insertion to rounding, knots exactly", "[geometry][property]") {
  EVERY_CURVE
  for (const double t : parameters(curve, 7)) {
    if (!closed && (t == curve.first_parameter() || t == curve.last_parameter())) continue;
    if (curve.multiplicity(t) == degree) continue;
    BSpline changed = curve;
    changed.insert_knot(t);
    const auto foreseen = changed.removal_error(t);
    const auto error = changed.remove_knot(t);
    CHECK(foreseen == error);
    REQUIRE(error);
    CHECK(*error < 1e-14);
    REQUIRE(changed.knots() == curve.knots());
    for (std::size_t i = 0; i < curve.points().size(); ++i)
      CHECK(distance(changed.points()[i], curve.points()[i]) < 1e-14);
  }
  END_EVERY_CURVE
}

TEST_CASE("the error of a removal bounds the distance, and only points near the knot change", "[geometry][property]") {
  EVERY_CURVE
  for (const double t : curve.breaks()) {
    BSpline coarser = curve;
    const int s = curve.multiplicity(t);
    const auto error = coarser.remove_knot(t);
    if (!error) {
      CHECK(coarser.points() == curve.points());
      continue;
    }
    CHECK_FALSE(BSpline::fault(degree, closed, coarser.knots().to_vector(), coarser.points().to_vector()));
    if (coarser.multiplicity(t) > 0 || t != curve.first_parameter()) CHECK(coarser.multiplicity(t) == s - 1);
    CHECK(coarser.period() == Approx(curve.period()));
    double most = 0;
    for (const double u : parameters(curve, 200)) {
      const double same = u < coarser.first_parameter() ? u + coarser.period() : u;
      most = std::max(most, distance(curve.evaluate(u), coarser.evaluate(std::min(same, coarser.last_parameter()))));
    }
    CHECK(most <= *error * (1 + 1e-12) + 1e-13);
    int changed = 0;
    for (const Point& p : coarser.points())
      changed += std::find(curve.points().begin(), curve.points().end(), p) == curve.points().end();
    CHECK(changed <= degree - s);
  }
  END_EVERY_CURVE
}

TEST_CASE("a break goes with all its knots", "[geometry]") {
  BSpline curve = random_curve(3, true, 11);
  const BSpline old = curve;
  const double t = (curve.breaks()[1] + curve.breaks()[2]) / 2;
  for (int i = 0; i < 3; ++i) curve.insert_knot(t);
  const auto error = curve.remove_break(t);
  REQUIRE(error);
  CHECK(*error < 1e-13);
  CHECK(curve.knots() == old.knots());
  CHECK_FALSE(curve.remove_break(t));
  BSpline open = random_curve(2, false, 3);
  CHECK_FALSE(open.remove_break(open.first_parameter()));
  CHECK_FALSE(open.remove_knot(open.last_parameter()));
}

TEST_CASE("extracted spans trace the curve, meet bit for bit, and are C^(p - m) at their breaks",
          "[geometry][property]") {
  EVERY_CURVE
  const auto breaks = curve.breaks();
  REQUIRE(curve.span_count() + 1 == static_cast<int>(breaks.size()));
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    const auto here = extracted(curve, breaks[s]);
    const double h = breaks[s + 1] - breaks[s];
    for (int i = 0; i <= 10; ++i)
      CHECK(distance(bezier(here, i / 10.0), curve.evaluate(breaks[s] + h * i / 10)) < 1e-13);
    if (s + 2 == breaks.size() && !closed) continue;
    const std::size_t after = s + 2 < breaks.size() ? s + 1 : 0;
    const auto next = extracted(curve, breaks[after]);
    CHECK(here.back() == next.front());
    const double next_h = breaks[after + 1] - breaks[after];
    for (int r = 1; r <= degree - curve.multiplicity(breaks[after]); ++r) {
      const Point left = end_derivative(here, r, h, true), right = end_derivative(next, r, next_h, false);
      CHECK(distance(left, right) <= 1e-10 * std::pow(std::max(1 / h, 1 / next_h), r) + 1e-10);
    }
  }
  if (!closed) {
    CHECK(extracted(curve, breaks.front()).front() == curve.points().front());
    CHECK(extracted(curve, breaks[breaks.size() - 2]).back() == curve.points().back());
  }
  END_EVERY_CURVE
}

TEST_CASE("a curve of multiplicity p is its own extraction, bit for bit", "[geometry]") {
  const BSpline open(3, false, {0, 0, 0, 0, .1, .1, .1, .7, .7, .7, .7},
                     {{.1, .2}, {.3, .1}, {.7, .9}, {.2, .3}, {.5, .4}, {-.1, .6}, {.9, .9}});
  for (std::size_t s = 0; s < 2; ++s) {
    const auto polygon = extracted(open, s == 0 ? 0 : .1);
    for (std::size_t i = 0; i < 4; ++i) CHECK(polygon[i] == open.points()[3 * s + i]);
  }
}

TEST_CASE("derivatives agree with differences on either side of a break", "[geometry][property]") {
  EVERY_CURVE
  for (const double t : parameters(curve, 13)) {
    const double h = 1e-6;
    if (t + h < curve.last_parameter() && curve.multiplicity(t) <= 1 && curve.span_end(t) - t > 2 * h) {
      const Vector ahead = (curve.evaluate(t + h) - curve.evaluate(t)) / h;
      CHECK(distance(curve.derivative(t), ahead) < 1e-2);
    }
    if (t - h > curve.first_parameter() && t - curve.span_before(t) > 2 * h) {
      const Vector behind = (curve.evaluate(t) - curve.evaluate(t - h)) / h;
      const Vector exact = t == curve.last_parameter() && closed ? curve.derivative(curve.first_parameter(), true)
                                                                 : curve.derivative(t, true);
      CHECK(distance(exact, behind) < 1e-2);
    }
  }
  END_EVERY_CURVE
}

TEST_CASE("interpolation at the Greville abscissae reproduces every curve of the space", "[geometry][property]") {
  EVERY_CURVE
  const auto greville = curve.greville();
  std::vector<Point> values;
  for (const double t : greville) {
    CHECK(t >= curve.first_parameter());
    CHECK(t <= curve.last_parameter());
    values.push_back(curve.evaluate(t));
  }
  BSpline other = curve;
  for (std::size_t i = 0; i < values.size(); ++i) other.set_point(static_cast<int>(i), {});
  REQUIRE(other.interpolate(values));
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(distance(other.points()[i], curve.points()[i]) < 2e-13);
  END_EVERY_CURVE
}

TEST_CASE("interpolation keeps ends and points of multiplicity p exactly, and polynomials", "[geometry]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(degree, seed);
    BSpline curve = random_curve(degree, false, seed);
    const auto greville = curve.greville();
    const auto polynomial = [degree](double t) { return Point{t, 1 - t + std::pow(t, degree) / 3}; };
    std::vector<Point> values;
    for (const double t : greville) values.push_back(polynomial(t));
    REQUIRE(curve.interpolate(values));
    for (const double t : parameters(curve))
      CHECK(distance(curve.evaluate(t), polynomial(t)) < 1e-11 * (1 + std::pow(std::fabs(t), degree)));
    CHECK(curve.points().front() == values.front());
    CHECK(curve.points().back() == values.back());
    for (std::size_t i = 0; i < greville.size(); ++i)
      if (curve.multiplicity(greville[i]) == degree) CHECK(curve.points()[i] == values[i]);
  }
}

TEST_CASE("interpolation serves thousands of points, closed too", "[geometry]") {
  const int degree = GENERATE(2, 3, 5);
  const int count = 5000;
  std::vector<double> knots;
  std::vector<Point> points;
  std::mt19937 random(5);
  for (int i = 0; i <= count; ++i)
    knots.push_back(i + 0.9 * (i % count == 0 ? 0 : std::generate_canonical<double, 53>(random)));
  for (int i = 0; i < count; ++i) points.push_back({std::cos(i * 0.01), std::sin(i * 0.013)});
  const BSpline curve(degree, true, knots, points);
  std::vector<Point> values;
  for (const double t : curve.greville()) values.push_back(curve.evaluate(t));
  BSpline other(degree, true, knots, std::vector<Point>(points.size()));
  REQUIRE(other.interpolate(values));
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) most = std::max(most, distance(points[i], other.points()[i]));
  CHECK(most < 1e-11);
}

TEST_CASE("elevation keeps the curve and raises every multiplicity by one", "[geometry][property]") {
  EVERY_CURVE
  const BSpline higher = curve.elevated();
  CHECK(higher.degree() == degree + 1);
  CHECK_FALSE(BSpline::fault(degree + 1, closed, higher.knots().to_vector(), higher.points().to_vector()));
  CHECK(higher.breaks() == curve.breaks());
  for (const double t : curve.breaks()) CHECK(higher.multiplicity(t) == curve.multiplicity(t) + 1);
  CHECK(greatest_distance(curve, higher) < 1e-14);
  if (!closed)
    CHECK((higher.points().front() == curve.points().front() && higher.points().back() == curve.points().back()));
  END_EVERY_CURVE
}

TEST_CASE("spans are found from both sides, round the seam", "[geometry]") {
  const BSpline closed(3, true, {0, 0, 1, 3, 4, 4}, {{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 2}});
  CHECK(closed.span_count() == 3);
  CHECK(closed.multiplicity(0) == 3);  // twice at the start, and once more a period later
  CHECK(closed.multiplicity(4) == 3);
  CHECK(closed.span_before(0) == 3);
  CHECK(closed.knot(-1) == 0);
  CHECK(closed.knot(-2) == -1);
  CHECK(closed.knot(6) == 4);
  CHECK(closed.knot(7) == 5);
  CHECK(unit_square.breaks() == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(unit_square.span_end(3) == 4);
  CHECK(unit_square.span_end(4) == 1);
  CHECK(unit_square.span_before(0) == 3);
  CHECK(unit_square.span_before(4) == 3);
  const BSpline open(2, false, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 2}});
  CHECK(open.span_count() == 2);
  CHECK(open.span_before(2) == 1);
  CHECK(open.multiplicity(1) == 2);
  CHECK(open.multiplicity(0.5) == 0);
}

TEST_CASE("area and length are those of known shapes", "[geometry]") {
  CHECK(unit_square.area() == 1);
  CHECK(unit_square.arc_length() == Approx(4).epsilon(1e-14));
  // A cubic periodic spline through many points of a circle, far from the origin.
  const int count = 400;
  std::vector<double> knots;
  std::vector<Point> values;
  for (int i = 0; i <= count; ++i) knots.push_back(i);
  BSpline circle(3, true, knots, std::vector<Point>(count));
  for (const double t : circle.greville()) {
    const double angle = 2 * std::numbers::pi * t / count;
    values.push_back(Point{100, -50} + Point{std::cos(angle), std::sin(angle)});
  }
  REQUIRE(circle.interpolate(values));
  CHECK(circle.area() == Approx(std::numbers::pi).epsilon(1e-8));
  CHECK(circle.arc_length() == Approx(2 * std::numbers::pi).epsilon(1e-8));
  // y = x^2 from 0 to 1: length sqrt(5)/2 + asinh(2)/4.
  const BSpline parabola(2, false, {0, 0, 0, 1, 1, 1}, {{0, 0}, {0.5, 0}, {1, 1}});
  CHECK(parabola.arc_length() == Approx(std::sqrt(5.0) / 2 + std::asinh(2.0) / 4).epsilon(1e-13));
  CHECK(parabola.area() == Approx(1.0 / 6).epsilon(1e-14));
}

TEST_CASE("what is not a B-spline is refused with its place", "[geometry]") {
  const std::vector<Point> four{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto fault = [&](int degree, bool closed, std::vector<double> knots) {
    return BSpline::fault(degree, closed, knots, four).value_or("");
  };
  CHECK(fault(1, true, {0, 1, 2, 3, 4}).empty());
  CHECK(fault(2, true, {0, 1, 2, 1.5, 4}) == "knots/3 is 1.5, but knots/2 is 2: knots do not decrease");
  CHECK(fault(2, true, {0, 1, 2, 3}).starts_with("knots: 4 knots"));
  CHECK(fault(2, true, {0, 1, 1, 1, 4}).starts_with("knots/3"));
  CHECK(fault(2, true, {0, 0, 1, 4, 4}).starts_with("knots/0"));
  CHECK(fault(5, true, {0, 1, 2, 3, 4}).starts_with("points"));
  CHECK(fault(2, true, {0, 1, 2, 3, HUGE_VAL}).starts_with("knots/4"));
  CHECK(fault(2, true, {0, 0, 0, 0, 0}).starts_with("knots"));
  CHECK(fault(2, true, {0, 1e-30, 1, 2, 3}).starts_with("knots/1"));
  CHECK(fault(0, true, {0, 1, 2, 3, 4}).starts_with("degree"));
  CHECK(fault(2, false, {0, 0, 0, 1, 2, 2, 2}).empty());
  CHECK(fault(2, false, {0, 0, 0.5, 1, 2, 2, 2}).starts_with("knots/2"));
  CHECK(fault(2, false, {0, 0, 0, 0, 2, 2, 2}).starts_with("knots/3"));
  CHECK(fault(2, false, {0, 0, 0, 2, 2, 2, 2}).starts_with("knots/3"));
  CHECK(fault(3, false, {0, 0, 0, 0, 2, 2, 2, 2}).empty());
  const std::vector<Point> broken{{0, 0}, {1, NAN}, {1, 1}, {0, 1}};
  CHECK(BSpline::fault(1, true, std::vector<double>{0, 1, 2, 3, 4}, broken) == "points/1 is not finite");
}
