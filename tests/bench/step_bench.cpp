// tests/bench/step_bench.cpp: a step in memory in which little is to be done, whole and by stage.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pliant/flow/velocity_field.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "stages/run_stage.h"
#include "stages/table.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

constexpr double triangles_per_cell = 60;  // as `refine` leaves them

/// Processor time of this process, in seconds.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The stages of a pipe, and the processor time that each has taken; what is between two of them counts for the latter.
class Step {
 public:
  explicit Step(const std::vector<std::string>& motion) {
    stages_.push_back(parse_stage(motion));
    for (const char* name : {"flipdelaunay", "refine", "coarsen", "smoothcurves"})
      stages_.push_back(parse_stage({name}));
    seconds_.resize(stages_.size());
  }

  void run(Mesh& mesh) {
    const Stage* before = stages_.back().get();
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      const double start = processor_seconds();
      hand_over(mesh, *before, *stages_[k]);
      report_ = run_stage(*stages_[k], mesh, {});
      seconds_[k] += processor_seconds() - start;
      before = stages_[k].get();
      changes_ += changes_of(report_);
    }
  }

  /// Insertions, removals, flips and smoothed edges so far.
  double changes() const { return changes_; }

  /// Nanoseconds for a triangle, by stage.
  void report(benchmark::State& state, const Mesh& mesh) const {
    const double triangles = static_cast<double>(state.iterations()) * mesh.triangle_count();
    state.counters["triangles"] = mesh.triangle_count();
    state.counters["changes"] = changes_ / static_cast<double>(state.iterations());
    state.counters["a_second"] = benchmark::Counter(triangles, benchmark::Counter::kIsRate);
    for (std::size_t k = 0; k < stages_.size(); ++k)
      state.counters[std::to_string(k) + "_" + stages_[k]->name() + "_ns"] = 1e9 * seconds_[k] / triangles;
  }

 private:
  static double changes_of(const PassReport& report) {
    double sum = 0;
    for (const auto& [name, value] : report.values)
      if (name == "flips" || name == "insertions" || name == "removals" || name == "edges_smoothed") sum += value;
    return sum;
  }

  std::vector<std::unique_ptr<Stage>> stages_;
  std::vector<double> seconds_;
  PassReport report_;
  double changes_ = 0;
};

/// A unit square with a round cell in it, finely meshed: few elements are at curves.
Mesh one_cell(double triangles) {
  BoundaryComplex boundary = samples::square();
  boundary.faces.push_back({"cell", {}});
  boundary.curves.push_back(samples::closed_curve("membrane", samples::circle(2, {0.5, 0.75}, 0.15, 16), 1, 0));
  Mesh mesh;
  mesh_from_boundary(boundary, {2}, mesh);
  mesh.criteria.max_area = 1.7 / triangles;
  return mesh;
}

/// The same square full of round cells, as coarse as the angles and the curves allow: most elements are at curves.
Mesh many_cells(double triangles) {
  const int rows = static_cast<int>(std::sqrt(triangles / triangles_per_cell));
  BoundaryComplex boundary = samples::square();
  for (int k = 0; k < rows * rows; ++k) {
    const int row = k / rows;
    const double x = (k % rows + 0.5) / rows, y = (row + 0.5) / rows, radius = (0.36 + 0.02 * (k % 3)) / rows;
    boundary.faces.push_back({"cell " + std::to_string(k), {}});
    boundary.curves.push_back(
        samples::closed_curve("membrane " + std::to_string(k), samples::circle(2, {x, y}, radius, 16), k + 1, 0));
  }
  Mesh mesh;
  mesh_from_boundary(boundary, {2}, mesh);
  return mesh;
}

void carry_fields(Mesh& mesh) {
  const VelocityField vortex = make_flow("reversed-vortex", {});
  const NodeFunction velocity = [&](const Point& place, std::span<double> value) {
    const Vector v = vortex(place, 0);
    value[0] = v.x;
    value[1] = v.y;
  };
  const NodeFunction dye = [](const Point& place, std::span<double> value) { value[0] = place.x * place.y; };
  std::string why;
  mesh.set_field(make_field(mesh, "velocity", 2, none, velocity, why));
  mesh.set_field(make_field(mesh, "dye", 1, none, dye, why));
}

/// About so many triangles after some steps of the vortex, and the steps that then repair what is left to repair. They
/// carry their velocity and another field.
const Mesh& moved(Mesh (*make)(double triangles), std::int64_t triangles) {
  static std::map<std::pair<void*, std::int64_t>, Mesh> made;
  const auto [at, is_new] = made.try_emplace({reinterpret_cast<void*>(make), triangles});
  Mesh& mesh = at->second;
  if (!is_new) return mesh;
  mesh = make(static_cast<double>(triangles));
  mesh.criteria.min_angle = 20.7;
  mesh.criteria.max_turning = 30;
  run_stage(*parse_stage({"refine"}), mesh, {});
  carry_fields(mesh);
  Step moving({"advect", "--flow", "reversed-vortex", "--dt", "0.01", "--limit"});
  for (int k = 0; k < 5; ++k) moving.run(mesh);
  Step resting({"advect", "--flow", "reversed-vortex", "--dt", "1e-9"});
  for (double before = -1; resting.changes() > before;) {
    before = resting.changes();
    resting.run(mesh);
  }
  return mesh;
}

void quiet_step(benchmark::State& state, Mesh (*make)(double), const std::vector<std::string>& motion) {
  Mesh mesh = moved(make, state.range(0));
  Step step(motion);
  for (auto _ : state) step.run(mesh);
  step.report(state, mesh);
}

void sizes(benchmark::internal::Benchmark* of) {
  for (const std::int64_t triangles : {10000, 100000, 1000000}) of->Arg(triangles);
}
const std::vector<std::string> carried{"advect", "--velocity-field", "velocity", "--dt", "1e-9"};
const std::vector<std::string> vortex{"advect", "--flow", "reversed-vortex", "--dt", "1e-9"};
const std::vector<std::string> shear{"advect", "--flow", "shear", "--dt", "1e-9"};
BENCHMARK_CAPTURE(quiet_step, carried, one_cell, carried)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quiet_step, vortex, one_cell, vortex)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quiet_step, shear, one_cell, shear)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quiet_step, many_cells, many_cells, carried)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
