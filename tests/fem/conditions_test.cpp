// tests/fem/conditions_test.cpp: given values, fluxes, Robin conditions and jumps against exact solutions; fluxes told.
#include <catch2/catch.hpp>
#include <numbers>

#include "fem/diffusion_problems.h"
#include "pliant/boundary/fault.h"
#include "support/mapped_meshes.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;
using Kind = DiffusionCondition::Kind;

namespace {

/// Straight sides; inside, elements bend.
Point bend_inside(double x, double y) {
  const double hump = x * (1 - x) * std::sin(std::numbers::pi * y);
  return {x + 0.05 * std::sin(2 * std::numbers::pi * x) * std::sin(std::numbers::pi * y), y + 0.2 * hump};
}
/// The same, but the line x = 1/2 stays straight.
Point bend_halves(double x, double y) { return {x, y + 0.1 * x * (1 - x) * std::sin(std::numbers::pi * y)}; }

double value_of(const PassReport& report, const std::string& name) {
  for (const auto& [key, value] : report.values)
    if (key == name) return value;
  FAIL("there is no value " << name);
  return 0;
}

}  // namespace

TEST_CASE("a flux enters, and leaves where the value is given", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4);
  CAPTURE(p);
  Mesh mesh(mapped_square(p, 3, bend_inside));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].diffusivity = {Coefficient(4)};
  add_condition(problem, mesh.boundary(), "west", Kind::flux, Coefficient(3));
  add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(1));
  const PassReport report = solve_steady(problem, mesh);
  CHECK(errors_of(mesh, {[](double x, double, double) { return 1 + 0.75 * (1 - x); }, {}, {}}).l2 < 1e-13);
  CHECK(value_of(report, "flux:west") == Approx(3).epsilon(1e-12));
  CHECK(value_of(report, "flux:east") == Approx(-3).epsilon(1e-12));
  CHECK(std::abs(value_of(report, "flux:south")) < 1e-12);
  CHECK(value_of(report, "energy") == Approx(0.5 * 4 * 0.75 * 0.75).epsilon(1e-12));
  CHECK(value_of(report, "total") == Approx(1.375).epsilon(1e-12));
  CHECK(value_of(report, "max") == Approx(1.75).epsilon(1e-6));
}

TEST_CASE("the energy of small differences is not lost in a large mean", "[fem][oracle]") {
  Mesh mesh(mapped_square(3, 8, bend_inside));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(300));
  add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(300 + 1e-7));
  CHECK(value_of(solve_steady(problem, mesh), "energy") == Approx(0.5e-14).epsilon(1e-4));
}

TEST_CASE("a Robin condition on one side, a given value on the other", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4);
  CAPTURE(p);
  // k c' = -h (c - a) at x = 1, c(0) = 2: c = 2 + s x with k s = -h (2 + s - a).
  const double k = 0.5, h = 3, a = -1, s = -h * (2 - a) / (k + h);
  Mesh mesh(mapped_square(p, 3, bend_inside));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].diffusivity = {Coefficient(k)};
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(2));
  add_condition(problem, mesh.boundary(), "east", Kind::robin, Coefficient(h), Coefficient(a));
  const PassReport report = solve_steady(problem, mesh);
  CHECK(errors_of(mesh, {[&](double x, double, double) { return 2 + s * x; }, {}, {}}).l2 < 1e-13);
  CHECK(value_of(report, "flux:east") == Approx(k * s).epsilon(1e-12));
  CHECK(value_of(report, "flux:west") == Approx(-k * s).epsilon(1e-12));
}

TEST_CASE("the unknown jumps by the flux over the transfer", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4);
  const double h = GENERATE(0.2, 5.0, 1e4);
  CAPTURE(p, h);
  Mesh mesh(mapped_square(p, 4, bend_halves, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  const double k = 10;
  problem.materials[1].diffusivity = {Coefficient(k)};
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(0));
  add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(1));
  add_condition(problem, mesh.boundary(), "middle", Kind::jump, Coefficient(h));
  const PassReport report = solve_steady(problem, mesh);
  const double flux = 1 / (0.5 + 1 / h + 0.5 / k);
  CHECK(errors_of(mesh, {[&](double x, double, double) { return flux * x; }, {}, {}}, 0).l2 < 1e-12);
  CHECK(errors_of(mesh, {[&](double x, double, double) { return 1 - flux / k * (1 - x); }, {}, {}}, 1).l2 < 1e-12);
  CHECK(value_of(report, "flux:middle") ==
        Approx(-flux).epsilon(1e-10));  // from left to right, and it runs to the left
  CHECK(value_of(report, "flux:east") == Approx(flux).epsilon(1e-10));
  CHECK(value_of(report, "flux:west") == Approx(-flux).epsilon(1e-10));
}

