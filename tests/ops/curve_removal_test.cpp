// tests/ops/curve_removal_test.cpp: removing a vertex from a curve: distances, integrals, vertices that stay.
#include <algorithm>

#include "ops/carried_domains.h"

using namespace pliant;

namespace {

/// The greatest distance between the points of two curves at the same parameter, over many parameters.
double sampled_distance(const BSpline& a, const BSpline& b) {
  double worst = 0;
  const auto evaluate = [](const BSpline& curve, double t) {
    // A closed curve that lost its first break starts at a later one.
    if (curve.closed())
      while (t < curve.first_parameter()) t += curve.period();
    return curve.evaluate(std::min(t, curve.last_parameter()));
  };
  for (int k = 0; k < 600; ++k) {
    const double t = a.first_parameter() + a.period() * k / 600;
    worst = std::max(worst, distance(a.evaluate(t), evaluate(b, t)));
  }
  return worst;
}

/// The vertices inside curves, in random order.
std::vector<PointId> curve_vertices(const Mesh& mesh, std::mt19937_64& random) {
  std::vector<PointId> vertices;
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_alive(triangle_of(h)) && mesh.is_constrained(h))
      vertices.push_back(mesh.constraint_first(mesh.constraint(h)));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::shuffle(vertices.begin(), vertices.end(), random);
  return vertices;
}

CurveId curve_at(const Mesh& mesh, PointId v) {
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_alive(triangle_of(h)) && mesh.is_constrained(h) && mesh.constraint_first(mesh.constraint(h)) == v)
      return mesh.constraint_curve(mesh.constraint(h));
  return none;
}

/// A domain with every constrained edge split twice, so that its curves have knots that can be removed.
Mesh with_many_knots(const Domain& domain, int degree) {
  Mesh mesh = carried(domain, degree);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0.3, 0.7);
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_constrained(h) && (mesh.twin(h) == none || mesh.twin(h) > h))
      REQUIRE(split_edge(mesh, h, uniform(random)).outcome == Outcome::done);
  return mesh;
}

}  // namespace

TEST_CASE(
    "the distance that a knot removal reports bounds the distance of the curves, and so does the sum after many "
    "removals",
    "[ops][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  const bool keep_area = GENERATE(false, true);
  CAPTURE(degree, domain.name, keep_area);
  Mesh mesh = with_many_knots(domain, degree);
  const std::vector<Curve> first = mesh.boundary().curves;
  std::mt19937_64 random(8);
  int done = 0;
  double tightest = 0;
  for (int round = 0; round < 2; ++round)
    for (const PointId v : curve_vertices(mesh, random)) {
      const CurveId curve = curve_at(mesh, v);
      if (curve == none) continue;
      const BSpline old = mesh.spline(curve);
      const double error_before = mesh.boundary().curves[static_cast<std::size_t>(curve)].removal_error;
      const CurveRemoval removal = remove_curve_vertex(mesh, v, {0.2, 0.1, keep_area});
      const Curve& now = mesh.boundary().curves[static_cast<std::size_t>(curve)];
      if (removal.outcome != Outcome::done) {
        CHECK(now.removal_error == error_before);
        continue;
      }
      ++done;
      CHECK(now.removal_error == error_before + removal.error);
      CHECK(now.removal_error <= 0.2);
      const double sampled = sampled_distance(old, now.spline);
      CHECK(sampled <= removal.error * (1 + 1e-12) + 1e-14 * mesh.size());
      if (removal.error > 1e-3) tightest = std::max(tightest, sampled / removal.error);
    }
  require_every_invariant(mesh);
  CHECK(done > 5);
  if (tightest > 0) CHECK(tightest > 0.05);  // the bound is not far too large either
  for (std::size_t c = 0; c < first.size(); ++c)
    CHECK(sampled_distance(first[c].spline, mesh.boundary().curves[c].spline) <=
          mesh.boundary().curves[c].removal_error * (1 + 1e-12) + 1e-13 * mesh.size());
  if (keep_area)
    for (std::size_t c = 0; c < first.size(); ++c)
      CHECK(mesh.boundary().curves[c].spline.area() == Approx(first[c].spline.area()).margin(1e-11));
}

