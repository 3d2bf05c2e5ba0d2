// tests/fem/measures_test.cpp: areas, integrals, fluxes and shapes against closed forms, at several degrees.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "pliant/fem/measures/outline.h"
#include "pliant/fem/measures/sample_points.h"
#include "pliant/fem/measures/segment_extremes.h"
#include "pliant/mesh/documents/document_unit.h"
#include "support/sample_meshes.h"

using namespace pliant;
using std::numbers::pi;

namespace {

/// The disk of the samples, mapped affinely, with a linear field and a linear vector field.
MeshData mapped_disk(int degree, const Vector& first, const Vector& second, const Point& to, int spans = 16) {
  MeshData data = samples::disk(degree, spans);
  const auto map = [&](const Point& p) { return to + p.x * first + p.y * second; };
  for (Point& p : data.points) p = map(p);
  BSpline& spline = data.boundary.curves[0].spline;
  for (int i = 0; i < static_cast<int>(spline.points().size()); ++i)
    spline.set_point(i, map(spline.points()[static_cast<std::size_t>(i)]));
  samples::add_field(data, "c", 1, [](const Point& p) { return std::vector{2 * p.x - 3 * p.y + 1}; });
  samples::add_field(data, "v", 2, [](const Point& p) { return std::vector{p.x + 4 * p.y, 5 * p.x - p.y + 2}; });
  samples::add_field(data, "w", 2, [](const Point& p) { return std::vector{3 * p.x, 2 * p.y - p.x}; });
  return data;
}

Outline all_curves(const Mesh& mesh) {
  std::vector<CurveId> ids;
  for (std::size_t c = 0; c < mesh.boundary().curves.size(); ++c) ids.push_back(static_cast<CurveId>(c));
  return outline_of_curves(mesh, ids);
}

double flux(const Mesh& mesh, int field, const Outline& outline) {
  MeshFunction x(mesh, field, 0), y(mesh, field, 1);
  return integrate_flux(x, y, mesh, outline);
}

}  // namespace

TEST_CASE("area and centre of a face are those that its curve encloses", "[fem]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(mapped_disk(degree, {2, 0.5}, {-0.3, 1}, {1000, -7}));
  const double exact = mesh.spline(0).area({1000, -7});
  const AreaAndCentre face = measure_area(mesh, 0), all = measure_area(mesh, every_face);
  const AreaAndCentre enclosed = measure_enclosed(mesh, all_curves(mesh));
  CHECK(face.area == Approx(exact).epsilon(1e-12));
  CHECK(all.area == face.area);
  CHECK(enclosed.area == Approx(exact).epsilon(1e-12));
  CHECK(face.centre.x == Approx(1000).epsilon(1e-14));
  CHECK(face.centre.y == Approx(-7).epsilon(1e-13));
  CHECK(enclosed.centre.x == Approx(1000).epsilon(1e-14));
  CHECK(enclosed.centre.y == Approx(-7).epsilon(1e-13));
}

TEST_CASE("measures of a round spline converge to those of the circle", "[fem]") {
  const int degree = GENERATE(2, 3, 5);
  CAPTURE(degree);
  // Control points on a circle make a spline that is near to a circle through its own points.
  const Mesh mesh(samples::disk(degree, 64, {1, 2}, 1));
  const Outline outline = outline_of_face(mesh, 0);
  const double area = measure_area(mesh, 0).area, perimeter = measure_length(mesh, outline);
  const double radius = length(mesh.spline(0).evaluate(0) - Point{1, 2});
  CHECK(area == Approx(pi * radius * radius).epsilon(1e-5));
  CHECK(perimeter == Approx(2 * pi * radius).epsilon(1e-5));
  CHECK(perimeter == Approx(mesh.spline(0).arc_length()).epsilon(1e-13));
  CHECK(2 * std::sqrt(pi * area) / perimeter == Approx(1).epsilon(1e-9));
  CHECK(2 * std::sqrt(pi * area) / perimeter <= 1 + 1e-14);
  const Point centre = centre_of_line(mesh, all_curves(mesh));
  CHECK(centre.x == Approx(1).epsilon(1e-13));
  CHECK(centre.y == Approx(2).epsilon(1e-13));
}

TEST_CASE("the reach of an ellipse is that of its axes, wherever they point", "[fem]") {
  const int degree = GENERATE(2, 3, 5);
  const double angle = GENERATE(0.0, 0.4, 2.0);
  CAPTURE(degree, angle);
  // The control polygon is a regular one, mapped: the spline is symmetric about the axes, and reaches farthest on them.
  const Vector along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
  const Mesh mesh(mapped_disk(degree, 1.5 * along, 0.75 * across, {3, -1}, 16));
  const BSpline round = samples::round_spline(degree, 16, {0, 0}, 1);
  double most = 0, least = 2;  // of the round one along the axes: its extremes are at breaks and in the middle of spans
  for (int k = 0; k < 32; ++k) {
    const Point p = round.evaluate(k / 2.0);
    most = std::max(most, p.x);
    least = std::min(least, std::abs(p.x) < 1e-9 ? std::abs(p.y) : least);
  }
  const Reach reach = measure_reach(mesh, outline_of_face(mesh, 0), measure_area(mesh, 0).centre);
  CHECK(reach.greatest == Approx(1.5 * most).epsilon(1e-12));
  CHECK(reach.least == Approx(0.75 * least).epsilon(1e-12));
  const Vector arm = reach.farthest - Point{3, -1};
  CHECK(std::abs(cross(arm, along)) <= 1e-9);
}

