// tests/improve/smooth_curves_test.cpp: smoothing makes nothing worse, and mends what is known to be mendable.
#include "pliant/improve/smooth_curves.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"
#include "pliant/quality/element/element_quality.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

bool is_free(const Mesh& mesh, HalfEdgeId h) { return mesh.twin(h) != none && !mesh.is_constrained(h); }

/// Moves the inner control points of edges and elements at random, by at most this share of the edge (or of the
/// element's longest edge).
void displace(MeshData& data, double share, std::uint64_t seed) {
  const Mesh mesh(data);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto push = [&](PointId p, double length) {
    Vector v{uniform(random), uniform(random)};
    data.points[static_cast<std::size_t>(p)] += share * length * v;
  };
  for (const HalfEdgeId h : mesh.half_edges()) {
    const double far = distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)));
    if (is_free(mesh, h) && h < mesh.twin(h))
      for (int k = 1; k < mesh.degree(); ++k) push(mesh.edge_point(h, k), far);
    if (edge_of(h) == 0)
      for (int k = mesh.layout().first_interior(); k < mesh.net_size(); ++k)
        push(mesh.net(triangle_of(h))[static_cast<std::size_t>(k)], far);
  }
}

/// A mesh of about this many elements or more, with good angles.
Mesh refined(const Sample& sample, int degree, int elements) {
  Mesh mesh = mesh_of(sample.boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / elements;
  refine(mesh, options);
  return mesh;
}

/// The least tau of the curved elements at sample points.
double worst_shape(const Mesh& mesh) {
  double worst = 1;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  const int n = 24;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n - i; ++j)
        worst = std::min(worst, shape_at(mesh.degree(), net, {double(i) / n, double(j) / n, double(n - i - j) / n}));
  }
  return worst;
}

}  // namespace

TEST_CASE("smoothing leaves the worst element at most 1.5 percent worse, and a valid mesh valid",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, seed, sample.name);
    MeshData data = mesh_of(sample.boundary, degree).to_data();
    displace(data, 0.08, seed);
    Mesh mesh(data);
    if (!find_invalid(mesh).empty()) continue;
    const double before = worst_shape(mesh), area = area_of(mesh);
    const SmoothOutcome outcome = smooth_curves(mesh);
    CHECK(outcome.invalid.empty());
    check_left(mesh);
    CHECK(worst_shape(mesh) >= 0.985 * before - 1e-6);
    CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
    CHECK(mesh.triangle_count() == static_cast<int>(data.triangle_faces.size()));
    double moved = 0;
    for (PointId p = 0; p < mesh.point_slots(); ++p)
      if (mesh.is_vertex(p)) moved = std::max(moved, distance(mesh.point(p), data.points[static_cast<std::size_t>(p)]));
    CHECK(moved == 0);
  }
}

TEST_CASE("what is not too curved is left as it is", "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh = scattered(degree, 40, 8);
  const std::string text = text_of(mesh);
  CHECK(value_of(smooth_curves(mesh).report, "edges_smoothed") == 0);
  const bool is_same = text_of(mesh) == text;
  CHECK(is_same);
}

TEST_CASE("smoothing mends at least 85 percent of the elements that bent edges between straight triangles spoil",
          "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  const auto seed = GENERATE(range<std::uint64_t>(0, 4));
  CAPTURE(degree, seed);
  Mesh straight = grid(degree, 6, seed);
  MeshData data = straight.to_data();
  displace(data, degree == 2 ? 0.25 : 0.1, seed);
  Mesh mesh(std::move(data));
  const SmoothOutcome outcome = smooth_curves(mesh);
  const double before = value_of(outcome.report, "too_curved");
  CHECK(before > 0);
  CHECK(value_of(outcome.report, "still_curved") <= 0.15 * before);
  CHECK(outcome.invalid.empty());
  check_left(mesh);
}

