// tests/fem/steady_diffusion_test.cpp: patch tests, exact profiles, and orders of convergence of steady solutions.
#include <catch2/catch.hpp>
#include <numbers>

#include "fem/diffusion_problems.h"
#include "pliant/boundary/fault.h"
#include "pliant/mesh/check_mesh.h"
#include "support/mapped_meshes.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;
using Kind = DiffusionCondition::Kind;

TEST_CASE("linear functions are reproduced on curved elements of any degree", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(p);
  Mesh mesh(mapped_square(p, 3, bend));
  REQUIRE(check_structure(mesh.to_data()).empty());
  const Exact linear{[](double x, double y, double) { return 2 + 3 * x - 5 * y; },
                     [](double, double, double) { return 3.0; }, [](double, double, double) { return -5.0; }};
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].diffusivity = {Coefficient(2), Coefficient(0.5), Coefficient(1)};
  for (const std::string& side : square_sides)
    add_condition(problem, mesh.boundary(), side, Kind::value, coefficient(linear.value));
  Diffusion diffusion(problem, mesh, {});
  diffusion.solve_steady();
  const auto [l2, h1] = errors_of(mesh, linear);
  CHECK(l2 < 1e-13);
  CHECK(h1 < 1e-11);
}

TEST_CASE("a profile of two layers is exact, whatever the conductivities", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4);
  const double k = GENERATE(10.0, 1e-3, 1e6);
  CAPTURE(p, k);
  // Straight sides left and right, elements bent inside: x itself is in the space.
  const Map map = [](double x, double y) { return Point{x, y + 0.1 * x * (1 - x) * std::sin(std::numbers::pi * y)}; };
  Mesh mesh(mapped_square(p, 4, map, true));
  REQUIRE(check_structure(mesh.to_data()).empty());
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[1].diffusivity = {Coefficient(k)};
  add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(0));
  add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(1));
  DiffusionOptions options;
  options.wants_fluxes = true;
  Diffusion diffusion(problem, mesh, options);
  diffusion.solve_steady();
  const double flux = 1 / (0.5 / 1 + 0.5 / k);  // per height
  const Exact profile{[&](double x, double, double) { return x < 0.5 ? flux * x : 1 - flux / k * (1 - x); }, {}, {}};
  CHECK(errors_of(mesh, profile).l2 < 1e-12);
}

TEST_CASE("steady errors fall with order p + 1 in L2 and p in H1 on curved families", "[fem][order]") {
  const int p = GENERATE(1, 2, 3, 4);
  CAPTURE(p);
  const Exact exact{
      [](double x, double y, double) { return std::sin(2 * x + y) * std::exp(y); },
      [](double x, double y, double) { return 2 * std::cos(2 * x + y) * std::exp(y); },
      [](double x, double y, double) { return (std::cos(2 * x + y) + std::sin(2 * x + y)) * std::exp(y); }};
  const Formula source = [](double x, double y, double) {
    const double s = std::sin(2 * x + y), c = std::cos(2 * x + y);
    return -(-4 * s - s + 2 * c + s) * std::exp(y);
  };
  Errors coarse;
  for (int n = 4; n <= 8; n *= 2) {
    Mesh mesh(mapped_square(p, n, bend));
    DiffusionProblem problem = plain_problem(mesh.boundary());
    problem.materials[0].source = coefficient(source);
    for (const std::string& side : square_sides)
      add_condition(problem, mesh.boundary(), side, Kind::value, coefficient(exact.value));
    Diffusion diffusion(problem, mesh, {});
    diffusion.solve_steady();
    const Errors errors = errors_of(mesh, exact);
    if (n > 4) {
      CAPTURE(errors.l2, errors.h1);
      CHECK(order(coarse.l2, errors.l2) > p + 0.75);
      CHECK(order(coarse.h1, errors.h1) > p - 0.25);
    }
    coarse = errors;
  }
}

