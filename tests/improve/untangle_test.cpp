// tests/improve/untangle_test.cpp: meshes that a vortex has tangled, smoothed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "improve/improve_meshes.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/smooth_curves.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// Turns every point of the square [0, n]² about its middle by up to `angle`, those on the boundary not at all.
void stir(MeshData& data, int n, double angle) {
  const Point middle{0.5 * n, 0.5 * n};
  for (Point& p : data.points) {
    const Vector r = p - middle;
    const double share = std::max(0.0, 1 - 4.2 * squared_length(r) / (double(n) * n)), a = angle * share * share;
    p = middle + Vector{std::cos(a) * r.x - std::sin(a) * r.y, std::sin(a) * r.x + std::cos(a) * r.y};
  }
}

Mesh stirred(int degree, int n, double angle) {
  MeshData data = grid(degree, n, 1).to_data();
  stir(data, n, angle);
  return Mesh(std::move(data));
}

int count_turned_over(const Mesh& mesh) {
  int count = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    count += orient2d(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2))) <= 0;
  return count;
}

std::vector<double> sorted_excesses(const Mesh& mesh) {
  const CurvatureTest test(mesh.degree(), {});
  std::vector<double> all;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    all.push_back(test.excess(net));
  }
  std::sort(all.begin(), all.end(), std::greater<>());
  return all;
}

void check_boundary_kept(const Mesh& mesh, const Mesh& was) {
  REQUIRE(mesh.boundary().curves.size() == was.boundary().curves.size());
  for (CurveId c = 0; c < static_cast<CurveId>(was.boundary().curves.size()); ++c)
    CHECK(mesh.spline(c).points() == was.spline(c).points());
  std::vector<Point> kept, before;
  const auto points_on_curves = [](const Mesh& m, std::vector<Point>& points) {
    for (const HalfEdgeId h : m.half_edges())
      for (int k = 0; m.is_constrained(h) && k <= m.degree(); ++k) points.push_back(m.point(m.edge_point(h, k)));
    std::sort(points.begin(), points.end(),
              [](const Point& p, const Point& q) { return std::pair(p.x, p.y) < std::pair(q.x, q.y); });
  };
  points_on_curves(mesh, kept);
  points_on_curves(was, before);
  CHECK(kept == before);
}

}  // namespace

TEST_CASE("what a vortex has tangled becomes valid where vertices may move; without, what stays invalid is named",
          "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const double angle = 3.3;
  const int allowed = GENERATE(0, 1, 2, 3);  // vertices, flips
  const int side = degree == 1 ? 12 : degree == 2 ? 10 : 6;
  Mesh mesh = stirred(degree, side, angle);
  const Mesh was = mesh;
  const std::size_t tangled = find_invalid(mesh).invalid.size();
  CAPTURE(degree, angle, allowed, tangled, count_turned_over(mesh));
  SmoothOptions options;
  options.vertices = allowed & 1;
  options.flips = allowed & 2;
  const SmoothOutcome outcome = smooth_curves(mesh, options);
  const InvalidElements left = find_invalid(mesh);
  std::vector<TriangleId> all = left.invalid;
  all.insert(all.end(), left.degenerate.begin(), left.degenerate.end());
  std::sort(all.begin(), all.end());
  CHECK(outcome.invalid == all);
  if (options.vertices) CHECK(all.empty());
  const int turned_over = count_turned_over(was);
  REQUIRE(turned_over > 0);
  CHECK(count_turned_over(mesh) <= turned_over - (options.vertices ? 1 : 0));
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
  check_boundary_kept(mesh, was);
  CHECK(area_of(mesh) == Approx(double(side) * side).epsilon(1e-12));
  for (const TriangleId t : outcome.invalid)
    CHECK(std::any_of(outcome.unmended.begin(), outcome.unmended.end(), [t](const auto& e) { return e.element == t; }));
}