TEST_CASE("elements that one displaced edge tangles, with all around in place, are always untangled",
          "[improve][property]") {
  // The edge has a valid place, the old one, and optimal placement finds one.
  const int degree = GENERATE(2, 3);
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, seed, sample.name);
    const Mesh first = refined(sample, degree, 80);
    MeshData data = first.to_data();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-2, 2);
    std::vector<char> touched(data.triangle_faces.size(), 0);
    for (const HalfEdgeId h : first.half_edges()) {
      const TriangleId t = triangle_of(h);
      if (!is_free(first, h) || random() % 3) continue;
      const TriangleId u = triangle_of(first.twin(h));
      bool free = true;
      for (const TriangleId near : {t, u})
        for (int e = 0; e < 3; ++e) {
          const HalfEdgeId g = first.twin(half_edge(near, e));
          free = free && !touched[static_cast<std::size_t>(near)] &&
                 (g == none || !touched[static_cast<std::size_t>(triangle_of(g))]);
        }
      if (!free) continue;
      touched[static_cast<std::size_t>(t)] = touched[static_cast<std::size_t>(u)] = 1;
      const double far = distance(first.point(first.origin(h)), first.point(first.target(h)));
      data.points[static_cast<std::size_t>(first.edge_point(h, 1 + static_cast<int>(random() % 2) % (degree - 1)))] +=
          far * Vector{uniform(random), uniform(random)};
    }
    Mesh mesh(std::move(data));
    const std::size_t tangled = find_invalid(mesh).invalid.size();
    REQUIRE(tangled > 3);
    const SmoothOutcome outcome = smooth_curves(mesh);
    CHECK(outcome.invalid.empty());
    check_left(mesh);
  }
}

TEST_CASE("where displacing every inner control point tangles elements, at most 5 percent are left, and they are named",
          "[improve][property]") {
  const int degree = GENERATE(2, 3);
  std::size_t tangled = 0, left = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (const Sample& sample : boundaries(degree)) {
      CAPTURE(degree, seed, sample.name);
      MeshData data = refined(sample, degree, 60).to_data();
      displace(data, degree == 2 ? 0.3 : 0.2, seed);
      Mesh mesh(std::move(data));
      const std::size_t before = find_invalid(mesh).invalid.size();
      const SmoothOutcome outcome = smooth_curves(mesh);
      const InvalidElements after = find_invalid(mesh);
      CHECK(outcome.invalid.size() == after.invalid.size() + after.degenerate.size());
      CHECK(value_of(outcome.report, "invalid") == static_cast<double>(outcome.invalid.size()));
      CHECK(after.invalid.size() <= before);
      for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
      tangled += before;
      left += outcome.invalid.size();
    }
  CAPTURE(tangled, left);
  REQUIRE(tangled > 100);
  CHECK(left * 20 <= tangled);
}

TEST_CASE("with the option to split, knots alone mend elements that a curve bends too much", "[improve]") {
  const int degree = GENERATE(2, 3);  // no higher: a closed curve of 3 spans has 3 control points
  Mesh mesh(samples::disk(degree, 3));
  const BSpline was = mesh.spline(0);
  SmoothOptions options;  // allow a span to turn by 90 degrees; each of these turns by 120
  Mesh without = mesh;
  const SmoothOutcome listed = smooth_curves(without, options);
  CHECK(listed.unmended.size() == 3);
  for (const UnmendedElement& left : listed.unmended) CHECK(left.reason == Unmended::needs_split);
  options.split = true;
  const SmoothOutcome outcome = smooth_curves(mesh, options);
  CHECK(value_of(outcome.report, "splits") == 3);
  CHECK(mesh.spline(0).span_count() == 6);
  CHECK(outcome.unmended.empty());
  double off = 0;
  for (int k = 0; k <= 100; ++k) {
    const double t = was.first_parameter() + was.period() * k / 100;
    off = std::max(off, distance(was.evaluate(t), mesh.spline(0).evaluate(t)));
  }
  CHECK(off < 1e-14);
  check_left(mesh);
}

TEST_CASE("splits that would lower the least shape are not made, and the reason says so", "[improve]") {
  const int degree = GENERATE(2, 3, 4);
  Mesh mesh(samples::disk(degree, 8));  // sectors of 45 degrees: halves are thinner
  SmoothOptions options;
  options.bounds.max_turning = 0.3;
  options.split = true;
  const SmoothOutcome outcome = smooth_curves(mesh, options);
  CHECK(value_of(outcome.report, "splits") == 0);
  CHECK(outcome.unmended.size() == 8);
  for (const UnmendedElement& left : outcome.unmended) CHECK(left.reason == Unmended::needs_refinement);
}
