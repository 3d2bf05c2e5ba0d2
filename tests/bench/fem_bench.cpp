// tests/bench/fem_bench.cpp: the parts of a finite element solution on a curved mesh: pattern, element matrices, rows.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "fem/diffusion_problems.h"
#include "support/mapped_meshes.h"

namespace {

using namespace pliant;

/// A curved mesh of 2 n^2 triangles of degree p, made once.
const Mesh& mesh_of(int p, int n) {
  static std::map<std::pair<int, int>, std::unique_ptr<Mesh>> meshes;
  std::unique_ptr<Mesh>& mesh = meshes[{p, n}];
  if (!mesh) mesh = std::make_unique<Mesh>(samples::mapped_square(p, n, samples::bend));
  return *mesh;
}

void report(benchmark::State& state, const Mesh& mesh) {
  state.counters["elements"] = mesh.triangle_count();
  state.counters["a_second"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * mesh.triangle_count(), benchmark::Counter::kIsRate);
}

/// Mass and stiffness of each element, kept nowhere.
void element_matrices(benchmark::State& state) {
  const Mesh& mesh = mesh_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const DiffusionProblem problem = samples::plain_problem(mesh.boundary());
  const auto points = mesh.points();
  for (auto _ : state) {
    ElementTerms terms(problem, mesh);
    double sum = 0;
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      terms.set({points, 0}, t);
      sum += terms.mass()[0] + terms.diffusion()[0];
    }
    benchmark::DoNotOptimize(sum);
  }
  report(state, mesh);
}

/// Unknowns, pattern, and where entries go: once for each topology.
void pattern(benchmark::State& state) {
  const Mesh& mesh = mesh_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const DiffusionProblem problem = samples::plain_problem(mesh.boundary());
  for (auto _ : state) {
    const DiffusionEquation equation(problem, mesh);
    benchmark::DoNotOptimize(equation.pattern().columns.data());
  }
  report(state, mesh);
}

/// Mass and stiffness in rows, the pattern known.
void fill(benchmark::State& state) {
  const Mesh& mesh = mesh_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const DiffusionProblem problem = samples::plain_problem(mesh.boundary());
  const DiffusionEquation equation(problem, mesh);
  const auto points = mesh.points();
  DiffusionSystem system;
  for (auto _ : state) equation.assemble({points, 0}, system);
  report(state, mesh);
  state.counters["entries"] = static_cast<double>(equation.pattern().columns.size());
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Args({2, 216})->Args({2, 483})->Args({1, 483})->Args({3, 150})->Args({4, 100})->Unit(benchmark::kMillisecond);
}
BENCHMARK(element_matrices)->Apply(sizes);
BENCHMARK(pattern)->Apply(sizes);
BENCHMARK(fill)->Apply(sizes);

}  // namespace
