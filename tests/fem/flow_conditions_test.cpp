// tests/fem/flow_conditions_test.cpp: flows where conditions meet: at corners, across walls inside, at contact lines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "flows.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

using FlowKind = FlowCondition::Kind;

FlowCondition condition(FlowKind kind, double x = 0, double y = 0) {
  return {kind, Coefficient(x), Coefficient(y), ""};
}

/// Turns a curve round; its knots are whole numbers from 0.
void reverse_curve(MeshData& data, std::size_t c) {
  Curve& curve = data.boundary.curves[c];
  std::vector<Point> points(curve.spline.points().begin(), curve.spline.points().end());
  std::ranges::reverse(points);
  std::vector<double> knots(curve.spline.knots().begin(), curve.spline.knots().end());
  std::ranges::reverse(knots);
  const double last = knots.front();
  for (double& knot : knots) knot = last - knot;
  curve.spline = BSpline(curve.spline.degree(), false, knots, points);
  std::swap(curve.start, curve.end);
  std::swap(curve.left, curve.right);
  for (ConstrainedEdge& edge : data.constrained_edges)
    if (edge.curve == static_cast<CurveId>(c)) {
      edge.span = static_cast<int>(last) - 1 - edge.span;
      std::ranges::reverse(edge.points);
    }
}

/// A straight curve of simple knots, which runs through it with constant speed.
BSpline straight_spline(int degree, int spans, const Point& from, const Point& to) {
  std::vector<double> knots(index(degree), 0.0);
  for (int k = 0; k <= spans; ++k) knots.push_back(k);
  knots.insert(knots.end(), index(degree), spans);
  std::vector<Point> points;
  for (int i = 0; i < spans + degree; ++i) {
    double sum = 0;  // of knots: their mean is where the control point belongs
    for (int k = 1; k <= degree; ++k) sum += knots[index(i + k)];
    points.push_back(from + sum / (degree * spans) * (to - from));
  }
  points.front() = from;
  points.back() = to;
  return BSpline(degree, false, knots, points);
}

CurveId curve_named(const Mesh& mesh, const std::string& name) {
  const auto& curves = mesh.boundary().curves;
  return static_cast<CurveId>(std::ranges::find(curves, name, &Curve::name) - curves.begin());
}

}  // namespace

TEST_CASE("fluid glides along a wall of two curves, whichever way they run", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 5);
  const bool reversed = GENERATE(false, true);
  MeshData data = mapped_square(degree, 4, as_it_is, true);
  if (reversed) reverse_curve(data, 1);
  Mesh mesh(data);
  FlowProblem problem = flow_problem(mesh, 1, 0.1);
  const auto profile = [](const Point& x, double) { return 1 - x.y * x.y; };
  set_velocity(problem, mesh, {"west"}, profile, zero);
  set_velocity(problem, mesh, {"north"}, zero, zero);
  set_condition(problem, mesh, "south", condition(FlowKind::slip));
  set_condition(problem, mesh, "east", condition(FlowKind::outflow));
  NavierStokes flow(problem, mesh, {.by_splines = false});
  flow.solve_steady();
  CHECK(error_of(mesh, "velocity", 0, profile) < 1e-11);
  CHECK(error_of(mesh, "velocity", 1, zero) < 1e-11);
  CHECK(error_of(mesh, "pressure", 0, [](const Point& x, double) { return 0.2 * (1 - x.x); }) < 1e-10);
}

