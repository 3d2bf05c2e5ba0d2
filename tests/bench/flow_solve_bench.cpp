// tests/bench/flow_solve_bench.cpp: linear systems of incompressible flow: viscosities, enclosed flows, factors reused;
// and the extension of velocities into the mesh.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pliant/fem/element_matrices.h"
#include "pliant/fem/navier_stokes/mesh_velocity.h"
#include "pliant/fem/solve/gmres.h"
#include "pliant/fem/sparsity.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A channel with two drops, of elements of at most so many millionths in area.
const Mesh& channel(int degree, int area) {
  static std::map<std::pair<int, int>, Mesh> made;
  Mesh& mesh = made[{degree, area}];
  if (mesh.triangle_count() == 0) {
    mesh_from_boundary(samples::interface(degree), {degree}, mesh);
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = 1e-6 * area;
    refine(mesh, options);
    mesh.renumber();
  }
  return mesh;
}

/// The coefficients of a system; density 1.
struct Fluid {
  double viscosity = 1;
  double jump = 1;  ///< drops have so many times the viscosity
  double dt = 0;    ///< 0: steady
  double wind = 0;  ///< greatest velocity of the convection
  bool is_enclosed = false;
  double moved = 0;  ///< how far control points are from those of the mesh
};
struct System {
  CsrMatrix a;
  std::vector<bool> multipliers;
  int pressure = 0;  ///< the first one
};

/// Taylor-Hood with velocities given on the outer curves, but where the channel ends if it is not enclosed.
System make_system(const Mesh& mesh, const Fluid& fluid) {
  const int p = mesh.degree();
  const Space velocity = Space::continuous(mesh);
  const Space pressure = Space::by_face(mesh, p - 1, std::vector<char>(mesh.boundary().curves.size(), 0));
  const int n = velocity.size(), nv = velocity.element_size(), nq = pressure.element_size(), size = 2 * nv + nq;
  std::vector<bool> fixed(index(2 * n + pressure.size()), false);
  std::vector<int> members;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    for (const int first : {0, n})
      for (const int i : velocity.of(t)) members.push_back(first + i);
    for (const int i : pressure.of(t)) members.push_back(2 * n + i);
  }
  const double end = mesh.box().high.x;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (mesh.twin(h) != none) continue;
    const bool is_outlet = mesh.point(mesh.origin(h)).x == end && mesh.point(mesh.target(h)).x == end;
    if (is_outlet && !fluid.is_enclosed) continue;
    for (int k = 0; k <= p; ++k) {
      const int i = velocity.of(triangle_of(h))[index(mesh.layout().edge_index(edge_of(h), k))];
      fixed[index(i)] = fixed[index(n + i)] = true;
    }
  }
  const Groups kinds[] = {{size, members}};
  const Sparsity sparsity = make_sparsity(static_cast<int>(fixed.size()), kinds);
  System system{{sparsity.pattern, std::vector<double>(sparsity.pattern->columns.size(), 0.0)}, {}, 2 * n};
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for (Point& at : points)
    at += fluid.moved * Vector{std::sin(3 * at.y) * std::sin(2 * at.x), std::cos(2 * at.x + at.y)};

  ElementMap map(p);
  const std::size_t nn = index(nv * nv);
  std::vector<double> pairs(index(nv * (nv + 1) / 2)), stiffness(nn), mass(nn), convection(nn);
  std::vector<double> along_x(index(nq * nv)), along_y(along_x), full(index(size * size));
  const auto at = [size](int i, int j) { return index(i * size + j); };
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    map.set(mesh, points, t, Integrand::varying);
    const double mu = fluid.viscosity * (mesh.face(t) == 0 ? 1 : fluid.jump);
    element_stiffness(map, std::vector<SymmetricTensor>(index(map.points()), {mu, 0, mu}), pairs);
    unpack_pairs(nv, pairs, stiffness);
    element_mass(map, std::vector<double>(index(map.points()), fluid.dt > 0 ? 1 / fluid.dt : 0), pairs);
    unpack_pairs(nv, pairs, mass);
    std::vector<Vector> wind;
    for (int q = 0; q < map.points(); ++q) {
      const Point x = map.place(q);
      wind.push_back(fluid.wind * Vector{4 * x.y * (1 - x.y), 0.1 * std::sin(x.x)});
    }
    element_convection(map, wind, convection);
    element_divergence(map, p - 1, along_x, along_y);
    std::ranges::fill(full, 0.0);
    for (int i = 0; i < nv; ++i) {
      for (int j = 0; j < nv; ++j)
        full[at(i, j)] = full[at(nv + i, nv + j)] =
            stiffness[index(i * nv + j)] + mass[index(i * nv + j)] + convection[index(i * nv + j)];
      for (int q = 0; q < nq; ++q) {
        full[at(2 * nv + q, i)] = full[at(i, 2 * nv + q)] = -along_x[index(q * nv + i)];
        full[at(2 * nv + q, nv + i)] = full[at(nv + i, 2 * nv + q)] = -along_y[index(q * nv + i)];
      }
    }
    scatter(std::span(sparsity.places[0]).subspan(index(t) * full.size(), full.size()), full, system.a.values);
  }
  const CsrPattern& pattern = *sparsity.pattern;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      const int j = pattern.columns[index(k)];
      if ((fixed[index(i)] || fixed[index(j)]) && i != j) system.a.values[index(k)] = 0;
    }
  for (std::size_t i = 0; i < fixed.size(); ++i) system.multipliers.push_back(i >= index(2 * n));
  return system;
}

