// tests/fem/unsteady_diffusion_test.cpp: orders in time, totals, constants, and heat in a rotating disc.
#include <catch2/catch.hpp>
#include <numbers>

#include "fem/diffusion_problems.h"
#include "pliant/flow/advect.h"
#include "support/mapped_meshes.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;
using Kind = DiffusionCondition::Kind;

namespace {

/// Moves the mesh, if there is a velocity, and takes the field along.
void step(Diffusion& diffusion, Mesh& mesh, const VelocityField& velocity, double dt) {
  const double before = mesh.time;
  if (!velocity) {
    mesh.time += dt;
    diffusion.step({}, before);
    return;
  }
  const std::vector<Point> from(mesh.points().begin(), mesh.points().end());
  AdvectOptions options;
  options.dt = dt;
  REQUIRE(advect(mesh, velocity, options).status == AdvectOutcome::Status::done);
  diffusion.step(from, before);
}

double total_of(const Diffusion& diffusion) {
  PassReport report;
  diffusion.report(report);
  for (const auto& [name, value] : report.values)
    if (name == "total") return value;
  return NAN;
}

/// c = exp(-t) sin(x + 2y - 4t) in the frame of a mesh that moves with `velocity`: the source of the moving equation.
const Exact wave{[](double x, double y, double t) { return std::exp(-t) * std::sin(x + 2 * y - 4 * t); }, {}, {}};
double wave_source(double x, double y, double t, const Vector& v) {
  const double s = std::exp(-t) * std::sin(x + 2 * y - 4 * t), c = std::exp(-t) * std::cos(x + 2 * y - 4 * t);
  return -s - 4 * c + v.x * c + v.y * 2 * c + 5 * s;  // c_t + v . grad c - laplacian, diffusivity 1
}

}  // namespace

TEST_CASE("steps have their order in time, at rest and on a mesh that moves", "[fem][order]") {
  const auto [scheme, wanted] = GENERATE(
      table<TimeScheme, int>({{TimeScheme::sdirk2, 2}, {TimeScheme::crank_nicolson, 2}, {TimeScheme::euler, 1}}));
  const bool moves = GENERATE(false, true);
  const bool conservative = GENERATE(true, false);
  if (!conservative && scheme == TimeScheme::crank_nicolson) return;
  CAPTURE(wanted, moves, conservative);
  // Divergence-free, so that both forms are the same equation.
  const VelocityField turn = [](const Point& p, double t) {
    return Vector{-0.8 * (p.y - 0.4) * (1 + t), 0.8 * (p.x - 0.5) * (1 + t)};
  };
  double coarse = 0;
  for (const int steps : {10, 20}) {
    Mesh mesh(mapped_square(4, 5, bend));
    DiffusionProblem problem = plain_problem(mesh.boundary());
    problem.depends_on_time = true;
    problem.materials[0].source = coefficient([&](double x, double y, double t) {
      return wave_source(x, y, t, moves ? turn({x, y}, t) : Vector{});
    });
    problem.initial[0] = coefficient(wave.value);
    for (const std::string& side : square_sides)
      add_condition(problem, mesh.boundary(), side, Kind::value, coefficient(wave.value));
    DiffusionOptions options;
    options.scheme = scheme;
    options.conservative = conservative;
    Diffusion diffusion(problem, mesh, options);
    for (int k = 0; k < steps; ++k) step(diffusion, mesh, moves ? turn : VelocityField(), 0.6 / steps);
    const double error = errors_of(mesh, wave).l2;
    if (steps == 20) {
      CAPTURE(coarse, error);
      CHECK(order(coarse, error) > wanted - 0.25);
      CHECK(error < (wanted == 2 ? 2e-3 : 2e-2));
    }
    coarse = error;
  }
}

