// tests/improve/enforce_delaunay_test.cpp: flips lead to the constrained Delaunay triangulation, and name what is left.
#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "improve/nearly_straight.h"
#include "pliant/generate/triangulate_boundary.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/legalize.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

using Corners = std::array<int, 3>;

Corners rotated(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The logical triangles as numbers of vertices, which count in the order of their points.
std::set<Corners> logical_triangles(const Mesh& mesh, std::vector<Point>& vertices,
                                    std::vector<std::array<int, 2>>& segments) {
  std::vector<int> number(static_cast<std::size_t>(mesh.point_slots()), -1);
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_vertex(p)) {
      number[static_cast<std::size_t>(p)] = static_cast<int>(vertices.size());
      vertices.push_back(mesh.point(p));
    }
  const auto name = [&](PointId p) { return number[static_cast<std::size_t>(p)]; };
  std::set<Corners> triangles;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (mesh.is_constrained(h) && mesh.twin(h) < h) segments.push_back({name(mesh.origin(h)), name(mesh.target(h))});
    if (edge_of(h) == 0) triangles.insert(rotated({name(mesh.origin(h)), name(mesh.target(h)), name(mesh.apex(h))}));
  }
  return triangles;
}

/// Unconstrained edges whose circle strictly contains the opposite vertex.
int count_not_delaunay(const Mesh& mesh) {
  int count = 0;
  for (const HalfEdgeId h : mesh.half_edges()) {
    const HalfEdgeId g = mesh.twin(h);
    if (g < h || mesh.is_constrained(h)) continue;
    count += in_circle(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                       mesh.point(mesh.apex(g))) > 0;
  }
  return count;
}

/// Do the open segments cross, or does one touch the other? Not if they only share an end.
bool are_crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orient2d(a, b, c) * orient2d(a, b, d) <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

/// How many vertices lie inside the circle of a triangle and are visible from its middle. A constrained Delaunay
/// triangulation has none.
int count_seen_in_circles(const std::set<Corners>& triangles, const std::vector<Point>& vertices,
                          const std::vector<std::array<int, 2>>& segments) {
  const auto point = [&vertices](int v) { return vertices[static_cast<std::size_t>(v)]; };
  int count = 0;
  for (const Corners& t : triangles) {
    const Point a = point(t[0]), b = point(t[1]), c = point(t[2]), middle = a / 3 + b / 3 + c / 3;
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
      if (in_circle(a, b, c, point(v)) <= 0) continue;
      count += std::ranges::none_of(segments, [&](const std::array<int, 2>& s) {
        return s[0] != v && s[1] != v && are_crossing(middle, point(v), point(s[0]), point(s[1]));
      });
    }
  }
  return count;
}

}  // namespace

TEST_CASE(
    "a nearly straight mesh with holes and interfaces gets the constrained Delaunay triangulation as its logical mesh",
    "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  const double bend = GENERATE(0.01, 0.05);
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  CAPTURE(degree, bend, seed);
  Mesh mesh = nearly_straight(degree, bend, seed);
  const double area = area_of(mesh), integral = integral_of(mesh, 1, 0);
  REQUIRE(count_not_delaunay(mesh) > 5);
  std::vector<Point> vertices;
  std::vector<std::array<int, 2>> segments;
  const std::set<Corners> given = logical_triangles(mesh, vertices, segments);
  CHECK(count_seen_in_circles(given, vertices, segments) > 5);
  vertices.clear();
  segments.clear();
  const PassReport report = enforce_delaunay(mesh);
  CHECK(value_of(report, "flips") > 5);
  CHECK(value_of(report, "not_delaunay") == 0);
  CHECK(value_of(report, "logically_inverted") == 0);
  CHECK(report.refusals.empty());
  CHECK(report.refused_at.empty());
  const std::set<Corners> found = logical_triangles(mesh, vertices, segments);
  CHECK(count_seen_in_circles(found, vertices, segments) == 0);
  std::set<Corners> wanted;  // the triangles of the convex hull, with those in holes and notches
  for (const Corners& t : triangulate(vertices, segments)) wanted.insert(rotated(t));
  const bool is_part = std::ranges::includes(wanted, found);
  CHECK(is_part);
  check_left(mesh);
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-13));
  CHECK(integral_of(mesh, 1, 0) == Approx(integral).margin(1e-12));
}