/// A row and column of the identity for the first pressure.
void pin(System& system) {
  const CsrPattern& pattern = *system.a.pattern;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      const int j = pattern.columns[index(k)];
      if (i == system.pressure || j == system.pressure) system.a.values[index(k)] = i == j ? 1 : 0;
    }
}

std::vector<double> known_solution(const System& system) {
  std::vector<double> x;
  unsigned state = 12345;
  for (int i = 0; i < system.a.rows(); ++i) {
    state = state * 1664525U + 1013904223U;
    x.push_back(i == system.pressure ? 0 : static_cast<double>(state) / 0x1p32 - 0.5);
  }
  return x;
}

/// Arguments: degree, millionths of the area.
void factor_and_solve(benchmark::State& state, const Fluid& fluid, bool by_lu, bool pins) {
  System system = make_system(channel(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))), fluid);
  if (pins) pin(system);
  const std::vector<double> expected = known_solution(system);
  std::vector<double> b(expected.size()), x(b.size());
  multiply(system.a, expected, b);
  for (auto _ : state) {
    const auto solver = by_lu ? make_direct_general() : make_quasi_definite(system.multipliers);
    const double start = seconds();
    if (const std::string why = solver->factor(system.a); !why.empty()) return state.SkipWithError(why.c_str());
    const double factored = seconds();
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    state.counters["factor_s"] = factored - start;
    state.counters["solve_s"] = seconds() - factored;
    state.counters["residual"] = outcome.residual;
    if (!outcome.converged) return state.SkipWithError(outcome.why.c_str());
  }
  double velocity = 0, pressure = 0;  // errors; without a pin x and the solution may differ by a constant
  const double shift = x[index(system.pressure)] - expected[index(system.pressure)];
  for (std::size_t i = 0; i < x.size(); ++i)
    if (system.multipliers[i])
      pressure = std::max(pressure, std::abs(x[i] - expected[i] - (fluid.is_enclosed ? shift : 0)));
    else
      velocity = std::max(velocity, std::abs(x[i] - expected[i]));
  state.counters["rows"] = system.a.rows();
  state.counters["velocity"] = velocity;
  state.counters["pressure"] = pressure;
}

