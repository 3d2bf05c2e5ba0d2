// tests/bench/quality_bench.cpp: the audit of a million quadratic elements, in memory.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "pliant/geometry/net_layout.h"
#include "pliant/quality/element/element_forms.h"
#include "pliant/quality/element/element_measures.h"
#include "pliant/quality/element/element_quality.h"
#include "pliant/quality/quality_report.h"

using namespace pliant;

namespace {

enum Bending { straight, bent };

/// A square grid cut into triangles, its vertices moved by chance, their order too; all edges straight, or all bent.
const MeshData& grid(Bending bending) {
  static const std::array<MeshData, 2> meshes = [] {
    std::array<MeshData, 2> both;
    constexpr int cells = 708;
    for (const Bending kind : {straight, bent}) {
      std::mt19937_64 random(1);
      std::uniform_real_distribution<double> unit(-1, 1);
      MeshData& data = both[static_cast<std::size_t>(kind)];
      data.boundary.faces.push_back({"square", {}});
      constexpr int side = 2 * cells + 1;  // vertices, and the middles of all edges
      std::vector<PointId> shuffled;
      for (PointId p = 0; p < side * side; ++p) shuffled.push_back(p);
      std::shuffle(shuffled.begin(), shuffled.end(), random);
      data.points.resize(shuffled.size());
      const auto id = [&](int x, int y) { return shuffled[static_cast<std::size_t>(y * side + x)]; };
      const auto point = [&](int x, int y) -> Point& { return data.points[static_cast<std::size_t>(id(x, y))]; };
      for (int y = 0; y < side; y += 2)
        for (int x = 0; x < side; x += 2) point(x, y) = Point{x + 0.3 * unit(random), y + 0.3 * unit(random)};
      const auto middle = [&](int x, int y, int dx, int dy) {
        point(x, y) = 0.5 * (point(x - dx, y - dy) + point(x + dx, y + dy));
        if (kind == bent) point(x, y) += 0.1 * Point{unit(random), unit(random)};
      };
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          if (x % 2 == 1 || y % 2 == 1) middle(x, y, x % 2, y % 2);
      for (int y = 0; y + 2 < side; y += 2)
        for (int x = 0; x + 2 < side; x += 2) {
          data.triangles.insert(data.triangles.end(), {id(x, y), id(x + 2, y), id(x + 2, y + 2), id(x + 1, y),
                                                       id(x + 2, y + 1), id(x + 1, y + 1)});
          data.triangles.insert(data.triangles.end(), {id(x, y), id(x + 2, y + 2), id(x, y + 2), id(x + 1, y + 1),
                                                       id(x + 1, y + 2), id(x, y + 1)});
          data.triangle_faces.insert(data.triangle_faces.end(), 2, 0);
        }
    }
    return both;
  }();
  return meshes[static_cast<std::size_t>(bending)];
}

void count(benchmark::State& state, const MeshData& data) {
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(data.triangle_faces.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void measure(benchmark::State& state, Bending bending) {
  const MeshData& data = grid(bending);
  std::vector<TriangleId> all(data.triangle_faces.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<TriangleId>(t);
  for (auto _ : state) {
    double least = HUGE_VAL, most_distorted = 0;
    measure_elements(data, all, 1e-3, [&](std::size_t, std::span<const ElementMeasures> measures) {
      for (const ElementMeasures& m : measures) {
        least = std::min(least, m.jacobian);
        most_distorted = std::max(most_distorted, m.distortion);
      }
    });
    benchmark::DoNotOptimize(least + most_distorted);
  }
  count(state, data);
}
/// Validity, distortion and the bounds of det J alone.
void audit(benchmark::State& state, Bending bending) {
  const MeshData& data = grid(bending);
  std::array<Point, 6> net;
  ElementForms forms;
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t t = 0; t < data.triangle_faces.size(); ++t) {
      for (std::size_t k = 0; k < 6; ++k) net[k] = data.points[static_cast<std::size_t>(data.triangles[6 * t + k])];
      element_forms(2, net, forms);
      const FormRange range = jacobian_range(forms, 1e-3);
      sum += distortion(forms) + range.least.lower + range.greatest.upper + static_cast<double>(certify(2, net));
    }
    benchmark::DoNotOptimize(sum);
  }
  count(state, data);
}
void report(benchmark::State& state, Bending bending) {
  const MeshData& data = grid(bending);
  for (auto _ : state) benchmark::DoNotOptimize(report_quality(data));
  count(state, data);
}

BENCHMARK_CAPTURE(audit, straight, straight)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(audit, bent, bent)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measure, straight, straight)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measure, bent, bent)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(report, straight, straight)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(report, bent, bent)->Unit(benchmark::kMillisecond);

}  // namespace
