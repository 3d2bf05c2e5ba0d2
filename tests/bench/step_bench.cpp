// tests/bench/step_bench.cpp: a step in memory in which little is to be done, whole and by stage.
#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pliant/flow/velocity_field.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "stages/run_stage.h"
#include "stages/table.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

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

/// A unit square with a round cell in it, about so many triangles, after some steps of the vortex that draws the cell
/// out, and the steps that then repair what is left to repair. It carries its velocity and another field.
const Mesh& moved_cell(std::int64_t triangles) {
  static std::map<std::int64_t, Mesh> made;
  const auto [at, is_new] = made.try_emplace(triangles);
  Mesh& mesh = at->second;
  if (!is_new) return mesh;
  BoundaryComplex boundary = samples::square();
  boundary.faces.push_back({"cell", {}});
  boundary.curves.push_back(samples::closed_curve("membrane", samples::circle(2, {0.5, 0.75}, 0.15, 16), 1, 0));
  mesh_from_boundary(boundary, {2}, mesh);
  mesh.criteria.min_angle = 20.7;
  mesh.criteria.max_turning = 30;
  mesh.criteria.max_area = 1.7 / static_cast<double>(triangles);
  run_stage(*parse_stage({"refine"}), mesh, {});
  const VelocityField vortex = make_flow("reversed-vortex", {});
  std::string why;
  mesh.set_field(make_field(
      mesh, "velocity", 2, none,
      [&](const Point& place, std::span<double> value) {
        const Vector v = vortex(place, 0);
        value[0] = v.x;
        value[1] = v.y;
      },
      why));
  mesh.set_field(make_field(
      mesh, "dye", 1, none, [](const Point& place, std::span<double> value) { value[0] = place.x * place.y; }, why));
  Step moving({"advect", "--flow", "reversed-vortex", "--dt", "0.01", "--limit"});
  for (int k = 0; k < 5; ++k) moving.run(mesh);
  Step resting({"advect", "--flow", "reversed-vortex", "--dt", "1e-9"});
  for (double before = -1; resting.changes() > before;) {
    before = resting.changes();
    resting.run(mesh);
  }
  return mesh;
}

void quiet_step(benchmark::State& state, const std::vector<std::string>& motion) {
  Mesh mesh = moved_cell(state.range(0));
  Step step(motion);
  for (auto _ : state) step.run(mesh);
  step.report(state, mesh);
}

void sizes(benchmark::internal::Benchmark* of) {
  for (const std::int64_t triangles : {10000, 100000, 1000000}) of->Arg(triangles);
}
BENCHMARK_CAPTURE(quiet_step, carried, {"advect", "--velocity-field", "velocity", "--dt", "1e-9"})
    ->Apply(sizes)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quiet_step, vortex, {"advect", "--flow", "reversed-vortex", "--dt", "1e-9"})
    ->Apply(sizes)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quiet_step, shear, {"advect", "--flow", "shear", "--dt", "1e-9"})
    ->Apply(sizes)
    ->Unit(benchmark::kMillisecond);

}  // namespace
