// tests/improve/smooth_globally_test.cpp: the deformation energy, and meshes that minimising it untangles as a whole.
#include "pliant/improve/global/smooth_globally.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "improve/improve_meshes.h"
#include "pliant/geometry/index.h"
#include "pliant/improve/global/deformation_energy.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/star.h"
#include "pliant/quality/element/element_quality.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

Mesh refined_sample(const Sample& sample, int degree, int elements) {
  Mesh mesh = mesh_of(sample.boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / elements;
  refine(mesh, options);
  return mesh;
}

/// Which points lie on curves.
std::vector<char> on_curves(const Mesh& mesh) {
  std::vector<char> on(index(mesh.point_slots()), 0);
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_constrained(h))
      for (int k = 0; k <= mesh.degree(); ++k) on[index(mesh.edge_point(h, k))] = 1;
  return on;
}

/// Moves the points that are neither vertices nor on curves by a swirl. Its strength is relative to the size of
/// elements.
MeshData swirled(const Mesh& mesh, double strength) {
  MeshData data = mesh.to_data();
  const std::vector<char> fixed = on_curves(mesh);
  const double step = std::sqrt(area_of(mesh) / mesh.triangle_count()), wave = 1.3 / step;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    if (fixed[index(p)] || mesh.is_vertex(p)) continue;
    Point& x = data.points[index(p)];
    x += strength * step *
         Vector{-std::cos(wave * x.x) * std::sin(wave * x.y), std::sin(wave * x.x) * std::cos(wave * x.y)};
  }
  return data;
}

struct Scaled {
  double least = 1, mean = 0;
};
Scaled scaled_jacobians(const Mesh& mesh) {
  Scaled all;
  std::vector<Point> net(index(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    const double value = scaled_jacobian(mesh.degree(), net);
    all.least = std::min(all.least, value);
    all.mean += value / mesh.triangle_count();
  }
  return all;
}

/// How many points of curves are not where they were.
long moved_on_curves(const Mesh& before, const Mesh& after) {
  long moved = 0;
  const std::vector<char> fixed = on_curves(before);
  for (PointId p = 0; p < before.point_slots(); ++p) moved += fixed[index(p)] && !(before.point(p) == after.point(p));
  return moved;
}

double half_square_sum(const std::vector<double>& r) {
  double sum = 0;
  for (const double x : r) sum += x * x / 2;
  return sum;
}

}  // namespace

TEST_CASE("the deformation energy is 0 for turned copies of the wanted triangle and has the derivatives it says",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const auto nodes = GENERATE(DeformationEnergy::Nodes::few, DeformationEnergy::Nodes::many);
  const double smoothing = GENERATE(0.0, 0.1);
  const bool any_area = GENERATE(false, true);
  CAPTURE(degree, int(nodes), smoothing, any_area);
  const DeformationEnergy& energy = DeformationEnergy::of(degree, nodes);
  const NetLayout& layout = NetLayout::of(degree);
  const Vector u{2, 0.3}, v{0.2, 1.5};
  DeformationEnergy::Target target{WantedShape::of(u, v), any_area, 0, smoothing};
  const double size = any_area ? 3 : 1;
  std::vector<Point> net;
  std::vector<std::int8_t> moving;
  for (int k = 0; k < net_size(degree); ++k) {
    const auto& e = layout.exponents(k);
    const Vector d = e[1] / double(degree) * u + e[2] / double(degree) * v;
    net.push_back(Point{5, 7} + size * Vector{0.6 * d.x - 0.8 * d.y, 0.8 * d.x + 0.6 * d.y});
    if (k != 1) moving.push_back(static_cast<std::int8_t>(k));
  }
  std::vector<double> r(index(energy.residual_count())), jacobian(r.size() * 2 * moving.size());
  REQUIRE(energy.evaluate(net, target, r, moving, nullptr));
  if (smoothing == 0) CHECK(half_square_sum(r) < 1e-28);

  std::mt19937_64 random(static_cast<std::uint64_t>(degree));
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  for (Point& p : net) p += Vector{size * uniform(random) / degree, size * uniform(random) / degree};
  REQUIRE(energy.evaluate(net, target, r, moving, jacobian.data()));
  CHECK(half_square_sum(r) > 1e-4);
  const double step = 1e-6;
  std::vector<double> above(r.size()), below(r.size());
  double worst = 0;
  for (std::size_t m = 0; m < moving.size(); ++m)
    for (int c = 0; c < 2; ++c) {
      Point& p = net[index(moving[m])];
      double& x = c ? p.y : p.x;
      const double old = x;
      x = old + step;
      REQUIRE(energy.evaluate(net, target, above, moving, nullptr));
      x = old - step;
      REQUIRE(energy.evaluate(net, target, below, moving, nullptr));
      x = old;
      for (std::size_t k = 0; k < r.size(); ++k)
        worst = std::max(
            worst, std::abs((above[k] - below[k]) / (2 * step) - jacobian[(k * moving.size() + m) * 2 + index(c)]));
    }
  CHECK(worst < 1e-7);
}

