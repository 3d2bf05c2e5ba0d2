// tests/bench/locate_bench.cpp: finding points in quadratic meshes of 10^4 to 10^6 triangles, near, far, one and many.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/control_net.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/locate.h"
#include "support/sample_boundaries.h"

namespace {

using namespace pliant;

/// A ring whose elements are all bent by a swirl that leaves the boundary alone; about this many triangles.
const Mesh& ring(std::int64_t triangles) {
  static std::map<std::int64_t, Mesh> made;
  if (const auto found = made.find(triangles); found != made.end()) return found->second;
  Mesh& mesh = made[triangles];
  mesh_from_boundary(samples::annulus(2, 0.4), {2}, mesh);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = 3.9 / static_cast<double>(triangles);
  refine(mesh, options);
  mesh.compact();
  std::vector<Point> points;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    const Vector d = mesh.point(p);
    const double r = length(d), fade = std::max(0.0, (0.9 - r) * (r - 0.45)), angle = 80 * fade * fade;
    points.push_back(std::cos(angle) * d + std::sin(angle) * Vector{-d.y, d.x});
  }
  mesh.set_points(std::move(points));
  return mesh;
}

/// In random elements, and, where asked, one in ten outside: in the hole, or beyond.
std::vector<Point> random_points(const Mesh& mesh, std::size_t count, bool with_outside = false) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> real(0, 1);
  std::vector<double> rows(static_cast<std::size_t>(mesh.net_size() * mesh.width()));
  std::vector<double> row(static_cast<std::size_t>(mesh.width()));
  std::vector<Point> points;
  while (points.size() < count) {
    const double a = real(random), b = real(random) * (1 - a);
    mesh.gather(static_cast<TriangleId>(random() % static_cast<std::uint64_t>(mesh.triangle_slots())), rows);
    evaluate_net(2, mesh.width(), rows, {a, b, 1 - a - b}, row);
    points.push_back({row[0], row[1]});
    if (with_outside && points.size() % 10 == 0) {
      const double angle = 6.2831853 * real(random), r = points.size() % 20 ? 0.3 * real(random) : 1 + real(random);
      points.back() = r * Point{std::cos(angle), std::sin(angle)};
    }
  }
  return points;
}

void per_point(benchmark::State& state, std::size_t points, std::int64_t found) {
  state.counters["triangles"] = ring(state.range(0)).triangle_count();
  state.counters["found"] =
      static_cast<double>(found) / (static_cast<double>(state.iterations()) * static_cast<double>(points));
  state.counters["each"] = benchmark::Counter(static_cast<double>(points) * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// From the triangle's neighbour.
void near(benchmark::State& state) {
  const Mesh& mesh = ring(state.range(0));
  const std::vector<Point> points = random_points(mesh, 100'000);
  Locator locator(mesh);
  std::vector<TriangleId> hints;
  for (const Point& p : points) {
    const TriangleId t = locator.find(p)->triangle;
    const HalfEdgeId g = mesh.twin(half_edge(t, 1));
    hints.push_back(g == none ? t : triangle_of(g));
  }
  std::int64_t found = 0;
  for (auto _ : state)
    for (std::size_t k = 0; k < points.size(); ++k) found += locator.find(points[k], hints[k]).has_value();
  per_point(state, points.size(), found);
}

/// Points at random, one by one, without hints: the tree is made on the way.
void single(benchmark::State& state) {
  const Mesh& mesh = ring(state.range(0));
  const std::vector<Point> points = random_points(mesh, static_cast<std::size_t>(state.range(1)));
  std::int64_t found = 0;
  for (auto _ : state) {
    Locator locator(mesh);
    for (const Point& p : points) found += locator.find(p).has_value();
  }
  per_point(state, points.size(), found);
}

/// The same with the tree made before.
void single_from_tree(benchmark::State& state) {
  const Mesh& mesh = ring(state.range(0));
  const std::vector<Point> points = random_points(mesh, 100'000, state.range(1));
  Locator locator(mesh);
  locator.find({0, 0});  // outside, which the tree alone can say
  std::int64_t found = 0;
  for (auto _ : state)
    for (const Point& p : points) found += locator.find(p).has_value();
  per_point(state, points.size(), found);
}

void batch(benchmark::State& state) {
  const Mesh& mesh = ring(state.range(0));
  const std::vector<Point> points = random_points(mesh, static_cast<std::size_t>(state.range(1)), state.range(2));
  std::vector<std::optional<Location>> locations(points.size());
  std::int64_t found = 0;
  for (auto _ : state) {
    Locator locator(mesh);
    locator.find_all(points, locations);
    for (const auto& location : locations) found += location.has_value();
  }
  per_point(state, points.size(), found);
}

void make_tree(benchmark::State& state) {
  const Mesh& mesh = ring(state.range(0));
  TriangleTree tree;
  for (auto _ : state) tree.build(mesh, 0);
  per_point(state, static_cast<std::size_t>(mesh.triangle_count()), 0);
}

const std::vector<std::int64_t> sizes{10'000, 100'000, 1'000'000};
BENCHMARK(near)->ArgsProduct({sizes})->Unit(benchmark::kMillisecond);
BENCHMARK(single)->ArgsProduct({sizes, {1, 10, 1'000, 1'000'000}})->Unit(benchmark::kMillisecond);
BENCHMARK(single_from_tree)->ArgsProduct({sizes, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(batch)->ArgsProduct({sizes, {1'000, 1'000'000}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(make_tree)->ArgsProduct({sizes})->Unit(benchmark::kMillisecond);

}  // namespace