TEST_CASE("a wall between two fluids leaves each its own pressure", "[navier_stokes]") {
  const int degree = GENERATE(2, 3);
  const bool slip = GENERATE(false, true);
  Mesh mesh(mapped_square(degree, 4, as_it_is, true));
  FlowProblem problem = flow_problem(mesh, 1, 1);
  problem.materials[1].viscosity = Coefficient(3);
  set_velocity(problem, mesh, {"south", "north", "east", "west"}, zero, zero);
  set_condition(problem, mesh, "middle", condition(slip ? FlowKind::slip : FlowKind::velocity));
  problem.motion_of_curve.assign(problem.motion_of_curve.size(), CurveMotion::stays);
  // A pull towards the wall from both sides, which pressures alone hold.
  problem.force[0] = coefficient([](const Point& x, double) { return x.x < 0.5 ? 1.0 : -2.0; });
  const auto exact = [](const Point& x, double) { return x.x < 0.5 ? x.x - 0.25 : 2 * (0.75 - x.x); };
  NavierStokes flow(problem, mesh, {.by_splines = false});
  flow.solve_steady();
  CHECK(error_of(mesh, "velocity", 0, zero) < 1e-11);
  CHECK(error_of(mesh, "velocity", 1, zero) < 1e-11);
  CHECK(error_of(mesh, "pressure", 0, exact) < 1e-10);
  if (!slip) CHECK(flow.forces().at("middle").x == Approx(0.25 - 0.5).epsilon(1e-9));
}

TEST_CASE("forces on walls are those of the fluid on them alone, also beside walls with slip", "[navier_stokes]") {
  const int degree = GENERATE(2, 3);
  Mesh mesh(mapped_square(degree, 3, as_it_is));
  FlowProblem problem = flow_problem(mesh, 2, 1);
  problem.gravity[1] = Coefficient(-10);
  set_velocity(problem, mesh, {"east", "west"}, zero, zero);
  set_condition(problem, mesh, "south", condition(FlowKind::slip));
  set_condition(problem, mesh, "north", condition(FlowKind::traction));
  NavierStokes flow(problem, mesh, {.by_splines = false});
  flow.solve_steady();
  CHECK(error_of(mesh, "pressure", 0, [](const Point& x, double) { return 20 * (1 - x.y); }) < 1e-9);
  CHECK(flow.forces().at("east").x == Approx(10).epsilon(1e-9));
  CHECK(flow.forces().at("west").x == Approx(-10).epsilon(1e-9));
  CHECK(std::abs(flow.forces().at("east").y) < 1e-9);
  CHECK(flow.forces().size() == 2);
}

TEST_CASE("walls hold what interfaces that end on them pull", "[navier_stokes]") {
  // All that acts on the fluid from outside comes from the walls, and the force: without inertia they are equal, also
  // where an interface that is pulled ends.
  const int degree = GENERATE(2, 3, 4);
  MeshData data = mapped_square(degree, 4, as_it_is, true);
  Curve& middle = *std::ranges::find(data.boundary.curves, "middle", &Curve::name);
  middle.spline = straight_spline(degree, 4, data.boundary.vertices[index(middle.start)],
                                  data.boundary.vertices[index(middle.end)]);
  Mesh mesh(data);
  FlowProblem problem = flow_problem(mesh, 0, 1);
  problem.materials[1].viscosity = Coefficient(5);
  problem.force = {coefficient([](const Point& x, double) { return 2 * x.x; }), Coefficient(-3)};
  problem.tensions[index(curve_named(mesh, "middle"))] = Coefficient(7);
  set_velocity(problem, mesh, square_sides, zero, zero);
  NavierStokes flow(problem, mesh, {});
  flow.initialise();
  mesh.time = 0.1;
  flow.step({}, 0, {});
  Vector sum;
  for (const auto& [name, force] : flow.forces()) sum += force;
  CHECK(sum.x == Approx(1).epsilon(1e-9));
  CHECK(sum.y == Approx(-3).epsilon(1e-9));
}