TEST_CASE("each refusal is listed with the middle of an edge that still wants its flip", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  int listed = 0;
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree);
    RandomOperations(mesh, 7).run(150);
    const PassReport report = enforce_delaunay(mesh);
    long refusals = 0;
    for (const auto& [reason, times] : report.refusals) refusals += times;
    CHECK(refusals == static_cast<long>(report.refused_at.size()));
    std::vector<std::pair<double, double>> wanted, refused;
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (mesh.twin(h) > h || !wants_flip(edge_state(mesh, h))) continue;
      std::vector<Point> points(static_cast<std::size_t>(degree) + 1);
      mesh.gather_edge_points(h, points);
      while (points.size() > 1) {  // de Casteljau
        for (std::size_t k = 0; k + 1 < points.size(); ++k) points[k] = 0.5 * points[k] + 0.5 * points[k + 1];
        points.pop_back();
      }
      wanted.emplace_back(points[0].x, points[0].y);
      // The operation takes a badly bent edge if no other place is valid; the pass refuses it.
      const auto listed_at = std::ranges::find_if(
          report.refused_at, [&](const auto& refusal) { return distance(refusal.place, points[0]) < 1e-12; });
      REQUIRE(listed_at != report.refused_at.end());
      Mesh copy = mesh;
      CHECK((flip_edge(copy, h) != Outcome::done || listed_at->reason == describe(Outcome::would_bend)));
    }
    for (const auto& [reason, place] : report.refused_at) refused.emplace_back(place.x, place.y);
    std::ranges::sort(wanted);
    std::ranges::sort(refused);
    REQUIRE(wanted.size() == refused.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      CHECK(wanted[k].first == Approx(refused[k].first).margin(1e-12));
      CHECK(wanted[k].second == Approx(refused[k].second).margin(1e-12));
    }
    listed += static_cast<int>(refused.size());
  }
  if (degree > 1) CHECK(listed > 0);
}

TEST_CASE("edges that only the limit of flips leaves are not listed as refusals", "[improve]") {
  Mesh mesh = scattered(2, 60, 1);
  DelaunayOptions options;
  options.max_flips = 1;
  const PassReport report = enforce_delaunay(mesh, options);
  CHECK(value_of(report, "not_delaunay") > 0);
  CHECK(report.refusals.empty());
}

TEST_CASE("a straight mesh becomes the constrained Delaunay triangulation of its vertices", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto seed = GENERATE(range<std::uint64_t>(0, 4));
  CAPTURE(degree, seed);
  Mesh mesh = scattered(degree, 60, seed);
  const double area = area_of(mesh), integral = integral_of(mesh, 1, 0);
  REQUIRE(count_not_delaunay(mesh) > 5);
  const PassReport report = enforce_delaunay(mesh);
  CHECK(value_of(report, "not_delaunay") == 0);
  CHECK(report.refusals.empty());
  std::vector<Point> vertices;
  std::vector<std::array<int, 2>> segments;
  const std::set<Corners> found = logical_triangles(mesh, vertices, segments);
  std::set<Corners> wanted;
  for (const Corners& t : triangulate(vertices, segments)) wanted.insert(rotated(t));
  CHECK(found == wanted);
  check_left(mesh);
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-13));
  CHECK(linear_error(mesh) < 1e-12);
  CHECK(integral_of(mesh, 1, 0) == Approx(integral).margin(1e-12));
}

TEST_CASE("flips of a straight mesh leave it straight", "[improve]") {
  const int degree = GENERATE(2, 3, 4);
  Mesh mesh = scattered(degree, 40, 9);
  enforce_delaunay(mesh);
  double bend = 0;
  const NetLayout& layout = mesh.layout();
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int k = 0; k < mesh.net_size(); ++k) {
      const auto& ijk = layout.exponents(k);
      Point straight;
      for (int c = 0; c < 3; ++c)
        straight += (double(ijk[static_cast<std::size_t>(c)]) / degree) * mesh.point(mesh.corner(t, c));
      bend = std::max(bend, distance(straight, mesh.point(mesh.net(t)[static_cast<std::size_t>(k)])));
    }
  CHECK(bend < 1e-13);
}

TEST_CASE("flips of cocircular grids come to an end, and no edge is left whose circle contains a vertex", "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  const bool is_bent = GENERATE(false, true);
  CAPTURE(degree, seed, is_bent);
  Mesh mesh = grid(degree, 8, seed);
  std::mt19937_64 random(seed);
  int flips = 0;
  for (int k = 0; k < 600; ++k)
    flips += flip_edge(mesh, static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()))) ==
             Outcome::done;
  REQUIRE(flips > 50);
  REQUIRE(count_not_delaunay(mesh) > 5);
  if (is_bent) lay_nearly_straight(mesh, 0.03, random);
  const PassReport report = enforce_delaunay(mesh);
  CHECK(value_of(report, "not_delaunay") == 0);
  CHECK(value_of(report, "logically_inverted") == 0);
  CHECK(count_not_delaunay(mesh) == 0);
  check_left(mesh);
}

