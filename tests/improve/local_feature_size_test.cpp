// tests/improve/local_feature_size_test.cpp: the local feature size is half the gap between curves, or their radius.
#include "pliant/improve/coarsening/local_feature_size.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

Mesh refined(const BoundaryComplex& boundary, int degree, double share) {
  Mesh mesh = mesh_of(boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = share * area_of(mesh);
  refine(mesh, options);
  return mesh;
}

BSpline circle(const Point& center, double radius, int count, bool clockwise = false) {
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) {
    const double angle = (clockwise ? -2 : 2) * std::numbers::pi * k / count;
    points.push_back(center + radius * Vector{std::cos(angle), std::sin(angle)});
  }
  BSpline spline = samples::closed_spline(2, std::move(points));
  return spline;
}

}  // namespace

TEST_CASE("the local feature size of a circle is its radius", "[improve]") {
  BoundaryComplex boundary = samples::with_faces({"disk"});
  Curve curve;
  curve.spline = circle({3, 4}, 2, 40);
  curve.left = 0;
  boundary.curves.push_back(curve);
  const Mesh mesh = refined(boundary, 2, 1e-3);
  const double radius = distance(mesh.spline(0).evaluate(0), {3, 4});
  const auto chains = curve_chains(mesh);
  const std::vector<double> sizes = local_feature_sizes(mesh, chains);
  for (const PointId v : chains[0].vertices) CHECK(sizes[static_cast<std::size_t>(v)] == Approx(radius).epsilon(0.02));
  int inner = 0;
  for (PointId v = 0; v < mesh.point_slots(); ++v)
    if (mesh.is_vertex(v) && sizes[static_cast<std::size_t>(v)] == HUGE_VAL) ++inner;
  CHECK(inner > 100);  // only vertices on curves have one
}

TEST_CASE("between two circles it is half the gap where that is less than the radii", "[improve]") {
  BoundaryComplex boundary = samples::with_faces({"ring"});
  Curve outer, hole;
  outer.spline = circle({0, 0}, 2, 60);
  outer.left = 0;
  hole.spline = circle({0.6, 0}, 1, 60, true);  // gaps from 0.4 to 1.6
  hole.left = 0;
  boundary.curves = {outer, hole};
  const Mesh mesh = refined(boundary, 2, 1e-4);
  const auto chains = curve_chains(mesh);
  const std::vector<double> sizes = local_feature_sizes(mesh, chains);
  for (const PointId v : chains[0].vertices) {
    // r is the radius of the disk that touches the outer circle at p from inside, and the hole from outside: its
    // centre c has |c - hole's centre| = 1 + r.
    const Point p = mesh.point(v);
    const double outer_radius = length(p);
    const Vector inward = -1.0 / outer_radius * Vector{p.x, p.y};
    const Vector d = p - Point{0.6, 0};
    const double r = (dot(d, d) - 1) / (2 * (1 - dot(d, inward)));
    CHECK(sizes[static_cast<std::size_t>(v)] == Approx(std::min(r, outer_radius)).epsilon(0.03));
  }
}

TEST_CASE("sides of a rectangle that meet do not count for each other, opposite ones do", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  BoundaryComplex boundary = samples::with_faces({"slab"});
  boundary.vertices = {{0, 0}, {8, 0}, {8, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) boundary.curves.push_back(straight_curve(boundary, degree, 1, k, (k + 1) % 4, 0));
  const Mesh mesh = refined(boundary, degree, 1e-3);
  const auto chains = curve_chains(mesh);
  const std::vector<double> sizes = local_feature_sizes(mesh, chains);
  for (const std::size_t side : {0u, 2u})
    for (const PointId v : chains[side].vertices)
      CHECK(sizes[static_cast<std::size_t>(v)] == Approx(0.5).epsilon(0.05));
}