/// Solves one fluid's system by GMRES with factors of another's.
void reuse(benchmark::State& state, Fluid factored, const Fluid& solved, bool by_lu) {
  const Mesh& mesh = channel(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const double edge = std::sqrt(1e-6 * static_cast<double>(state.range(1)));
  Fluid other = solved;
  other.moved *= edge;
  const System of_factors = make_system(mesh, factored), system = make_system(mesh, other);
  const std::vector<double> expected = known_solution(system);
  std::vector<double> b(expected.size()), x(b.size());
  multiply(system.a, expected, b);
  const auto solver = by_lu ? make_direct_general() : make_quasi_definite(of_factors.multipliers);
  const double start = seconds();
  solver->factor(of_factors.a);
  state.counters["factor_s"] = seconds() - start;
  for (auto _ : state) {
    std::ranges::fill(x, 0.0);
    const double before = seconds();
    const SolveOutcome outcome = solve_by_gmres(system.a, *solver, b, x, {.tolerance = 1e-9});
    state.counters["solve_s"] = seconds() - before;
    state.counters["iterations"] = outcome.iterations;
    if (!outcome.converged) return state.SkipWithError(outcome.why.c_str());
  }
  state.counters["rows"] = system.a.rows();
}

void extend(benchmark::State& state, MeshMotion motion) {
  const Mesh& mesh = channel(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::vector<CurveMotion> motions(6, CurveMotion::stays);
  motions[4] = motions[5] = CurveMotion::follows;
  const std::vector<double> u(2 * index(mesh.point_slots()), 1.0);
  for (auto _ : state) {
    const double start = seconds();
    const MeshVelocity extension(mesh, motions, motion);
    const double made = seconds();
    benchmark::DoNotOptimize(extension.extend(u).data());
    state.counters["make_s"] = made - start;
    state.counters["extend_s"] = seconds() - made;
  }
  state.counters["points"] = mesh.point_slots();
}

const int registered = [] {
  const auto add = [](const std::string& name, auto function, std::initializer_list<std::pair<int, int>> sizes) {
    auto* const bench = benchmark::RegisterBenchmark(name.c_str(), function)->Iterations(1);
    for (const auto& [degree, area] : sizes) bench->Args({degree, area});
  };
  for (const bool by_lu : {true, false})
    for (const bool enclosed : {false, true})
      for (const auto& [viscosity, jump] : {std::pair(1e-3, 1.0), {1.0, 1.0}, {1e3, 1.0}, {1.0, 1e3}}) {
        const Fluid fluid{.viscosity = viscosity, .jump = jump, .is_enclosed = enclosed};
        const std::string name = std::string(by_lu ? "lu" : "ldlt") + (enclosed ? "/enclosed" : "/stokes") +
                                 "/mu:" + std::to_string(viscosity).substr(0, 5) + "/jump:" + (jump > 1 ? "1000" : "1");
        const bool pins = by_lu && enclosed;
        add(name, [=](benchmark::State& state) { factor_and_solve(state, fluid, by_lu, pins); },
            {{2, 2000}, {2, 160}, {3, 1000}});
      }
  for (const auto& [viscosity, jump] : {std::pair(1e-3, 1.0), {1.0, 1.0}, {1e3, 1.0}, {1e-3, 1e3}, {1.0, 1e3}}) {
    const Fluid fluid{.viscosity = viscosity, .jump = jump, .dt = 0.01, .wind = 1};
    const std::string name = "lu/convection/mu:" + std::to_string(viscosity).substr(0, 5) + "/jump:";
    add(name + (jump > 1 ? "1000" : "1"), [=](benchmark::State& state) { factor_and_solve(state, fluid, true, false); },
        {{2, 2000}, {2, 160}});
  }
  for (const double dt : {0.005, 0.01, 0.05, 0.0}) {
    Fluid convective{.viscosity = dt > 0 ? 0.01 : 0.05, .dt = dt, .wind = 1};
    Fluid symmetric = convective;
    symmetric.wind = 0;
    const std::string name = "reuse/dt:" + std::to_string(dt).substr(0, 5);
    add(name + "/symmetric_part", [=](benchmark::State& state) { reuse(state, symmetric, convective, false); },
        {{2, 600}});
    for (const double moved : {0.1, 0.5, 2.0}) {
      Fluid after = convective;
      after.moved = moved;
      add(name + "/moved_by_edges:" + std::to_string(moved).substr(0, 3),
          [=](benchmark::State& state) { reuse(state, convective, after, true); }, {{2, 600}});
    }
    Fluid faster = convective;
    faster.wind = 1.1;
    add(name + "/wind:1.1", [=](benchmark::State& state) { reuse(state, convective, faster, true); }, {{2, 600}});
  }
  for (const auto& [name, motion] : {std::pair("harmonic", MeshMotion::harmonic), {"blend", MeshMotion::blend}})
    add(std::string("extend/") + name, [motion = motion](benchmark::State& state) { extend(state, motion); },
        {{2, 400}, {2, 55}});
  return 0;
}();

}  // namespace
