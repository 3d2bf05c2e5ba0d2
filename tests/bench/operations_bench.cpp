// tests/bench/operations_bench.cpp: the local operations and the passes on quadratic meshes that carry two components.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <vector>

#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/flip_edge.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/remove_point.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

/// A round cell of radius 1, refined to elements of this area.
Mesh refined_cell(double area) {
  Mesh mesh;
  mesh_from_boundary(samples::one_cell(2), {2}, mesh);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area;
  refine(mesh, options);
  return mesh;
}

/// Bends all elements by a swirl that leaves the boundary alone, and adds a field of two components.
void bend_and_carry(Mesh& mesh) {
  std::vector<Point> points;
  Field field;
  field.name = "velocity";
  field.components = 2;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    const Vector d = mesh.point(p) - Point{0.3, -0.2};
    const double fade = std::max(0.0, 0.9 - squared_length(d)), angle = 2 * fade * fade;
    points.push_back(Point{0.3, -0.2} + std::cos(angle) * d + std::sin(angle) * Vector{-d.y, d.x});
    field.values.push_back(std::sin(3 * points.back().x) * std::exp(points.back().y));
    field.values.push_back(std::cos(5 * points.back().y));
  }
  mesh.set_points(std::move(points));
  mesh.set_field(std::move(field));
}

/// Some 3000 curved elements.
const Mesh& sample() {
  static const Mesh made = [] {
    Mesh mesh = refined_cell(0.0017);
    bend_and_carry(mesh);
    return mesh;
  }();
  return made;
}

std::vector<HalfEdgeId> inner_edges(const Mesh& mesh) {
  std::vector<HalfEdgeId> edges;
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.twin(h) > h && !mesh.is_constrained(h)) edges.push_back(h);
  return edges;
}

void per_item(benchmark::State& state, std::int64_t items) {
  state.SetItemsProcessed(items);
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// There and back, which is two flips; edges whose flip is refused are left out.
void flip(benchmark::State& state) {
  Mesh mesh = sample();
  const RefitOptions options{static_cast<Projection>(state.range(0))};
  std::vector<HalfEdgeId> edges;
  for (const HalfEdgeId h : inner_edges(mesh)) {
    if (flip_edge(mesh, h, options) != Outcome::done) continue;
    flip_edge(mesh, h, options);
    edges.push_back(h);
  }
  std::int64_t done = 0;
  for (auto _ : state)
    for (const HalfEdgeId h : edges)
      for (int turn = 0; turn < 2; ++turn) done += flip_edge(mesh, h, options) == Outcome::done;
  per_item(state, done);
}

void insert(benchmark::State& state) {
  std::int64_t done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = sample();
    const TriangleId count = mesh.triangle_slots();
    state.ResumeTiming();
    for (TriangleId t = 0; t < count; ++t) done += insert_point(mesh, t, {0.3, 0.45, 0.25}).outcome == Outcome::done;
  }
  per_item(state, done);
}

/// Splits of every inner edge.
void split(benchmark::State& state) {
  const std::vector<HalfEdgeId> edges = inner_edges(sample());
  std::int64_t done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = sample();
    state.ResumeTiming();
    for (std::size_t k = 0; k < edges.size(); k += 4) done += split_edge(mesh, edges[k], 0.4).outcome == Outcome::done;
  }
  per_item(state, done);
}

void split_on_curve(benchmark::State& state) {
  std::vector<HalfEdgeId> edges;
  for (const HalfEdgeId h : sample().half_edges())
    if (sample().is_constrained(h)) edges.push_back(h);
  std::int64_t done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = sample();
    state.ResumeTiming();
    for (const HalfEdgeId h : edges) done += split_edge(mesh, h, 0.4).outcome == Outcome::done;
  }
  per_item(state, done);
}

/// What `insert` did is undone.
void remove_inserted(benchmark::State& state) {
  Mesh inserted = sample();
  std::vector<PointId> vertices;
  for (TriangleId t = 0, count = inserted.triangle_slots(); t < count; ++t)
    vertices.push_back(insert_point(inserted, t, {0.3, 0.45, 0.25}).vertex);
  std::int64_t done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = inserted;
    state.ResumeTiming();
    for (const PointId v : vertices)
      if (v != none) done += remove_inner_vertex(mesh, v) == Outcome::done;
  }
  per_item(state, done);
}

/// Every eighth vertex of the mesh: ears flipped first, then projected.
void remove_any(benchmark::State& state) {
  std::int64_t done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = sample();
    state.ResumeTiming();
    for (PointId v = 0, count = 0; v < sample().point_slots(); ++v)
      if (sample().is_vertex(v) && ++count % 8 == 0) done += remove_inner_vertex(mesh, v) == Outcome::done;
  }
  per_item(state, done);
}

