// tests/bench/refinement_bench.cpp: how many triangles a least angle takes, on domains of many kinds, and how long.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "support/hard_boundaries.h"

namespace {

using namespace pliant;
using namespace pliant::samples;

/// Refines the first mesh of a boundary; the argument is the least angle in tenths of a degree.
void refine_domain(benchmark::State& state, const std::function<BoundaryComplex()>& domain) {
  Mesh first;
  mesh_from_boundary(domain(), {}, first);
  RefineOptions options;
  options.goals.emplace();
  options.goals->min_angle = static_cast<double>(state.range(0)) / 10;
  int triangles = 0;
  double left = 0;
  for (auto _ : state) {
    Mesh mesh = first;
    const PassReport report = refine(mesh, options);
    triangles = mesh.triangle_count();
    for (const auto& [name, value] : report.values)
      if (name == "left") left = value;
  }
  state.counters["first"] = first.triangle_count();
  state.counters["triangles"] = triangles;
  state.counters["left"] = left;
}

const bool are_registered = [] {
  const std::pair<const char*, std::function<BoundaryComplex()>> domains[] = {
      {"biconcave", [] { return biconcave_cell(2); }},
      {"annulus", [] { return annulus(2, 0.97); }},
      {"channel", [] { return samples::interface(2); }},
      {"gear", [] { return gear(24); }},
      {"gear_fillet_0.3", [] { return filleted_gear(24, 0.3); }},
      {"gear_fillet_1e-3", [] { return filleted_gear(24, 1e-3); }},
      {"glyph", [] { return glyph(); }},
      {"crescent", [] { return crescent(0.3); }},
      {"wing_20", [] { return in_far_field(profile(naca_0012, 60), 20); }},
      {"wing_1e4", [] { return in_far_field(profile(naca_0012, 60), 1e4); }},
      {"cells_200", [] { return cells_in_box(200, 0.02, 1); }},
      {"cells_10000", [] { return cells_in_box(10000, 0.02, 1); }},
  };
  for (const auto& [name, domain] : domains) {
    auto* bench = benchmark::RegisterBenchmark(name, refine_domain, domain)->Unit(benchmark::kMillisecond);
    for (const int angle : {207, 250, 280, 300}) bench->Arg(angle);
  }
  return true;
}();

}  // namespace
