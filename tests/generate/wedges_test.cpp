// tests/generate/wedges_test.cpp: the number of triangles between curves grows with the logarithm of the angle in which
// they meet.
#include <catch2/catch.hpp>
#include <random>

#include "generate/meshed_boundary.h"
#include "pliant/improve/refine.h"
#include "support/hard_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// Knots of a clamped quadratic spline on [0, 1], with so many random ones inside.
std::vector<double> random_knots(int inner, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.02, 0.98);
  std::vector<double> knots;
  for (int k = 0; k < inner; ++k) knots.push_back(uniform(random));
  std::sort(knots.begin(), knots.end());
  knots.insert(knots.begin(), 3, 0.0);
  knots.insert(knots.end(), 3, 1.0);
  return knots;
}

/// Cracks in a square that leave its middle, each turned by `angle` against the one before. They are pieces of the
/// parabola y = bend x² / 2 of these lengths, exactly: their control points are values of its polar form.
BoundaryComplex cracks(double angle, const std::vector<double>& lengths, double bend, int inner_knots) {
  BoundaryComplex b = with_faces({"plate"});
  b.vertices = {{0, 0}};
  std::mt19937_64 random(7);
  for (std::size_t j = 0; j < lengths.size(); ++j) {
    const std::vector<double> knots = random_knots(inner_knots, random);
    std::vector<Point> points;
    const double turn = angle * static_cast<double>(j);
    for (std::size_t i = 0; i + 3 < knots.size(); ++i) {
      const double u = lengths[j] * knots[i + 1], v = lengths[j] * knots[i + 2];
      const Point p{(u + v) / 2, bend / 2 * u * v};
      points.push_back({p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)});
    }
    Curve crack;
    crack.name = "crack " + std::to_string(j);
    crack.start = 0;
    crack.end = static_cast<int>(b.vertices.size());
    b.vertices.push_back(points.back());
    crack.left = crack.right = 0;
    crack.spline = BSpline(2, false, knots, std::move(points));
    b.curves.push_back(std::move(crack));
  }
  add_walls(b, {-3, -3}, {3, 3}, 0);
  return b;
}

/// The number of triangles of the refined mesh. Checks that nearly all that are left lie opposite a small angle, or
/// have the least size that doubles allow.
int refined_count(const BoundaryComplex& boundary, int degree) {
  Mesh mesh;
  GenerateOptions generate;
  generate.degree = degree;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, generate, mesh);
  INFO(outcome.failure);
  REQUIRE(outcome.ok);
  const PassReport report = refine(mesh, {});
  CHECK(find_invalid(mesh).empty());
  CHECK(check_mesh(mesh).empty());
  long others = 0;
  for (const auto& [reason, times] : report.refusals) {
    if (reason == "opposite a small angle" || reason == "at the least size" || reason.starts_with("flip: ")) continue;
    UNSCOPED_INFO(times << " times " << reason);
    others += times;
  }
  CHECK(others <= 4 + mesh.triangle_count() / 20);
  return mesh.triangle_count();
}

}  // namespace

TEST_CASE("between cracks the number of triangles grows with the logarithm of their angle", "[generate][wedges]") {
  const int degree = GENERATE(2, 3);
  const int inner_knots = GENERATE(0, 3, 12);
  const double bend = GENERATE(0.0, 0.5, 2.0);
  for (const std::vector<double>& lengths : {std::vector<double>{1, 1}, {1, 0.73}, {1, 0.73, 0.9, 1}}) {
    std::vector<int> counts;
    // Some hundred logical triangles of four bent cracks at 1e-6 stay turned over.
    const double step = lengths.size() == 2 ? 1e-2 : 1e-1;
    for (const double angle : {1e-2, 1e-2 * step, 1e-2 * step * step}) {
      CAPTURE(degree, inner_knots, bend, lengths.size(), lengths[1], angle);
      counts.push_back(refined_count(cracks(angle, lengths, bend, inner_knots), degree));
    }
    CAPTURE(degree, inner_knots, bend, lengths.size(), lengths[1], counts);
    // Shells around the common point halve in size, so that a hundredth of the angle takes 6.6 shells more; each has a
    // few triangles for each wedge and tip.
    const int least = 60 + 60 * inner_knots * static_cast<int>(lengths.size());
    CHECK(counts[1] <= 2 * counts[0] + 150 * static_cast<int>(lengths.size()) + least);
    CHECK(counts[2] <= 1.5 * counts[1] + 150 * static_cast<int>(lengths.size()) + least);
  }
}

TEST_CASE("outside a wedge refinement goes on: the tips of two cracks are graded", "[generate][wedges]") {
  Mesh mesh = meshed(cracks(1e-3, {1, 1}, 0, 0));
  refine(mesh, {});
  // The gap between the tips is a thousandth: from there elements grow to the size of the plate.
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    double nearest = HUGE_VAL, longest = 0;
    for (int c = 0; c < 3; ++c) {
      const Point &p = mesh.point(mesh.corner(t, c)), &q = mesh.point(mesh.corner(t, (c + 1) % 3));
      nearest = std::min(nearest, length(p));
      longest = std::max(longest, distance(p, q));
    }
    if (nearest < 1.001) continue;
    CAPTURE(t, nearest);
    CHECK(longest < 20 * (nearest - 1) + 0.02);
  }
}

TEST_CASE("a lens between two arcs is meshed in few triangles, however thin", "[generate][wedges]") {
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8}) {
    CAPTURE(height);
    BoundaryComplex b = with_faces({"lens"});
    b.vertices = {{0, 0}, {1, 0}};
    b.curves.push_back(open_curve(b, "lower", 0, 1, {{0.5, -height}}, 0));
    b.curves.push_back(open_curve(b, "upper", 1, 0, {{0.5, height}}, 0));
    CHECK(refined_count(b, 2) < 100);
  }
}

TEST_CASE("discs that touch from inside take some hundred triangles", "[generate][wedges]") {
  for (const double ratio : {0.5, 0.9, 0.99, 0.999}) {
    CAPTURE(ratio);
    BoundaryComplex b = with_faces({"outer", "inner"});
    b.vertices = {{1, 0}};
    b.cusps = {0};
    for (int disc = 0; disc < 2; ++disc) {
      const double r = disc == 0 ? 1 : ratio;
      std::vector<Point> points;
      for (int k = 0; k <= 8; ++k) {
        // A closed curve through the vertex, as an open one: tangent to x = 1 there.
        const double turn = 2 * std::numbers::pi * k / 8, reach = k % 8 == 0 ? 1 : 1 / std::cos(std::numbers::pi / 8);
        points.push_back({1 - r + r * reach * std::cos(turn), r * reach * std::sin(turn)});
      }
      points.front() = points.back() = {1, 0};
      points[1].x = points[7].x = 1;
      std::vector<double> knots{0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7};
      Curve curve;
      curve.name = "rim " + std::to_string(disc);
      curve.start = curve.end = 0;
      curve.left = disc;
      curve.right = disc == 0 ? outside : 0;
      curve.spline = BSpline(2, false, std::move(knots), std::move(points));
      b.curves.push_back(std::move(curve));
    }
    CHECK(refined_count(b, 2) < 2000);
  }
}