TEST_CASE("fluxes through curves balance the source in each face", "[fem][oracle]") {
  const int p = GENERATE(2, 3);
  CAPTURE(p);
  Mesh mesh(mapped_square(p, 4, bend, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].source = Coefficient(2);
  problem.materials[1].source = coefficient([](double x, double y, double) { return -x * y; });
  problem.materials[1].diffusivity = {Coefficient(7)};
  add_condition(problem, mesh.boundary(), "west", Kind::value, coefficient([](double, double y, double) { return y; }));
  add_condition(problem, mesh.boundary(), "east", Kind::robin, Coefficient(2), Coefficient(1));
  add_condition(problem, mesh.boundary(), "north", Kind::flux, coefficient([](double x, double, double) { return x; }));
  const PassReport report = solve_steady(problem, mesh);
  // By the same rule, what the sources set free.
  double freed[2] = {0, 0};
  const Exact sources[2] = {{[](double, double, double) { return 2.0; }, {}, {}},
                            {[](double x, double y, double) { return -x * y; }, {}, {}}};
  ElementMap map(p);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    map.set(mesh, mesh.points(), t, Integrand::varying);
    const auto face = index(mesh.face(t));
    for (int q = 0; q < map.points(); ++q)
      freed[face] += map.measure(q) * sources[face].value(map.place(q).x, map.place(q).y, 0);
  }
  double outside_flux = 0;
  for (const char* curve : {"south", "east", "north", "west"})
    outside_flux += value_of(report, "flux:" + std::string(curve));
  CHECK(outside_flux + freed[0] + freed[1] == Approx(0).margin(1e-12));
}

TEST_CASE("what a condition sets free between two faces is told, and balances both of them", "[fem][oracle]") {
  const Kind kind = GENERATE(Kind::value, Kind::flux, Kind::robin);
  const int p = GENERATE(1, 3);
  CAPTURE(p, static_cast<int>(kind));
  Mesh mesh(mapped_square(p, 4, bend_halves, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[1].diffusivity = {Coefficient(3)};
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(0));
  add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(0));
  add_condition(problem, mesh.boundary(), "middle", kind, Coefficient(2), Coefficient(5));
  const PassReport report = solve_steady(problem, mesh);
  // On the middle, 1/2 away from both ends, c is such that 2 c goes to the left and 6 c to the right.
  const double middle = kind == Kind::value ? 2 : kind == Kind::flux ? 2.0 / 8 : 2 * 5 / (8.0 + 2);
  CHECK(value_of(report, "flux:west") == Approx(-2 * middle).epsilon(1e-10));
  CHECK(value_of(report, "flux:east") == Approx(-6 * middle).epsilon(1e-10));
  CHECK(value_of(report, "freed:middle") == Approx(8 * middle).epsilon(1e-10));
}

TEST_CASE("conditions that leave a constant free are refused with the curves that want one", "[fem]") {
  Mesh mesh(mapped_square(2, 4, bend, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  add_condition(problem, mesh.boundary(), "west", Kind::flux, Coefficient(1));
  Diffusion diffusion(problem, mesh, {});
  CHECK_THROWS_AS(diffusion.solve_steady(), InputError);
  CHECK_THROWS_WITH(diffusion.solve_steady(), Catch::Contains("\"value\" or \"robin\"") && Catch::Contains("\"west\""));
  add_condition(problem, mesh.boundary(), "east", Kind::robin, Coefficient(1));
  CHECK_NOTHROW(Diffusion(problem, mesh, {}).solve_steady());
  // Where nothing is transferred nothing is held, nor are faces connected.
  problem.conditions.back().first = Coefficient(0);
  CHECK_THROWS_AS(Diffusion(problem, mesh, {}).solve_steady(), InputError);
  problem.conditions.back().first = Coefficient(1);
  add_condition(problem, mesh.boundary(), "middle", Kind::jump, Coefficient(0));
  CHECK_THROWS_WITH(Diffusion(problem, mesh, {}).solve_steady(), Catch::Contains("\"left\""));
  problem.conditions.back().first = Coefficient(1);
  CHECK_NOTHROW(Diffusion(problem, mesh, {}).solve_steady());
}

TEST_CASE("a coefficient that is not finite or out of range is refused with its place and time", "[fem]") {
  Mesh mesh(mapped_square(2, 4, bend));
  mesh.time = 2.5;
  const auto refusal = [&mesh](const auto& change) -> std::string {
    DiffusionProblem problem = plain_problem(mesh.boundary());
    add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(1));
    change(problem);
    try {
      Diffusion(problem, mesh, {}).solve_steady();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK(refusal([](DiffusionProblem&) {}).empty());
  const auto hole = [](double x, double, double) { return x < 0.5 ? 1.0 : std::copysign(NAN, -1.0); };
  CHECK_THAT(refusal([&](auto& p) { p.materials[0].source = coefficient(hole, "the source"); }),
             Contains("the source is nan at") && Contains("time 2.5") && Contains("finite"));
  const auto sink = [](double x, double, double) { return x - 0.5; };
  CHECK_THAT(refusal([&](auto& p) { p.materials[0].diffusivity = {coefficient(sink, "k")}; }), Contains("positive"));
  CHECK_THAT(refusal([&](auto& p) { p.materials[0].capacity = coefficient(sink, "rho"); }), Contains("positive"));
  CHECK_THAT(refusal([&](auto& p) {
               p.materials[0].diffusivity = {
                   Coefficient(1), coefficient([](double, double, double) { return 2.0; }, "xy"), Coefficient(1)};
             }),
             Contains("positive definite"));
  CHECK_THAT(refusal([&](auto& p) {
               add_condition(p, mesh.boundary(), "east", Kind::robin, coefficient(sink, "h"), Coefficient(0));
               p.conditions.back().first = coefficient([](double, double y, double) { return y - 0.5; }, "h");
             }),
             Contains("at least 0"));
  CHECK_THAT(
      refusal([&](auto& p) { p.conditions[0].first = coefficient([](double, double, double) { return HUGE_VAL; }); }),
      Contains("inf"));
}
