// tests/bench/placement_bench.cpp: the best place of one control point, as a smoother of curves asks for it.
#include <benchmark/benchmark.h>

#include <vector>

#include "pliant/geometry/placement/optimal_placement.h"
#include "support/placement_stars.h"

namespace {

using namespace pliant;
using samples::StarKind;

struct Asked {
  samples::PlacementStar star;
  std::vector<PlacementElement> elements;
};

/// Pairs with the point of the common edge off its best place: valid ones, or tangled ones that a place makes valid.
std::vector<Asked> bent_pairs(int degree, bool tangled, std::size_t count = 1000) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  std::vector<Asked> all;
  while (all.size() < count) {
    samples::PlacementStar star = random_star(degree, StarKind::edge, 0.5, random);
    if (untangle_point(degree, star.elements(), star.place()).outcome != Placement::Outcome::placed) continue;
    star.move(star.place() + (tangled ? 1.5 : 0.5) / degree * Vector{unit(random), unit(random)});
    if (star.is_valid() != tangled) all.push_back({star, {}});
  }
  for (Asked& asked : all) asked.elements = asked.star.elements();
  return all;
}

template <class Place>
void place_all(benchmark::State& state, bool tangled, Place place) {
  const int degree = static_cast<int>(state.range(0));
  const std::vector<Asked> pairs = bent_pairs(degree, tangled);
  std::int64_t placed = 0;
  for (auto _ : state)
    for (const Asked& asked : pairs)
      placed += place(degree, asked.elements, asked.star.place()).outcome == Placement::Outcome::placed;
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations() * 1000),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["placed"] = static_cast<double>(placed) / static_cast<double>(state.iterations() * 1000);
}

void untangle_tangled(benchmark::State& state) {
  place_all(state, true, [](int degree, const auto& elements, const Point& start) {
    return untangle_point(degree, elements, start);
  });
}
void untangle_valid(benchmark::State& state) {
  place_all(state, false, [](int degree, const auto& elements, const Point& start) {
    return untangle_point(degree, elements, start);
  });
}
void improve_valid(benchmark::State& state) {
  place_all(state, false, [](int degree, const auto& elements, const Point& start) {
    return improve_point(degree, elements, start);
  });
}

void improve_with_accuracy(benchmark::State& state, double accuracy) {
  place_all(state, false, [accuracy](int degree, const auto& elements, const Point& start) {
    return improve_point(degree, elements, start, PlacementMeasure::element, accuracy);
  });
}
void improve_tangled(benchmark::State& state) {
  place_all(state, true, [](int degree, const auto& elements, const Point& start) {
    return improve_point(degree, elements, start);
  });
}
void improve_control(benchmark::State& state) {
  place_all(state, false, [](int degree, const auto& elements, const Point& start) {
    return improve_point(degree, elements, start, PlacementMeasure::control_mesh);
  });
}

}  // namespace

BENCHMARK(untangle_tangled)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK(untangle_valid)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK(improve_valid)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(improve_with_accuracy, exact, 1e-10)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(improve_with_accuracy, coarse, 2e-3)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK(improve_tangled)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
BENCHMARK(improve_control)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);