TEST_CASE("a second run does nothing", "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  std::vector<Mesh> meshes{scattered(degree, 40, 3), grid(degree, 5, 3)};
  for (const Sample& sample : boundaries(degree)) meshes.push_back(mesh_of(sample.boundary, degree));
  for (Mesh& mesh : meshes) {
    RandomOperations(mesh, 5).run(150);
    mesh.compact();
    const PassReport first = enforce_delaunay(mesh);
    check_left(mesh);
    const std::string text = text_of(mesh);
    const PassReport second = enforce_delaunay(mesh);
    CHECK(value_of(second, "flips") == 0);
    CHECK(value_of(second, "not_delaunay") == value_of(first, "not_delaunay"));
    const bool is_same = text_of(mesh) == text;
    CHECK(is_same);
  }
}

TEST_CASE("every edge that the exact test finds is found, however large or thin the triangles", "[improve][property]") {
  const double factor = GENERATE(1.0, 0x1p-300, 0x1p300, 0x1p-510, 0x1p-1060),
               squeeze = GENERATE(1.0, 0x1p-30, 0x1p-140);
  CAPTURE(factor, squeeze);
  Mesh mesh = scattered(2, 120, 2);
  std::vector<Point> points;
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    points.push_back(factor * Point{mesh.point(p).x, squeeze * mesh.point(p).y});
  mesh.set_points(points);
  DelaunayOptions options;
  options.max_flips = 0;
  const PassReport report = enforce_delaunay(mesh, options);
  int wanted = 0, inverted = 0;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (mesh.twin(h) > h) continue;
    wanted += edge_state(mesh, h) == EdgeState::not_delaunay;
    inverted += edge_state(mesh, h) == EdgeState::inverted || edge_state(mesh, h) == EdgeState::turned_over;
  }
  CHECK(value_of(report, "not_delaunay") == wanted);
  CHECK(value_of(report, "logically_inverted") == inverted);
  CHECK(wanted + inverted > 5);
}

TEST_CASE("at most as many edges are flipped as asked", "[improve]") {
  Mesh mesh = scattered(2, 60, 1);
  Mesh all = mesh;
  const double wanted = value_of(enforce_delaunay(all), "flips");
  REQUIRE(wanted > 10);
  DelaunayOptions options;
  options.max_flips = 4;
  double flips = 0;
  for (int run = 0; run < 1000; ++run) {
    const PassReport report = enforce_delaunay(mesh, options);
    CHECK(value_of(report, "flips") <= 4);
    flips += value_of(report, "flips");
    if (value_of(report, "flips") < 4) break;
  }
  CHECK(flips >= 4);
  CHECK(count_not_delaunay(mesh) == 0);
}

TEST_CASE("the state of an edge is what the exact predicates say, also near their limits", "[improve][property]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> lattice(-2, 2), steps(-4, 4);
  int wanted = 0, cocircular = 0;
  for (int k = 0; k < 100'000; ++k) {
    // Points of a lattice are often on one line or on one circle; some are moved off it by a few roundings.
    std::array<Point, 4> p;
    const double scale = std::ldexp(1.0, k % 5 == 0 ? 400 * (k % 3 - 1) : 0);
    for (Point& each : p) {
      each = k % 2 == 0 ? Point{uniform(random), uniform(random)}
                        : Point{double(lattice(random)) + 7, double(lattice(random)) - 3};
      if (k % 4 == 1) each.x += steps(random) * 0x1p-50;
      each *= scale;
    }
    const auto& [a, b, c, d] = p;
    const bool is_above = orient2d(a, b, c) > 0, is_below = orient2d(b, a, d) > 0;
    const bool flips = orient2d(a, d, c) > 0 && orient2d(d, b, c) > 0;
    EdgeState state = EdgeState::inverted;
    if (!is_above || !is_below)
      state = (is_above || is_below) && flips ? EdgeState::turned_over : EdgeState::inverted;
    else if (in_circle(a, b, c, d) <= 0)
      state = EdgeState::delaunay;
    else
      state = flips ? EdgeState::not_delaunay : EdgeState::inverted;
    if (edge_state(a, b, c, d) != state) {
      CAPTURE(k, scale);
      CHECK(edge_state(a, b, c, d) == state);
    }
    wanted += wants_flip(state) ? 1 : 0;
    cocircular += is_above && is_below && in_circle(a, b, c, d) == 0 ? 1 : 0;
  }
  CHECK(wanted > 1000);
  CHECK(cocircular > 100);
}
