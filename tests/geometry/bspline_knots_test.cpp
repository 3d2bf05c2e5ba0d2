// tests/geometry/bspline_knots_test.cpp: knots of B-splines: insertion, removal, elevation, spans, and what is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/random_splines.h"
#include "pliant/geometry/spline/bspline.h"

using namespace pliant;
using namespace pliant::samples;

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

TEST_CASE("a curve is the same bit for bit when insertions and removals are taken back, also across the seam",
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

TEST_CASE("removal undoes insertion: points to rounding, knots exactly", "[geometry][property]") {
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

TEST_CASE("removing a break removes all copies of its knot", "[geometry]") {
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

TEST_CASE("spans are found from both ends, also across the seam", "[geometry]") {
  const BSpline closed(3, true, {0, 0, 1, 3, 4, 4}, {{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 2}});
  CHECK(closed.span_count() == 3);
  CHECK(closed.multiplicity(0) == 3);  // two copies at the start, and one a period later
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

TEST_CASE("members that make no B-spline are refused with the place of the fault", "[geometry]") {
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