TEST_CASE("without smoothing the energy of a tangled element is infinite, with it finite", "[improve]") {
  const DeformationEnergy& energy = DeformationEnergy::of(2, DeformationEnergy::Nodes::few);
  const std::vector<Point> net{{0, 0}, {2, 0}, {0, 2}, {-1, 0}, {1, 1}, {0, 1}};
  std::vector<double> r(index(energy.residual_count()));
  DeformationEnergy::Target target;
  CHECK_FALSE(energy.evaluate(net, target, r, {}, nullptr));
  target.smoothing = 0.1;
  CHECK(energy.evaluate(net, target, r, {}, nullptr));
  const double far = half_square_sum(r);
  target.smoothing = 0.05;
  CHECK(energy.evaluate(net, target, r, {}, nullptr));
  CHECK(half_square_sum(r) > far);
}

TEST_CASE("a swirled mesh becomes valid and better, and its curves and vertices stay bit for bit",
          "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  for (const Sample& sample : boundaries(degree)) {
    for (const double strength : {0.2, 0.6}) {
      CAPTURE(degree, sample.name, strength);
      const Mesh first = refined_sample(sample, degree, degree == 2 ? 300 : 100);
      Mesh mesh(swirled(first, strength));
      const Mesh tangled = mesh;
      const std::size_t invalid = find_invalid(mesh).invalid.size();
      if (strength > 0.5) CHECK(invalid > 0);
      const Scaled before = scaled_jacobians(mesh);
      const double area = area_of(mesh);
      const GlobalSmoothOutcome outcome = smooth_globally(mesh);
      CHECK(outcome.invalid.empty());
      CHECK(value_of(outcome.report, "invalid") == 0);
      if (invalid == 0) CHECK(value_of(outcome.report, "energy_after") <= value_of(outcome.report, "energy_before"));
      check_left(mesh);
      const Scaled after = scaled_jacobians(mesh);
      CHECK(after.least > before.least);
      CHECK(after.mean > before.mean);
      CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
      CHECK(moved_on_curves(tangled, mesh) == 0);
      long vertices_moved = 0;
      for (PointId p = 0; p < mesh.point_slots(); ++p)
        vertices_moved += mesh.is_vertex(p) && !(mesh.point(p) == tangled.point(p));
      CHECK(vertices_moved == 0);
    }
  }
}

TEST_CASE("edges between straight triangles become straight by the energy alone", "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  Mesh mesh(swirled(grid(degree, 8, 3), 0.4));
  CHECK(scaled_jacobians(mesh).least < 0.5);
  smooth_globally(mesh);
  CHECK(scaled_jacobians(mesh).least > 0.99);
}

TEST_CASE("a mesh in which every element is good is left bit for bit", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh = scattered(degree, 40, 8);
  const std::string text = text_of(mesh);
  GlobalSmoothOptions options;
  options.vertices = GENERATE(false, true);
  const GlobalSmoothOutcome outcome = smooth_globally(mesh, options);
  CHECK(value_of(outcome.report, "points_moved") == 0);
  const bool is_same = text_of(mesh) == text;
  CHECK(is_same);
}

TEST_CASE("elements beyond the rings around poor ones are left as they are", "[improve]") {
  const Mesh straight = grid(2, 16, 1);
  MeshData data = straight.to_data();
  HalfEdgeId bent = none;  // an inner edge near the lower left corner
  for (const HalfEdgeId h : straight.half_edges())
    if (bent == none && straight.twin(h) != none && straight.point(straight.origin(h)).x <= 2) bent = h;
  const PointId moved = straight.edge_point(bent, 1);
  data.points[index(moved)] += Vector{0.2, 0.15};
  Mesh mesh(data);
  GlobalSmoothOptions options;
  options.rings = 1;
  const GlobalSmoothOutcome outcome = smooth_globally(mesh, options);
  CHECK(value_of(outcome.report, "not_good") == 2);
  CHECK(value_of(outcome.report, "elements_smoothed") < 40);
  CHECK(distance(mesh.point(moved), straight.point(moved)) < 1e-2);
  for (PointId p = 0; p < straight.point_slots(); ++p)
    if (distance(straight.point(p), straight.point(moved)) > 4) CHECK(mesh.point(p) == straight.point(p));
}

