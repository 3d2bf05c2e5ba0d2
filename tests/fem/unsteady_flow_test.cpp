// tests/fem/unsteady_flow_test.cpp: orders in time, at rest and in motion; drops.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "flows.h"
#include "pliant/fem/navier_stokes/mesh_velocity.h"
#include "pliant/flow/advect.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;
using std::numbers::pi;

namespace {

/// Vortices of Taylor and Green, whose convection is a gradient, with an amplitude that a force makes oscillate.
constexpr double viscosity = 0.05, frequency = 20, amplitude = 0.5;
double strength(double t) { return amplitude * std::cos(frequency * t); }
double pull(double t) {
  return -amplitude * frequency * std::sin(frequency * t) + 2 * pi * pi * viscosity * strength(t);
}
double shape_x(const Point& x) { return -std::cos(pi * x.x) * std::sin(pi * x.y); }
double shape_y(const Point& x) { return std::sin(pi * x.x) * std::cos(pi * x.y); }
double vortex_x(const Point& x, double t) { return strength(t) * shape_x(x); }
double vortex_y(const Point& x, double t) { return strength(t) * shape_y(x); }

/// Takes a step in which the mesh moves as `motion` says.
void take_step(const FlowProblem& problem, Mesh& mesh, const FlowOptions& options, MeshMotion motion, double dt,
               std::optional<double> last_dt) {
  const std::vector<Point> from(mesh.points().begin(), mesh.points().end());
  const double before = mesh.time;
  if (motion == MeshMotion::fixed) {
    mesh.time += dt;
  } else {
    const MeshVelocity extension(mesh, problem.motion_of_curve, motion);
    const auto field = [&](const char* name) -> std::vector<double> {
      const int k = find_field(mesh, name);
      return k == none ? std::vector<double>() : extension.extend(mesh.fields()[index(k)].values);
    };
    AdvectOptions by;
    by.dt = dt;
    REQUIRE(advect_by_values(mesh, field("velocity"), field("acceleration"), by).status == AdvectOutcome::Status::done);
  }
  NavierStokes(problem, mesh, options)
      .step(motion == MeshMotion::fixed ? std::span<const Point>() : std::span<const Point>(from), before, last_dt);
}

FlowProblem vortex_problem(const Mesh& mesh) {
  FlowProblem problem = flow_problem(mesh, 1, viscosity);
  set_velocity(problem, mesh, square_sides, vortex_x, vortex_y);
  problem.initial = {coefficient(vortex_x), coefficient(vortex_y)};
  problem.force = {coefficient([](const Point& x, double t) { return pull(t) * shape_x(x); }),
                   coefficient([](const Point& x, double t) { return pull(t) * shape_y(x); })};
  return problem;
}

}  // namespace

TEST_CASE("steps of uneven lengths have order 2, on meshes at rest and in motion", "[navier_stokes]") {
  const MeshMotion motion =
      GENERATE(MeshMotion::fixed, MeshMotion::harmonic, MeshMotion::blend, MeshMotion::lagrangian);
  std::vector<double> errors;
  for (const int steps : {10, 20}) {
    Mesh mesh(mapped_square(
        3, 8,
        [](double x, double y) {
          return Point{x, y};
        },
        true));
    const FlowProblem problem = vortex_problem(mesh);
    const FlowOptions options{.by_splines = motion != MeshMotion::fixed};
    NavierStokes(problem, mesh, options).initialise();
    std::optional<double> last;
    for (int k = 0; k < steps; ++k) {
      const double dt = 0.2 / steps * (k % 2 == 0 ? 0.8 : 1.2);
      take_step(problem, mesh, options, motion, dt, last);
      last = dt;
    }
    errors.push_back(error_of(mesh, "velocity", 0, vortex_x));
  }
  INFO("motion " << static_cast<int>(motion) << " errors " << errors[0] << " " << errors[1]);
  CHECK(std::log2(errors[0] / errors[1]) > 1.7);
}

TEST_CASE("corrections of a step converge to a step that is implicit", "[navier_stokes]") {
  std::vector<std::vector<double>> velocities;
  for (const int corrections : {0, 1, 2, 3}) {
    Mesh mesh(mapped_square(
        2, 6,
        [](double x, double y) {
          return Point{x, y};
        },
        true));
    const FlowProblem problem = vortex_problem(mesh);
    FlowOptions options;
    options.corrections = corrections;
    NavierStokes(problem, mesh, options).initialise();
    take_step(problem, mesh, options, MeshMotion::harmonic, 0.02, {});
    take_step(problem, mesh, options, MeshMotion::harmonic, 0.02, 0.02);
    velocities.push_back(mesh.fields()[index(find_field(mesh, "velocity"))].values);
  }
  std::vector<double> changes;
  for (std::size_t k = 1; k < velocities.size(); ++k) {
    double change = 0;
    for (std::size_t i = 0; i < velocities[k].size(); ++i)
      change = std::max(change, std::abs(velocities[k][i] - velocities[k - 1][i]));
    changes.push_back(change);
  }
  CAPTURE(changes[0], changes[1], changes[2]);
  CHECK(changes[0] > 1e-6);
  CHECK(changes[1] < 0.1 * changes[0]);
  CHECK(changes[2] < 0.1 * changes[1]);
}
