// tests/quality/overlaps_test.cpp: overlaps are found where triangles overlap, and nowhere else.
#include "pliant/quality/overlaps.h"

#include <catch2/catch.hpp>
#include <random>

#include "pliant/geometry/predicates.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/quality_report.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

using Corners = std::array<Point, 3>;

/// Straight triangles that share no points, all in one face.
MeshData triangle_soup(int degree, const std::vector<Corners>& triangles) {
  MeshData data;
  data.degree = degree;
  data.boundary.faces.push_back({"all", {}});
  const NetLayout& layout = NetLayout::of(degree);
  for (const auto& [a, b, c] : triangles) {
    for (int k = 0; k < layout.size(); ++k) {
      const auto [i, j, l] = layout.exponents(k);
      data.triangles.push_back(static_cast<PointId>(data.points.size()));
      data.points.push_back((i * a + j * b + l * c) / degree);
    }
    data.triangle_faces.push_back(0);
  }
  return data;
}

bool is_inside(const Point& p, const Corners& t) {
  return orient2d(t[0], t[1], p) > 0 && orient2d(t[1], t[2], p) > 0 && orient2d(t[2], t[0], p) > 0;
}

/// True if two triangles in general position overlap.
bool do_overlap(const Corners& s, const Corners& t) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Point &a = s[i], &b = s[(i + 1) % 3], &c = t[j], &d = t[(j + 1) % 3];
      if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0) return true;
    }
  return is_inside(s[0], t) || is_inside(t[0], s);
}

std::int64_t overlaps_of(const MeshData& data) { return find_overlaps(data, HalfEdges(data), 5).count; }

}  // namespace

TEST_CASE("a soup of triangles overlaps if and only if two of its triangles do", "[quality][property]") {
  const int degree = GENERATE(1, 2, 3);
  int overlapping = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(degree, seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1);
    std::vector<Corners> triangles;
    const double size = seed % 2 ? 0.2 : 0.5;
    for (int k = 0; k < 4; ++k) {
      const Point center{place(random), place(random)};
      Corners t;
      do {
        for (Point& p : t) p = center + size * Point{place(random), place(random)};
      } while (orient2d(t[0], t[1], t[2]) <= 0);
      triangles.push_back(t);
    }
    bool expected = false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) expected = expected || do_overlap(triangles[i], triangles[j]);
    REQUIRE((overlaps_of(triangle_soup(degree, triangles)) > 0) == expected);
    overlapping += expected ? 1 : 0;
  }
  CHECK(overlapping > 100);
  CHECK(overlapping < 300);
}

TEST_CASE("a part that lies on another without crossing its boundary is an overlap, and its place is told",
          "[quality]") {
  const MeshData data = triangle_soup(2, {{{{0, 0}, {9, 0}, {0, 9}}}, {{{1, 1}, {2, 1}, {1, 2}}}});
  const Overlaps overlaps = find_overlaps(data, HalfEdges(data), 5);
  REQUIRE(overlaps.count == 1);
  CHECK(overlaps.places[0].first == 1);
  CHECK(overlaps.places[0].second == none);
  CHECK(is_inside(overlaps.places[0].place, {{{1, 1}, {2, 1}, {1, 2}}}));
}

TEST_CASE("where boundaries cross, both elements and the place are named", "[quality]") {
  const MeshData data = triangle_soup(2, {{{{0, 0}, {2, 0}, {0, 2}}}, {{{0.5, -1}, {3, -1}, {0.5, 1}}}});
  const Overlaps overlaps = find_overlaps(data, HalfEdges(data), 1);
  CHECK(overlaps.count == 2);
  REQUIRE(overlaps.places.size() == 1);
  CHECK(overlaps.places[0].first + overlaps.places[0].second == 1);
  CHECK(std::abs(overlaps.places[0].place.y) < 1e-9);
}

TEST_CASE("sound meshes with several components, holes and interfaces do not overlap", "[quality]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  CHECK(overlaps_of(samples::three_disks(degree)) == 0);
  // A ring: its inner loop runs clockwise and is covered once on its left.
  std::vector<Corners> ring;
  MeshData data;
  data.degree = 1;
  data.boundary.faces.push_back({"ring", {}});
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi * k / 6;
    for (const double radius : {1.0, 2.0}) data.points.push_back(radius * Point{std::cos(angle), std::sin(angle)});
    const PointId inner = 2 * k, outer = 2 * k + 1, next_inner = (2 * k + 2) % 24, next_outer = (2 * k + 3) % 24;
    data.triangles.insert(data.triangles.end(), {inner, outer, next_outer, inner, next_outer, next_inner});
    data.triangle_faces.insert(data.triangle_faces.end(), 2, 0);
  }
  CHECK(overlaps_of(data) == 0);
}

TEST_CASE("a strip that winds over itself overlaps though every element is valid", "[quality]") {
  // One and a half turns of a helix seen from above, a little narrower on the second turn. Its sides cross nothing
  // except the ends of the strip.
  MeshData data;
  data.degree = 1;
  data.boundary.faces.push_back({"strip", {}});
  const int steps = 36;
  for (int k = 0; k <= steps; ++k) {
    const double angle = 3 * std::numbers::pi * k / steps, inset = 0.01 * k;
    for (const double radius : {1 + inset, 2 - inset})
      data.points.push_back(radius * Point{std::cos(angle), std::sin(angle)});
    if (k == steps) break;
    const PointId inner = 2 * k, outer = 2 * k + 1;
    data.triangles.insert(data.triangles.end(), {inner, outer, outer + 2, inner, outer + 2, inner + 2});
    data.triangle_faces.insert(data.triangle_faces.end(), 2, 0);
  }
  REQUIRE(find_invalid(data).empty());
  CHECK(overlaps_of(data) > 0);
}

TEST_CASE("points at one place and points in no triangle are counted", "[quality]") {
  MeshData data =
      triangle_soup(2, {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}, {{{5, -0.0}, {6, 0}, {5, 1}}}});
  data.points.push_back({0, 0});  // not a vertex, so no duplicate
  data.points.push_back({7, 7});
  const QualityReport report = report_quality(data);
  CHECK(report.duplicate_points == 2);
  CHECK(report.unused_points == 2);
  CHECK(report.vertices == 9);
  CHECK(report.control_points == 18);
  CHECK(report.overlaps > 0);  // the seam: two edges at one place
  CHECK(report_quality(samples::three_disks(3)).duplicate_points == 0);
}
