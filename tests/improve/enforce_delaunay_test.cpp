#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "improve/improve_meshes.h"
#include "pliant/generate/triangulate_boundary.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/refine.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

using Corners = std::array<int, 3>;

Corners rotated(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The logical triangles, by numbers of the vertices (in the order of their points).
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
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (mesh.is_constrained(h) && mesh.twin(h) < h) segments.push_back({name(mesh.origin(h)), name(mesh.target(h))});
    if (edge_of(h) == 0) triangles.insert(rotated({name(mesh.origin(h)), name(mesh.target(h)), name(mesh.apex(h))}));
  }
  return triangles;
}

/// Unconstrained edges whose circle strictly contains the opposite vertex.
int count_not_delaunay(const Mesh& mesh) {
  int count = 0;
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    const HalfEdgeId g = mesh.twin(h);
    if (g < h || mesh.is_constrained(h)) continue;
    count += in_circle(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                       mesh.point(mesh.apex(g))) > 0;
  }
  return count;
}

/// Least height of a logical triangle over its longest side; negative if it is turned over.
double thickness(const Mesh& mesh, TriangleId t) {
  const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
              &c = mesh.point(mesh.corner(t, 2));
  return cross(b - a, c - a) / std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
}

/// Lays inner edges straight but for up to this part of their lengths, and the inner points of elements straight.
void lay_nearly_straight(Mesh& mesh, double bend, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-bend, bend);
  const int p = mesh.degree();
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (mesh.is_constrained(h) || mesh.twin(h) > h) continue;
    const Point a = mesh.point(mesh.origin(h)), along = mesh.point(mesh.target(h)) - a;
    const double side = uniform(random) < 0 ? -1 : 1;
    for (int k = 1; k < p; ++k)
      mesh.set_point(mesh.edge_point(h, k),
                     a + (double(k) / p) * along + side * std::abs(uniform(random)) * Vector{-along.y, along.x});
  }
  const NetLayout& layout = mesh.layout();
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int k = 3 * p; k < mesh.net_size(); ++k) {
      Point straight;
      for (int c = 0; c < 3; ++c)
        straight += (double(layout.exponents(k)[static_cast<std::size_t>(c)]) / p) * mesh.point(mesh.corner(t, c));
      mesh.set_point(mesh.net(t)[static_cast<std::size_t>(k)], straight);
    }
}

/// The square of `scattered`, with a notch in its side and a hole beside its interface, all of its curves bent by up to
/// this part of their length: refined, its vertices then moved and edges flipped at random as far as triangles do not
/// become thin, and its inner edges bent.
Mesh nearly_straight(int degree, double bend, std::uint64_t seed) {
  BoundaryComplex boundary = samples::with_faces({"west", "east"});
  boundary.vertices = {{0, 0},    {1, 0},     {1, 1},       {0, 1},      {0.35, 0},
                       {0.72, 1}, {0.7, 0.3}, {0.85, 0.45}, {0.72, 0.6}, {0.88, 0.7}};
  const int sides[11][4] = {{0, 4, 0, outside}, {4, 1, 1, outside}, {1, 9, 1, outside}, {9, 2, 1, outside},
                            {2, 5, 1, outside}, {5, 3, 0, outside}, {3, 0, 0, outside}, {4, 5, 0, 1},
                            {6, 8, 1, outside}, {8, 7, 1, outside}, {7, 6, 1, outside}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const auto& [start, end, left, right] : sides) {
    Curve curve = straight_curve(boundary, degree, 1, start, end, left, right);
    const Point a = curve.spline.points().front(), b = curve.spline.points().back();
    const double side = bend * uniform(random);
    for (int i = 1; i < degree; ++i)
      curve.spline.set_point(i,
                             curve.spline.points()[static_cast<std::size_t>(i)] + side * Vector{a.y - b.y, b.x - a.x});
    boundary.curves.push_back(std::move(curve));
  }
  Mesh mesh = mesh_of(boundary, degree);
  RefineOptions options;
  options.goals.max_area = 0.01;
  refine(mesh, options);
  lay_nearly_straight(mesh, 0, random);
  constexpr double thin = 0.2;
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    if (!mesh.is_vertex(v)) continue;
    const Point old = mesh.point(v);
    mesh.set_point(v, old + 0.08 * Vector{uniform(random), uniform(random)});
    for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
      const bool is_at_v = mesh.origin(h) == v;
      if (is_at_v &&
          (thickness(mesh, triangle_of(h)) < thin || mesh.is_constrained(h) || mesh.is_constrained(previous(h))))
        mesh.set_point(v, old);
    }
  }
  lay_nearly_straight(mesh, 0, random);
  for (int k = 0; k < 300; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    Mesh flipped = mesh;
    if (flip_edge(flipped, h) == Refusal::done && thickness(flipped, triangle_of(h)) > thin &&
        thickness(flipped, triangle_of(flipped.twin(h))) > thin)
      mesh = std::move(flipped);
  }
  mesh.compact();
  lay_nearly_straight(mesh, bend, random);
  REQUIRE(find_invalid(mesh).empty());
  return mesh;
}

/// Do the open segments cross, or does one touch the other? Not if they only share an end.
bool are_crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orient2d(a, b, c) * orient2d(a, b, d) <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

/// Vertices inside the circle of a triangle and visible from its middle: in a constrained Delaunay triangulation none.
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
  std::set<Corners> wanted;  // of the convex hull
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
    for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
      if (mesh.twin(h) > h || !wants_flip(edge_state(mesh, h))) continue;
      std::vector<Point> points(static_cast<std::size_t>(degree) + 1);
      mesh.gather_edge_points(h, points);
      while (points.size() > 1) {  // de Casteljau
        for (std::size_t k = 0; k + 1 < points.size(); ++k) points[k] = 0.5 * points[k] + 0.5 * points[k + 1];
        points.pop_back();
      }
      wanted.emplace_back(points[0].x, points[0].y);
      Mesh copy = mesh;
      CHECK(flip_edge(copy, h) != Refusal::done);
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

TEST_CASE("what the limit of flips leaves is no refusal", "[improve]") {
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

TEST_CASE("cocircular grids come to an end, and no edge is left whose circle contains a vertex", "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  const bool is_bent = GENERATE(false, true);
  CAPTURE(degree, seed, is_bent);
  Mesh mesh = grid(degree, 8, seed);
  std::mt19937_64 random(seed);
  int flips = 0;
  for (int k = 0; k < 600; ++k)
    flips += flip_edge(mesh, static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()))) ==
             Refusal::done;
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