TEST_CASE("linear fields are integrated exactly, over faces and along lines", "[fem]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(mapped_disk(degree, {2, 0.5}, {-0.3, 1}, {4, 9}));
  const AreaAndCentre face = measure_area(mesh, 0);
  const double middle = 2 * face.centre.x - 3 * face.centre.y + 1;
  MeshFunction field(mesh, 0, 0);
  MeshFunction formula(
      mesh, Coefficient([](const CoefficientPoint& at) { return 2 * at.place.x - 3 * at.place.y + 1; }, "2*x-3*y+1"));
  CHECK(integrate(field, mesh, FaceId{0}) == Approx(middle * face.area).epsilon(1e-12));
  CHECK(integrate(formula, mesh, FaceId{0}) == Approx(middle * face.area).epsilon(1e-12));
  const Outline outline = all_curves(mesh);
  const Point centre = centre_of_line(mesh, outline);
  const double along = (2 * centre.x - 3 * centre.y + 1) * measure_length(mesh, outline);
  CHECK(integrate(field, mesh, outline) == Approx(along).epsilon(1e-12));
  CHECK(integrate(formula, mesh, outline) == Approx(along).epsilon(1e-12));
}

TEST_CASE("the flux out of a face is the integral of the divergence, and what enters through its curve is its negative",
          "[fem]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(mapped_disk(degree, {2, 0.5}, {-0.3, 1}, {4, 9}));
  const double area = measure_area(mesh, 0).area;
  CHECK(std::abs(flux(mesh, 1, outline_of_face(mesh, 0))) <= 1e-12);  // divergence 0
  CHECK(flux(mesh, 2, outline_of_face(mesh, 0)) == Approx(5 * area).epsilon(1e-12));
  CHECK(flux(mesh, 2, all_curves(mesh)) == Approx(-5 * area).epsilon(1e-12));
}

TEST_CASE("a flux through a curve that runs the other way enters all the same", "[fem]") {
  MeshData data = mapped_disk(3, {1, 0}, {0, 1}, {0, 0}, 8);
  Curve& curve = data.boundary.curves[0];
  const std::vector<Point> points(curve.spline.points().begin(), curve.spline.points().end());
  std::vector<double> knots;
  for (int k = 0; k <= 8; ++k) knots.push_back(k);
  // Basis function i of degree 3 begins at knot i: turned round, the polygon begins four knots later.
  std::vector<Point> turned(8);
  for (std::size_t i = 0; i < 8; ++i) turned[i] = points[(2 * 8 - 4 - i) % 8];
  curve.spline = BSpline(3, true, knots, turned);
  std::swap(curve.left, curve.right);
  for (ConstrainedEdge& edge : data.constrained_edges) {
    std::reverse(edge.points.begin(), edge.points.end());
    edge.span = 7 - edge.span;
  }
  const Mesh mesh(std::move(data));
  for (const OutlineEdge& edge : all_curves(mesh)) {  // the mesh lies on the curve
    std::vector<Point> span(4), own(4);
    mesh.spline(0).extract(mesh.constraint_start(mesh.constraint(edge.half_edge)), span);
    mesh.gather_edge_points(edge.half_edge, own);
    CHECK(edge.is_backward);
    for (std::size_t k = 0; k < 4; ++k) CHECK(length(span[k] - own[3 - k]) <= 1e-14);
  }
  CHECK(flux(mesh, 2, all_curves(mesh)) == Approx(-5 * measure_area(mesh, 0).area).epsilon(1e-12));
  CHECK(measure_enclosed(mesh, all_curves(mesh)).area == Approx(-measure_area(mesh, 0).area).epsilon(1e-12));
  CHECK(is_closed(mesh, all_curves(mesh)));
}

TEST_CASE("the outline of several faces together is what has nothing beyond it", "[fem]") {
  const Mesh mesh(samples::three_disks(3));
  double length = 0, area = 0;
  for (FaceId f = 0; f < 3; ++f) {
    CHECK(is_closed(mesh, outline_of_face(mesh, f)));
    length += measure_length(mesh, outline_of_face(mesh, f));
    area += measure_area(mesh, f).area;
  }
  CHECK(measure_length(mesh, outline_of_face(mesh, every_face)) == Approx(length).epsilon(1e-14));
  CHECK(measure_area(mesh, every_face).area == Approx(area).epsilon(1e-14));
  Outline part = outline_of_face(mesh, 0);
  part.pop_back();
  CHECK_FALSE(is_closed(mesh, part));
}

