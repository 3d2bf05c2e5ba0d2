// tests/flow/move_curves_test.cpp: moved splines: Greville points, order of error, continuity, area.
#include "pliant/flow/move_curves.h"

#include "flow_meshes.h"
#include "pliant/flow/runge_kutta.h"

using namespace pliant;

namespace {

BoundaryComplex circle(int degree, int spans, const Point& center, double radius) {
  BoundaryComplex boundary;
  boundary.faces.push_back({"cell", {}});
  Curve curve;
  curve.spline = samples::round_spline(degree, spans, center, radius);
  curve.left = 0;
  boundary.curves.push_back(std::move(curve));
  return boundary;
}

MovedBoundary carry_boundary(const BoundaryComplex& boundary, const VelocityField& velocity, double dt, int substeps,
                             bool keep_area = false) {
  return move_curves(
      boundary,
      {[&](int c, double t) {
         return carry(velocity, boundary.curves[static_cast<std::size_t>(c)].spline.evaluate(t), 0, dt, substeps);
       },
       [&](int v) { return carry(velocity, boundary.vertices[static_cast<std::size_t>(v)], 0, dt, substeps); }},
      keep_area);
}

}  // namespace

TEST_CASE("a moved spline passes through the moved Greville points", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const BoundaryComplex boundary = circle(degree, 11, {0.3, 0.2}, 0.4);
  const VelocityField velocity = make_flow("taylor-green", {{"length", 2}});
  const MovedBoundary moved = carry_boundary(boundary, velocity, 0.4, 4);
  REQUIRE(moved.status == MovedBoundary::Status::done);
  for (const double t : boundary.curves[0].spline.greville()) {
    const Point start = boundary.curves[0].spline.evaluate(t);
    CHECK(distance(moved.splines[0].evaluate(t), start + carry(velocity, start, 0, 0.4, 4)) < 1e-14);
  }
  CHECK(moved.splines[0].knots() == boundary.curves[0].spline.knots());
}

TEST_CASE("between the Greville points the curve is right to order degree + 1", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const VelocityField velocity = make_flow("taylor-green", {{"length", 2}});
  const auto error = [&](int spans) {
    const BoundaryComplex boundary = circle(degree, spans, {0.3, 0.2}, 0.4);
    const MovedBoundary moved = carry_boundary(boundary, velocity, 0.5, 10);
    double greatest = 0;
    for (int i = 0; i < 8 * spans; ++i) {
      const double t = i / 8.0;
      const Point start = boundary.curves[0].spline.evaluate(t);
      greatest = std::max(greatest, distance(moved.splines[0].evaluate(t), start + carry(velocity, start, 0, 0.5, 10)));
    }
    return greatest;
  };
  const double coarse = error(24);
  const double fine = error(48);
  CAPTURE(degree, coarse, fine);
  CHECK(std::log2(coarse / fine) > degree + 0.6);
}

TEST_CASE("keeping the area moves the curve by less than its error", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const BoundaryComplex boundary = circle(degree, 20, {-1.8, 0.7}, 0.4);
  const VelocityField velocity = make_flow("cylinder", {});
  const MovedBoundary plain = carry_boundary(boundary, velocity, 0.5, 10);
  const MovedBoundary kept = carry_boundary(boundary, velocity, 0.5, 10, true);
  const double before = boundary.curves[0].spline.area();
  const double miss = std::abs(plain.splines[0].area() - before);
  CAPTURE(degree, miss);
  CHECK(std::abs(kept.splines[0].area() - before) < 1e-15);
  CHECK(kept.area_offset > 0);
  CHECK(kept.area_offset == Approx(miss / plain.splines[0].arc_length()).epsilon(0.1));
}

TEST_CASE("knots of any multiplicity keep their continuity", "[flow]") {
  const int degree = GENERATE(2, 3, 4);
  BoundaryComplex boundary = circle(degree, 9, {0.3, 0.2}, 0.4);
  BSpline& spline = boundary.curves[0].spline;
  for (int m = 1; m < degree; ++m) spline.insert_knot(4);  // the curve may have a corner here now
  spline.insert_knot(2.5);
  const MovedBoundary moved = carry_boundary(boundary, make_flow("taylor-green", {{"length", 2}}), 0.4, 4);
  REQUIRE(moved.status == MovedBoundary::Status::done);
  CHECK(moved.splines[0].knots() == spline.knots());
  const Vector a = moved.splines[0].derivative(2.5, true), b = moved.splines[0].derivative(2.5);
  CHECK(std::abs(cross(a, b)) < 1e-12 * dot(a, b));
}