// This took a quarter of an hour when each removal looked at the whole curve.
TEST_CASE("the cost of a removal does not grow with the curve, with or without keeping the area", "[ops]") {
  BoundaryComplex boundary;
  boundary.faces.resize(1);
  boundary.faces[0].name = "cell";
  Curve& curve = boundary.curves.emplace_back();
  curve.spline = samples::polar_spline(2, 20000, {0, 0}, [](double angle) { return 1 + 0.2 * std::cos(3 * angle); });
  curve.left = 0;
  curve.right = outside;
  Mesh mesh;
  REQUIRE(mesh_from_boundary(boundary, {2}, mesh).ok);
  const double area = mesh.spline(0).area();
  long done = 0;
  Star star;
  const PointId slots = mesh.point_slots();
  for (PointId v = 0; v < slots; v += 3) {
    if (!mesh.is_vertex(v)) continue;
    find_star(mesh, v, star);
    if (star.is_closed || star.outgoing.size() > 6) continue;
    done += remove_curve_vertex(mesh, v, {1e-3, 1e-4, true}).outcome == Outcome::done;
  }
  CHECK(done > 1000);
  CHECK(mesh.spline(0).area() == Approx(area).margin(1e-11));
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place + " " + fault.text);
}

TEST_CASE("if a removal changes the region, linear functions are reproduced, or integrals conserved, as asked",
          "[ops][property]") {
  const int degree = GENERATE(1, 2, 3);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  const RegionChange change = GENERATE(RegionChange::reproduce, RegionChange::conserve);
  CAPTURE(degree, domain.name, static_cast<int>(change));
  Mesh mesh = with_many_knots(domain, degree);
  const std::size_t faces = mesh.boundary().faces.size();
  std::mt19937_64 random(8);
  RefitOptions options;
  options.region_change = change;
  int changed = 0;
  for (const PointId v : curve_vertices(mesh, random)) {
    const std::vector<double> before = kept_sums(mesh);
    const CurveRemoval removal = remove_curve_vertex(mesh, v, {0.3, 0.1}, options);
    if (removal.outcome != Outcome::done) continue;
    const std::vector<double> after = kept_sums(mesh);
    double area = 0, integral = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
      (i < faces ? area : integral) = std::max(i < faces ? area : integral, std::abs(after[i] - before[i]));
    if (area > 1e-9) ++changed;
    if (change == RegionChange::conserve) {
      CHECK(integral < 1e-13 * box_area(mesh));
      CHECK(removal.integral_change == 0);
    } else {
      CHECK(linear_error(mesh) < 1e-11);
      // The integral of absolute control values over the footprint is at most their bound times the area of the box.
      CHECK(integral <= removal.integral_change * 2 * box_area(mesh) + 1e-13);
      if (integral > 1e-6) CHECK(removal.integral_change > 1e-7);
    }
  }
  require_every_invariant(mesh);
  if (degree > 1) CHECK(changed > 2);
}

TEST_CASE("a closed curve keeps three spans, and vertices where three curves meet stay", "[ops]") {
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(degree);
  std::mt19937_64 random(4);
  Mesh cell(carried_disk(degree));
  for (int round = 0; round < 4; ++round)
    for (const PointId v : curve_vertices(cell, random)) {
      remove_curve_vertex(cell, v, {HUGE_VAL});
      REQUIRE(cell.spline(0).span_count() >= 3);
    }
  require_every_invariant(cell);
  CHECK(cell.spline(0).span_count() < 8);

  if (degree != 2) return;
  Mesh divided;
  REQUIRE(mesh_from_boundary(samples::divided_square(), {2}, divided).ok);
  for (PointId v = 0; v < divided.point_slots(); ++v) {
    if (!divided.is_vertex(v)) continue;
    const auto& corners = divided.boundary().vertices;
    if (std::find(corners.begin(), corners.end(), divided.point(v)) == corners.end()) continue;
    CHECK(remove_curve_vertex(divided, v, {HUGE_VAL}).outcome == Outcome::corner);
    CHECK(remove_inner_vertex(divided, v) == Outcome::constrained);
  }
}