TEST_CASE("without fluxes the total stays to rounding, on a mesh that moves, too", "[fem][property]") {
  const int p = GENERATE(1, 2, 3);
  const TimeScheme scheme = GENERATE(TimeScheme::sdirk2, TimeScheme::crank_nicolson, TimeScheme::euler);
  CAPTURE(p);
  Mesh mesh(mapped_square(p, 4, bend, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[1].diffusivity = {Coefficient(10)};
  problem.materials[1].capacity = Coefficient(3);
  problem.initial[0] = Coefficient(1);
  problem.initial[1] = coefficient([](double x, double y, double) { return 2 + x * y; });
  if (GENERATE(false, true)) add_condition(problem, mesh.boundary(), "middle", Kind::jump, Coefficient(0.5));
  DiffusionOptions options;
  options.scheme = scheme;
  Diffusion diffusion(problem, mesh, options);
  const double total = total_of(diffusion);
  const VelocityField squeeze = [](const Point& at, double) {
    return Vector{0.5 * std::sin(at.x + at.y), -0.4 * at.y};
  };
  for (int k = 0; k < 20; ++k) step(diffusion, mesh, squeeze, 0.02);
  CHECK(total_of(diffusion) == Approx(total).epsilon(1e-14));
}

TEST_CASE("without fluxes the total stays to rounding in long steps", "[fem][property]") {
  const double dt = GENERATE(1e2, 1e4, 1e7, 1e10);
  CAPTURE(dt);
  Mesh mesh(mapped_square(2, 4, bend, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[1].diffusivity = {Coefficient(10)};
  problem.initial[0] = coefficient([](double x, double y, double) { return 2 + x * y; });
  DiffusionOptions options;
  options.scheme = GENERATE(TimeScheme::sdirk2, TimeScheme::euler);
  Diffusion diffusion(problem, mesh, options);
  const double total = total_of(diffusion);
  step(diffusion, mesh, {}, dt);
  CHECK(total_of(diffusion) == Approx(total).epsilon(1e-14));
  step(diffusion, mesh, {}, dt);  // from what is constant but for rounding
  CHECK(total_of(diffusion) == Approx(total).epsilon(1e-14));
  PassReport report;
  diffusion.report(report);
  double least = NAN, greatest = NAN;
  for (const auto& [name, value] : report.values) {
    if (name == "min") least = value;
    if (name == "max") greatest = value;
  }
  CHECK(greatest - least <= 20 / dt);
}

TEST_CASE("what enters through a curve is what the total grows by", "[fem][property]") {
  Mesh mesh(mapped_square(2, 4, bend, true));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(1));
  add_condition(problem, mesh.boundary(), "east", Kind::robin, Coefficient(2), Coefficient(0.5));
  DiffusionOptions options;
  options.scheme = GENERATE(TimeScheme::sdirk2, TimeScheme::crank_nicolson, TimeScheme::euler);
  options.wants_fluxes = true;
  Diffusion diffusion(problem, mesh, options);
  const VelocityField squeeze = [](const Point& at, double) {
    return Vector{0.3 * std::sin(at.x + at.y), -0.2 * at.y};
  };
  PassReport before;
  diffusion.report(before);
  step(diffusion, mesh, squeeze, 0.1);
  PassReport after;
  diffusion.report(after);
  const auto find = [](const PassReport& report, const std::string& name) {
    for (const auto& [key, value] : report.values)
      if (key == name) return value;
    return double(NAN);
  };
  double entered = 0, into_right = 0;
  for (const char* curve : {"south", "east", "north", "west"}) entered += find(after, "flux:" + std::string(curve));
  CHECK(find(after, "total") - find(before, "total") == Approx(0.1 * entered).epsilon(1e-12));
  into_right = find(after, "flux:east") + find(after, "flux:middle");
  CHECK(find(after, "total:right") - find(before, "total:right") == Approx(0.1 * into_right).epsilon(1e-11));
}

TEST_CASE("constants stay to rounding in the nonconservative form", "[fem][property]") {
  const int p = GENERATE(1, 2, 3, 4);
  CAPTURE(p);
  Mesh mesh(mapped_square(p, 4, bend));
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.initial[0] = Coefficient(7);
  DiffusionOptions options;
  options.conservative = false;
  Diffusion diffusion(problem, mesh, options);
  const VelocityField turn = [](const Point& at, double) { return Vector{std::sin(3 * at.y), std::cos(2 * at.x)}; };
  for (int k = 0; k < 10; ++k) step(diffusion, mesh, turn, 0.02);
  CHECK(errors_of(mesh, {[](double, double, double) { return 7.0; }, {}, {}}).l2 < 1e-12);
}

TEST_CASE("steps at rest take the same bits one by one as many on one factor", "[fem]") {
  const auto run = [](bool anew) {
    Mesh mesh(mapped_square(3, 4, bend));
    DiffusionProblem problem = plain_problem(mesh.boundary());
    problem.initial[0] = coefficient([](double x, double y, double) { return std::cos(9 * x * y); });
    add_condition(problem, mesh.boundary(), "south", Kind::robin, Coefficient(2), Coefficient(1));
    auto diffusion = std::make_unique<Diffusion>(problem, mesh, DiffusionOptions{});
    for (int k = 0; k < 5; ++k) {
      step(*diffusion, mesh, {}, 0.01);
      if (anew) diffusion = std::make_unique<Diffusion>(problem, mesh, DiffusionOptions{});
    }
    return mesh.fields()[0].values;
  };
  CHECK(run(true) == run(false));
}
