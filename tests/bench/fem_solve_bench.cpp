// tests/bench/fem_solve_bench.cpp: the linear solvers of the finite elements, on Poisson's problem and on a heat step.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#define EIGEN_MPL2_ONLY
#include <Eigen/SparseCholesky>

#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "support/bernstein_matrices.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

struct System {
  CsrMatrix a;
  std::vector<double> b, guess;
  CoarseSpace hats;
};

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A member of /proc/self/status, in MB.
double status(const std::string& member) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(member + ":")) return std::stod(line.substr(member.size() + 1)) / 1024;
  return 0;
}

/// The high-water mark is from now on that of what comes; memory that is free goes back first.
double start_measuring_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return status("VmRSS");
}

/// A round cell of radius 1 with quadratic elements, which make about so many unknowns; numbered along Hilbert's curve.
const Mesh& cell(int unknowns) {
  static std::map<int, Mesh> made;
  Mesh& mesh = made[unknowns];
  if (mesh.triangle_count() == 0) {
    mesh_from_boundary(samples::one_cell(2), {2}, mesh);
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = 8.5 / unknowns;
    refine(mesh, options);
    mesh.renumber();
  }
  return mesh;
}

/// Poisson's problem with the load 1 and values given on the curve (microseconds == 0), or a heat step of so many
/// microseconds on a domain of area 1, from a bump and a front.
System make_system(int unknowns, long microseconds) {
  const Mesh& mesh = cell(unknowns);
  samples::MassAndStiffness both = samples::mass_and_stiffness(mesh);
  for (double& value : both.mass.values) value /= std::numbers::pi;  // as if the area were 1
  System result;
  std::vector<double> before;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    const Point& at = mesh.point(p);
    before.push_back(microseconds == 0 ? 1 : std::exp(-20 * squared_length(at - Point{0.3, 0})) + (at.x > 0 ? 1 : 0));
  }
  result.b.resize(before.size());
  multiply(both.mass, before, result.b);
  result.guess = before;
  if (microseconds == 0) {
    result.a = both.stiffness;
    const std::vector<bool> fixed = samples::on_curves(mesh);
    samples::fix(result.a, fixed);
    for (std::size_t i = 0; i < fixed.size(); ++i)
      if (fixed[i]) result.b[i] = 0;
    result.guess.assign(before.size(), 0);
  } else {
    result.a = samples::sum(both.mass, 1e-6 * static_cast<double>(microseconds), both.stiffness);
  }
  std::vector<int> nets;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    nets.insert(nets.end(), mesh.net(t).begin(), mesh.net(t).end());
  result.hats = hat_functions(2, nets, mesh.point_slots());
  return result;
}

using MakeSolver = std::function<std::unique_ptr<LinearSolver>(const System&)>;

/// Arguments: unknowns, microseconds of the time step.
void solve(benchmark::State& state, const MakeSolver& make) {
  const System system = make_system(static_cast<int>(state.range(0)), state.range(1));
  double factor = 0, solution = 0, memory = 0;
  SolveOutcome outcome;
  for (auto _ : state) {
    std::vector<double> x = system.guess;
    const double loaded = start_measuring_memory(), start = seconds();
    const auto solver = make(system);
    if (const std::string why = solver->factor(system.a); !why.empty()) return state.SkipWithError(why.c_str());
    factor = seconds() - start;
    outcome = solver->solve(system.b, x, solver_tolerance);
    solution = seconds() - start - factor;
    memory = status("VmHWM") - loaded;
    if (!outcome.converged) return state.SkipWithError(outcome.why.c_str());
  }
  state.counters["rows"] = system.a.rows();
  state.counters["factor_s"] = factor;
  state.counters["solve_s"] = solution;
  state.counters["MB"] = memory;
  state.counters["iterations"] = outcome.iterations;
  state.counters["residual"] = outcome.residual;
  state.counters["rounding"] = outcome.rounding;
}

/// What LDL^T is compared with.
void eigen_ldlt(benchmark::State& state) {
  const System system = make_system(static_cast<int>(state.range(0)), state.range(1));
  const CsrPattern& pattern = *system.a.pattern;
  std::vector<Eigen::Triplet<double, int>> lower;
  for (int i = 0; i < system.a.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k)
      if (const int j = pattern.columns[index(k)]; j <= i && system.a.values[index(k)] != 0)
        lower.emplace_back(i, j, system.a.values[index(k)]);
  Eigen::SparseMatrix<double> a(system.a.rows(), system.a.rows());
  a.setFromTriplets(lower.begin(), lower.end());
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(system.b.data(), a.rows());
  double factor = 0, solution = 0, memory = 0;
  for (auto _ : state) {
    const double loaded = start_measuring_memory(), start = seconds();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(a);
    factor = seconds() - start;
    const Eigen::VectorXd x = ldlt.solve(b);
    solution = seconds() - start - factor;
    memory = status("VmHWM") - loaded;
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["rows"] = system.a.rows();
  state.counters["factor_s"] = factor;
  state.counters["solve_s"] = solution;
  state.counters["MB"] = memory;
}

void on_sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgsProduct({{3000, 12000, 47000, 187000, 936000}, {0, 10, 100, 1000, 10000}});
  bench->Unit(benchmark::kSecond)->Iterations(1);
}

const bool are_registered = [] {
  const std::pair<const char*, MakeSolver> solvers[] = {
      {"direct", [](const System&) { return make_direct_symmetric(); }},
      {"lu", [](const System&) { return make_direct_general(); }},
      {"gradients", [](const System&) { return make_conjugate_gradients(); }},
      {"two_level", [](const System& system) { return make_two_level(system.hats); }},
      {"chosen", [](const System& s) { return make_symmetric_solver(s.a.rows(), s.guess[0] != 0, &s.hats); }},
      {"chosen_without_hats", [](const System& s) { return make_symmetric_solver(s.a.rows(), s.guess[0] != 0); }}};
  for (const auto& [name, make] : solvers) on_sizes(benchmark::RegisterBenchmark(name, solve, make));
  on_sizes(benchmark::RegisterBenchmark("eigen_ldlt", eigen_ldlt));
  return true;
}();

}  // namespace