/// A point of every element, from the triangle with the number before, which is rarely far.
void locate_near(benchmark::State& state) {
  const Mesh& mesh = sample();
  std::vector<Point> points;
  std::vector<TriangleId> hints;
  std::vector<double> rows(static_cast<std::size_t>(mesh.net_size() * mesh.width()));
  std::vector<double> row(static_cast<std::size_t>(mesh.width()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather(t, rows);
    evaluate_net(2, mesh.width(), rows, {0.2, 0.5, 0.3}, row);
    points.push_back({row[0], row[1]});
    const HalfEdgeId g = mesh.twin(half_edge(t, 2));
    hints.push_back(g == none ? t : triangle_of(g));
  }
  Locator locator(mesh);
  std::int64_t found = 0;
  for (auto _ : state)
    for (std::size_t k = 0; k < points.size(); ++k) found += locator.find(points[k], hints[k]).has_value();
  per_item(state, found);
}

void certify_elements(benchmark::State& state) {
  const Mesh& mesh = sample();
  std::vector<Point> nets;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) nets.push_back(mesh.point(p));
  std::int64_t valid = 0;
  for (auto _ : state)
    for (std::size_t k = 0; k < nets.size(); k += 6) valid += certify(2, {nets.data() + k, 6}) == Validity::valid;
  per_item(state, valid);
}

/// About this many triangles that are Delaunay already.
const Mesh& delaunay_cell(std::int64_t triangles) {
  static std::map<std::int64_t, Mesh> made;
  const auto [at, is_new] = made.try_emplace(triangles);
  if (is_new) {
    at->second = refined_cell(4.1 / static_cast<double>(triangles));
    enforce_delaunay(at->second);
  }
  return at->second;
}

void per_triangle(benchmark::State& state, const Mesh& mesh) {
  state.counters["triangles"] = mesh.triangle_count();
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations()) * mesh.triangle_count(),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void delaunay_nothing_to_flip(benchmark::State& state) {
  Mesh mesh = delaunay_cell(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(enforce_delaunay(mesh));
  per_triangle(state, mesh);
}

/// The same, after the swirl: about an edge in three wants its flip.
void delaunay_sheared(benchmark::State& state) {
  Mesh sheared = delaunay_cell(state.range(0));
  bend_and_carry(sheared);
  double flips = 0, left = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = sheared;
    state.ResumeTiming();
    const PassReport report = enforce_delaunay(mesh);
    flips = report.values[0].second;
    left = report.values[1].second;
  }
  per_triangle(state, sheared);
  state.counters["flips"] = flips;
  state.counters["left"] = left;
}

/// From the first mesh of a cell to about so many triangles; with 0 or 2 components carried along.
void refine_cell(benchmark::State& state) {
  Mesh coarse, mesh;
  mesh_from_boundary(samples::one_cell(2), {2}, coarse);
  if (state.range(1) > 0) bend_and_carry(coarse);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = 4.1 / static_cast<double>(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    mesh = coarse;
    state.ResumeTiming();
    refine(mesh, options);
  }
  per_triangle(state, mesh);
}

/// From about so many triangles to a tenth of them.
void coarsen_cell(benchmark::State& state) {
  const Mesh& fine = delaunay_cell(state.range(0));
  CoarsenOptions options;
  options.goals.emplace();
  options.goals->max_area = 41 / static_cast<double>(state.range(0));
  options.tolerance = 1e-3 * fine.size();
  options.step_tolerance = *options.tolerance / 10;
  int left = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = fine;
    state.ResumeTiming();
    coarsen(mesh, options);
    left = mesh.triangle_count();
  }
  per_triangle(state, fine);
  state.counters["left"] = left;
}

BENCHMARK(flip)
    ->Arg(static_cast<int>(Projection::limited))
    ->Arg(static_cast<int>(Projection::l2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK(insert)->Unit(benchmark::kMillisecond);
BENCHMARK(split)->Unit(benchmark::kMillisecond);
BENCHMARK(split_on_curve)->Unit(benchmark::kMillisecond);
BENCHMARK(remove_inserted)->Unit(benchmark::kMillisecond);
BENCHMARK(remove_any)->Unit(benchmark::kMillisecond);
BENCHMARK(locate_near)->Unit(benchmark::kMillisecond);
BENCHMARK(certify_elements)->Unit(benchmark::kMillisecond);
void sizes(benchmark::internal::Benchmark* of) {
  for (const std::int64_t triangles : {10000, 100000, 1000000}) of->Arg(triangles);
}
BENCHMARK(delaunay_nothing_to_flip)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(delaunay_sheared)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(refine_cell)->ArgsProduct({{10000, 100000, 1000000}, {0, 2}})->Unit(benchmark::kMillisecond);
BENCHMARK(coarsen_cell)->Apply(sizes)->Unit(benchmark::kMillisecond);

}  // namespace