TEST_CASE("a flow is the same in any unit", "[navier_stokes]") {
  const double unit = GENERATE(0x1p40, 0x1p-40, 0x1p200, 0x1p-200);
  const auto solve = [](double u) {
    MeshData data = mapped_square(2, 4, bend, true);
    data.boundary.unit = u;
    Mesh mesh(data);
    FlowProblem problem = flow_problem(mesh, 1, 0.1 * u * u);
    problem.materials[1] = {Coefficient(2), Coefficient(0.5 * u * u)};
    problem.gravity = {Coefficient(0), Coefficient(-u)};
    problem.tensions[index(curve_named(mesh, "middle"))] = Coefficient(0.3 * u * u * u);
    set_velocity(
        problem, mesh, {"west"}, [u](const Point& x, double) { return x.y * (u - x.y) / u; }, zero);
    set_condition(problem, mesh, "south", condition(FlowKind::slip));
    set_condition(problem, mesh, "north", condition(FlowKind::traction, 0.1 * u * u, -0.2 * u * u));
    set_condition(problem, mesh, "east", condition(FlowKind::outflow));
    NavierStokes flow(problem, mesh, {});
    flow.initialise();
    std::optional<double> last;
    for (int k = 0; k < 3; ++k) {
      mesh.time += 0.1;
      flow.step({}, mesh.time - 0.1, last);
      last = 0.1;
    }
    std::vector<double> all;
    for (const double value : mesh.fields()[index(find_field(mesh, "velocity"))].values) all.push_back(value / u);
    for (const double value : mesh.fields()[index(find_field(mesh, "pressure"))].values) all.push_back(value / u / u);
    for (const auto& [name, force] : flow.forces()) {
      all.push_back(force.x / u / u / u);
      all.push_back(force.y / u / u / u);
    }
    return all;
  };
  const std::vector<double> one = solve(1), scaled = solve(unit);
  REQUIRE(one.size() == scaled.size());
  double worst = 0, greatest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    worst = std::max(worst, std::abs(one[i] - scaled[i]));
    greatest = std::max(greatest, std::abs(one[i]));
  }
  CHECK(worst < 1e-9 * greatest);
}

TEST_CASE("flows that nothing holds are refused with a word", "[navier_stokes]") {
  Mesh mesh(mapped_square(2, 3, as_it_is));
  FlowProblem problem = flow_problem(mesh, 0, 1);
  for (const std::string side : {"south", "east", "north", "west"})
    set_condition(problem, mesh, side, condition(FlowKind::traction));
  problem.force = {Coefficient(1), Coefficient(0)};
  NavierStokes flow(problem, mesh, {.by_splines = false});
  CHECK_THROWS_AS(flow.solve_steady(), NoSolution);
}

TEST_CASE("two triangles between walls are refused with a word", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 4);
  const double density = GENERATE(0.0, 1.0);
  Mesh mesh(mapped_square(degree, 1, as_it_is));
  FlowProblem problem = flow_problem(mesh, density, 1);
  problem.force = {coefficient([](const Point& x, double) { return x.y; }), Coefficient(-3)};
  set_velocity(problem, mesh, square_sides, zero, zero);
  NavierStokes flow(problem, mesh, {.by_splines = false});
  CHECK_THROWS_WITH(flow.solve_steady(), Catch::Contains("face \"domain\" has 2 triangles between walls"));
  CHECK_THROWS_WITH(flow.initialise(), Catch::Contains("3 or more"));
}

TEST_CASE("a flow begins in fluids with and without inertia", "[navier_stokes]") {
  const int degree = GENERATE(2, 3);
  Mesh mesh(mapped_square(degree, 4, bend, true));
  FlowProblem problem = flow_problem(mesh, 1, 1);
  problem.materials[1].density = Coefficient(0);
  const auto along = [](const Point& x, double) { return x.y; };
  const auto across = [](const Point& x, double) { return x.x; };
  set_velocity(problem, mesh, {"south", "east", "north", "west"}, along, across);
  problem.initial = {coefficient(along), coefficient(across)};
  NavierStokes flow(problem, mesh, {.by_splines = false});
  flow.initialise();
  CHECK(error_of(mesh, "velocity", 0, along) < 1e-9);
  CHECK(error_of(mesh, "velocity", 1, across) < 1e-9);
  // A gradient: where there is inertia, a pressure holds u . grad u = (x, y).
  mesh.time = 1e-3;
  flow.step({}, 0, {});
  CHECK(error_of(mesh, "velocity", 0, along) < 2e-3);
}