TEST_CASE("convection relative to the mesh: exponential layers, with their order", "[fem][order]") {
  const int p = GENERATE(1, 2, 3);
  CAPTURE(p);
  const double v = 4;  // c'' = v c' along x
  const Exact layer{[=](double x, double, double) { return std::expm1(v * x) / std::expm1(v); }, {}, {}};
  double coarse = 0;
  for (int n = 4; n <= 16; n *= 2) {
    const Map map = [](double x, double y) { return Point{x, y + 0.1 * x * (1 - x) * std::sin(std::numbers::pi * y)}; };
    Mesh mesh(mapped_square(p, n, map));
    DiffusionProblem problem = plain_problem(mesh.boundary());
    problem.convection = {Coefficient(v), Coefficient(0)};
    add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(0));
    add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(1));
    Diffusion diffusion(problem, mesh, {});
    diffusion.solve_steady();
    const double error = errors_of(mesh, layer).l2;
    if (n == 16) CHECK(order(coarse, error) > p + 0.75);
    coarse = error;
  }
}

TEST_CASE("a diffusivity that depends on the unknown is iterated to the solution", "[fem][oracle]") {
  const int p = GENERATE(2, 3);
  CAPTURE(p);
  // ((1 + c) c')' = 0 between 0 and 2: c + c^2 / 2 = 4 x.
  const Exact exact{[](double x, double, double) { return std::sqrt(1 + 8 * x) - 1; }, {}, {}};
  double coarse = 0;
  for (int n = 8; n <= 16; n *= 2) {
    const Map map = [](double x, double y) { return Point{x, y + 0.1 * x * (1 - x) * std::sin(std::numbers::pi * y)}; };
    Mesh mesh(mapped_square(p, n, map));
    DiffusionProblem problem = plain_problem(mesh.boundary());
    problem.depends_on_unknown = true;
    problem.materials[0].diffusivity = {Coefficient(
        [](const CoefficientPoint& at) {
          const auto& field = at.mesh.fields()[0];
          std::vector<double> net, value(1);
          for (const PointId q : at.mesh.net(at.triangle)) net.push_back(field.values[index(q)]);
          evaluate_net(at.mesh.degree(), 1, net, at.xi, value);
          return 1 + value[0];
        },
        "1+c")};
    add_condition(problem, mesh.boundary(), "west", Kind::value, Coefficient(0));
    add_condition(problem, mesh.boundary(), "east", Kind::value, Coefficient(2));
    Diffusion diffusion(problem, mesh, {});
    diffusion.solve_steady();
    const double error = errors_of(mesh, exact).l2;
    CAPTURE(error);
    if (n == 16) CHECK(order(coarse, error) > p + 0.3);
    coarse = error;
  }
}

TEST_CASE("meshes of any size have the same solution", "[fem]") {
  const double unit = GENERATE(1.0, 0x1p-400, 0x1p400);
  CAPTURE(unit);
  Mesh mesh([&] {
    MeshData data = mapped_square(2, 3, bend);
    data.boundary.unit = unit;  // as normalize_unit leaves a document of extreme size
    return data;
  }());
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].diffusivity = {Coefficient(unit * unit)};
  problem.materials[0].source = Coefficient(3);
  add_condition(problem, mesh.boundary(), "west", Kind::value,
                coefficient([=](double, double y, double) { return y / unit; }));
  add_condition(problem, mesh.boundary(), "east", Kind::robin, Coefficient(2 * unit), Coefficient(1));
  add_condition(problem, mesh.boundary(), "north", Kind::flux, Coefficient(unit));
  const PassReport report = solve_steady(problem, mesh);
  static std::vector<double> first;
  std::vector<double> values = mesh.fields()[0].values;
  for (const auto& [name, value] : report.values)
    values.push_back(name.starts_with("flux") || name.starts_with("total") || name == "energy" ? value / unit / unit
                                                                                               : value);
  if (first.empty()) first = values;
  REQUIRE(values.size() == first.size());
  for (std::size_t k = 0; k < values.size(); ++k) CHECK(values[k] == Approx(first[k]).epsilon(1e-11).margin(1e-14));
}