TEST_CASE("bounds of a field hold, and are reached", "[fem]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(mapped_disk(degree, {2, 0}, {0, 1}, {0, 0}));
  MeshFunction field(mesh, 0, 0);  // 2 x - 3 y + 1: its bounds are on the boundary
  const auto face = bounds(field, mesh, FaceId{0});
  const auto line = bounds(field, mesh, outline_of_face(mesh, 0));
  REQUIRE(face);
  REQUIRE(line);
  double most = 1;
  for (int k = 0; k <= 20000; ++k) {
    const Point p = mesh.spline(0).evaluate(16.0 * k / 20000);
    most = std::max(most, 2 * p.x - 3 * p.y + 1);
  }
  CHECK(face->greatest >= most - 1e-13);
  CHECK(face->greatest == Approx(most).epsilon(2e-6));
  CHECK(line->greatest == Approx(face->greatest).epsilon(1e-8));
  CHECK(line->least == Approx(face->least).epsilon(1e-8));
  CHECK(line->least + line->greatest == Approx(2).epsilon(1e-8));  // the disk is symmetric about its centre
}

TEST_CASE("bounds along a curve end where a field is constant but for its last digits", "[fem]") {
  MeshData data = samples::disk(5, 16);
  samples::add_field(data, "c", 1, [](const Point& p) { return std::vector{1e9 + 1e-7 * std::sin(1e6 * p.x)}; });
  const Mesh mesh(std::move(data));
  MeshFunction field(mesh, 0, 0);
  const auto range = bounds(field, mesh, outline_of_face(mesh, 0));
  REQUIRE(range);
  CHECK(range->least == Approx(1e9).epsilon(1e-14));
  CHECK(range->greatest == Approx(1e9).epsilon(1e-14));
  CHECK(bounds(field, mesh, FaceId{0})->greatest == Approx(1e9).epsilon(1e-14));
}

TEST_CASE("measures are in the units of a document of extreme size", "[fem]") {
  const double factor = GENERATE(0x1p100, 0x1p-100);
  MeshData data = mapped_disk(2, {1, 0}, {0, 1}, {3, 0});
  const Mesh own(data);
  for (Point& p : data.points) p *= factor;
  BSpline& spline = data.boundary.curves[0].spline;
  for (int i = 0; i < static_cast<int>(spline.points().size()); ++i)
    spline.set_point(i, factor * spline.points()[static_cast<std::size_t>(i)]);
  normalize_unit(data);
  const Mesh mesh(std::move(data));
  REQUIRE(mesh.boundary().unit != 1);
  const Outline outline = outline_of_face(mesh, 0), as_own = outline_of_face(own, 0);
  CHECK(measure_area(mesh, 0).area == factor * factor * measure_area(own, 0).area);
  CHECK(measure_area(mesh, 0).centre.x == factor * measure_area(own, 0).centre.x);
  CHECK(measure_length(mesh, outline) == factor * measure_length(own, as_own));
  CHECK(flux(mesh, 2, outline) == factor * flux(own, 2, as_own));
  const Reach reach = measure_reach(mesh, outline, {3 * factor, 0});
  CHECK(reach.greatest == Approx(factor * measure_reach(own, as_own, {3, 0}).greatest).epsilon(1e-14));
  const std::vector<Point> places{{3 * factor, factor / 4}};
  CHECK(locate_places(mesh, places, OutsidePlaces::empty)[0].has_value());
}

TEST_CASE("places just outside the boundary count as on it, others only if asked", "[fem]") {
  const Mesh mesh(mapped_disk(3, {1, 0}, {0, 1}, {0, 0}));
  const Point on = mesh.spline(0).evaluate(0.3);
  const double edge = length(mesh.spline(0).evaluate(1) - mesh.spline(0).evaluate(0));
  const Vector out = on / length(on);
  const std::vector<Point> places{0.5 * on, on + 0.009 * edge * out, on + 0.02 * edge * out, {50, 50}};
  const auto found = locate_places(mesh, places, OutsidePlaces::empty);
  CHECK(found[0].has_value());
  CHECK(found[1].has_value());
  CHECK_FALSE(found[2].has_value());
  CHECK_FALSE(found[3].has_value());
  MeshFunction field(mesh, 0, 0);
  const auto value = [&](const Location& at) {
    field.set(at.triangle);
    return field.at(at.xi);
  };
  CHECK(value(*found[0]) == Approx(2 * places[0].x - 3 * places[0].y + 1).epsilon(1e-12));
  CHECK(value(*found[1]) == Approx(2 * on.x - 3 * on.y + 1).epsilon(1e-4));
  for (const auto& each : locate_places(mesh, places, OutsidePlaces::nearest)) CHECK(each.has_value());
}

TEST_CASE("the greatest value of polynomials is found between their ends", "[fem]") {
  SegmentMaximum greatest(1e-15);
  const std::vector<double> parabola{0, 1, 0.5}, line{0.2, 0.1};  // 2 s (1 - s) + s^2 / 2: 2/3 at 2/3
  greatest.take_in(line, 0);
  greatest.take_in(parabola, 1);
  CHECK(greatest.value() == Approx(2.0 / 3).epsilon(1e-14));
  CHECK(greatest.segment() == 1);
  greatest.polish(parabola);
  CHECK(greatest.s() == Approx(2.0 / 3).epsilon(1e-14));
}