TEST_CASE("inverted straight triangles are mended where vertices may move, and the boundary is kept",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3);
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(degree, seed);
  const Mesh first = grid(degree, 10, seed);
  MeshData data = first.to_data();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<char> fixed = on_curves(first);
  for (PointId p = 0; p < first.point_slots(); ++p)
    if (first.is_vertex(p) && !fixed[index(p)] && random() % 4 == 0) {
      const Vector d{uniform(random), uniform(random)};
      data.points[index(p)] += (1.2 / length(d)) * d;
    }
  Mesh mesh(data);
  const Mesh tangled = mesh;
  CHECK(find_invalid(mesh).invalid.size() > 10);
  GlobalSmoothOptions options;
  options.vertices = true;
  const GlobalSmoothOutcome outcome = smooth_globally(mesh, options);
  CHECK(outcome.invalid.empty());
  check_left(mesh);
  CHECK(moved_on_curves(tangled, mesh) == 0);
}

TEST_CASE("what cannot be untangled is named, and nothing else becomes invalid", "[improve]") {
  const Mesh first = grid(1, 8, 2);  // at degree 1 there are only vertices, which stay without the option to move them
  MeshData data = first.to_data();
  const std::vector<char> fixed = on_curves(first);
  for (PointId p = 0; p < first.point_slots(); ++p)
    if (!fixed[index(p)] && p % 7 == 0) data.points[index(p)] += Vector{1.3, 0.2};
  Mesh mesh(data);
  const std::vector<TriangleId> invalid = find_invalid(mesh).invalid;
  REQUIRE_FALSE(invalid.empty());
  CHECK(smooth_globally(mesh).invalid == invalid);
}

TEST_CASE("fields that are linear stay so, and integrals of others are kept", "[improve][property]") {
  const int degree = GENERATE(2, 3);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    const Mesh first = refined_sample(sample, degree, 100);
    MeshData data = swirled(first, 0.1);
    data.fields.clear();
    add_fields(data);
    Mesh mesh(data);
    if (!find_invalid(mesh).empty()) continue;
    GlobalSmoothOptions options;
    options.refit.projection = Projection::conservative;
    const double before = integral_of(mesh, 1, 0);
    smooth_globally(mesh, options);
    check_left(mesh);
    CHECK(linear_error(mesh) < 1e-11);
    CHECK(integral_of(mesh, 1, 0) == Approx(before).margin(1e-11 * area_of(mesh)).epsilon(1e-11));
  }
  SECTION("on a tangled mesh as well") {
    MeshData data = swirled(grid(degree, 8, 5), 1.2);
    data.fields.clear();
    add_fields(data);
    Mesh mesh(data);
    REQUIRE_FALSE(find_invalid(mesh).empty());
    CHECK(smooth_globally(mesh).invalid.empty());
    CHECK(linear_error(mesh) < 1e-10);
  }
}

TEST_CASE("the result does not depend on unit, place and direction, but for rounding", "[improve][property]") {
  const int degree = GENERATE(2, 3);
  // Untangling magnifies rounding: then results may differ by 1e-4 of the mesh's size, 1e-3 of an element's.
  const double strength = GENERATE(0.2, 0.6);
  MeshData data = swirled(refined_sample({"annulus", samples::annulus(degree)}, degree, 150), strength);
  data.fields.clear();
  const double unit = GENERATE(17.0, 1e7, 1e-7);
  CAPTURE(degree, unit, strength);
  const auto change = [unit](const Point& p) {
    return unit * (Point{4, -3} + Vector{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y});
  };
  MeshData other = data;
  for (Point& p : other.points) p = change(p);
  for (Point& p : other.boundary.vertices) p = change(p);
  for (Curve& curve : other.boundary.curves) {
    std::vector<Point> points = curve.spline.points();
    for (Point& p : points) p = change(p);
    curve.spline = BSpline(curve.spline.degree(), curve.spline.closed(), curve.spline.knots(), std::move(points));
  }
  Mesh a(data), b(other);
  CHECK(smooth_globally(a).invalid.empty());
  CHECK(smooth_globally(b).invalid.empty());
  double worst = 0;
  for (PointId p = 0; p < a.point_slots(); ++p) worst = std::max(worst, distance(change(a.point(p)), b.point(p)));
  CHECK(worst < (strength < 0.5 ? 1e-7 : 1e-4) * b.size());
}

TEST_CASE("progress is counted and steps are reported", "[improve]") {
  Mesh mesh(swirled(grid(2, 8, 3), 0.4));
  Progress progress;
  GlobalSmoothOptions options;
  options.progress = &progress;
  const GlobalSmoothOutcome outcome = smooth_globally(mesh, options);
  CHECK(progress.done > 0);
  CHECK(value_of(outcome.report, "iterations") == static_cast<double>(progress.done));
  CHECK(value_of(outcome.report, "triangles") == mesh.triangle_count());
}