TEST_CASE("no sweep makes the worst element worse, or more elements tangled", "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  const bool vertices = GENERATE(false, true);
  Mesh mesh = stirred(degree, degree < 3 ? 8 : 6, 4.2);
  SmoothOptions options;
  options.vertices = options.flips = vertices;
  options.max_sweeps = 1;
  std::vector<double> before = sorted_excesses(mesh);
  REQUIRE(before.front() > tangled_excess);
  for (int sweep = 0; sweep < 5; ++sweep) {
    const SmoothOutcome outcome = smooth_curves(mesh, options);
    const std::vector<double> now = sorted_excesses(mesh);
    CAPTURE(degree, vertices, sweep);
    CHECK(now.front() <=
          std::max(1.0, before.front()));  // a good element may become worse, as long as it stays within the bounds
    const auto count_tangled = [](const std::vector<double>& all) {
      return std::count_if(all.begin(), all.end(), [](double e) { return e >= tangled_excess; });
    };
    CHECK(count_tangled(now) <= count_tangled(before));
    before = now;
    if (value_of(outcome.report, "edges_smoothed") == 0) break;
  }
}

TEST_CASE("smoothing carries fields: linear functions stay themselves, integrals stay, on tangled elements too",
          "[improve]") {
  const int degree = GENERATE(2, 3);
  const bool vertices = GENERATE(false, true);
  const double angle = GENERATE(2.1, 3.3);
  Mesh mesh = stirred(degree, angle < 3 ? 10 : 6, angle);
  REQUIRE(find_invalid(mesh).empty() == (angle < 3));
  // Field 0 becomes the linear function of the places to which the vortex has moved the points.
  MeshData data = mesh.to_data();
  for (std::size_t p = 0; p < data.points.size(); ++p)
    data.fields[0].values[p] = data.points[p].x + 2 * data.points[p].y - 3;
  mesh = Mesh(std::move(data));
  const auto integral = [](const Mesh& m, int field, int component) {
    const std::size_t n = static_cast<std::size_t>(m.net_size());
    std::vector<Point> net(n);
    std::vector<double> weights(n);
    double sum = 0;
    const int parts = m.fields()[static_cast<std::size_t>(field)].components;
    for (TriangleId t = 0; t < m.triangle_slots(); ++t) {
      m.gather_points(t, net);
      integral_weights(m.degree(), net, weights);
      for (std::size_t k = 0; k < n; ++k)
        sum += weights[k] * m.fields()[static_cast<std::size_t>(field)]
                                .values[static_cast<std::size_t>(m.net(t)[k] * parts + component)];
    }
    return sum;
  };
  const double noise_before[2] = {integral(mesh, 1, 0), integral(mesh, 1, 1)};
  SmoothOptions options;
  options.vertices = vertices;
  options.bounds.min_shape_ratio = 0.8;  // much to do
  const SmoothOutcome outcome = smooth_curves(mesh, options);
  REQUIRE(value_of(outcome.report, "edges_smoothed") > 20);
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    const Point& q = mesh.point(p);
    REQUIRE(mesh.fields()[0].values[static_cast<std::size_t>(p)] == Approx(q.x + 2 * q.y - 3).margin(1e-10));
  }
  for (int component = 0; component < 2; ++component)
    CHECK(integral(mesh, 1, component) == Approx(noise_before[component]).margin(1e-9));
}

TEST_CASE("the control mesh's measure is an option, and leaves valid what was valid", "[improve]") {
  const int degree = GENERATE(2, 3);
  Mesh mesh = stirred(degree, 10, 2.1);
  REQUIRE(find_invalid(mesh).empty());
  SmoothOptions options;
  options.measure = PlacementMeasure::control_mesh;
  const double before = sorted_excesses(mesh).front();
  smooth_curves(mesh, options);
  check_left(mesh);
  CHECK(sorted_excesses(mesh).front() <= std::max(1.0, before));
}

TEST_CASE("the reason why an element stays invalid is told, with the options that would help if there are any",
          "[improve]") {
  Mesh mesh = stirred(1, 8, 4);
  REQUIRE(count_turned_over(mesh) > 0);
  const SmoothOutcome outcome = smooth_curves(mesh);
  REQUIRE(outcome.unmended.size() == outcome.invalid.size());
  for (const UnmendedElement& left : outcome.unmended) CHECK(left.reason == Unmended::turned_over);
  CHECK(describe(Unmended::turned_over, {}).find("--vertices or --flips") != std::string::npos);
  const SmoothMeans all{true, true, true};
  for (const Unmended reason : {Unmended::smooth_corner, Unmended::needs_split, Unmended::needs_refinement,
                                Unmended::turned_over, Unmended::no_better_place})
    CHECK(describe(reason, all).find("--") == std::string::npos);
}
