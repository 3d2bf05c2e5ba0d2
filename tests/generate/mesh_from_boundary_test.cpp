// tests/generate/mesh_from_boundary_test.cpp: first meshes are valid and have exactly the area of their boundaries.
#include "pliant/generate/mesh_from_boundary.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "generate/meshed_boundary.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// Two circles, one inside the other, this far apart at the closest place.
BoundaryComplex eccentric_ring(double gap) {
  BoundaryComplex b = with_faces({"ring"});
  const BSpline outer = circle(2, {}, 1, 12);
  b.curves.push_back(closed_curve("outer", outer, 0));
  std::vector<Point> points = outer.points();
  // The inner circle is the outer one shrunk towards the middle of one of its spans, and moved inwards by the gap.
  const Point near = outer.evaluate(0.5);
  for (Point& p : points) p = near + 0.5 * (p - near);
  for (Point& p : points) p -= (gap / length(near)) * near;
  b.curves.push_back(closed_curve("inner", closed_spline(2, std::move(points)), outside, 0));
  return b;
}

/// A band that winds around the origin.
BoundaryComplex spiral(double turns, double width) {
  BoundaryComplex b = with_faces({"band"});
  std::vector<Point> out, back;
  const int count = static_cast<int>(12 * turns);
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12, radius = 0.3 + 0.1 * angle / (2 * std::numbers::pi);
    out.push_back((radius + width / 2) * Point{std::cos(angle), std::sin(angle)});
    back.push_back((radius - width / 2) * Point{std::cos(angle), std::sin(angle)});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  b.curves.push_back(closed_curve("band", closed_spline(3, std::move(out)), 0));
  return b;
}

}  // namespace

TEST_CASE("every sample boundary gets a valid mesh of exactly its area, at degrees 1 to 4", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  meshed(one_cell(degree));
  meshed(biconcave_cell(degree));
  meshed(three_cells(degree));
  meshed(annulus(degree));
  meshed(interface(degree));
  meshed(square(), degree);
  meshed(gear(), degree);
  if (degree >= 2) {
    meshed(annulus(degree, 0.97));
    meshed(divided_square(), degree);
    meshed(glyph(), degree);
  }
}

TEST_CASE("the degree of the mesh is that of the curves, at least two, or the one asked for", "[generate]") {
  CHECK(meshed(gear()).degree() == 2);
  CHECK(meshed(one_cell(3)).degree() == 3);
  CHECK(meshed(one_cell(2), 5).degree() == 5);
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(one_cell(3), {2}, mesh);
  CHECK_FALSE(outcome.ok);
  CHECK_THAT(outcome.failure, Catch::Contains("degree 2 cannot hold a curve of degree 3"));
}

TEST_CASE("no element covers a smooth or reflex corner", "[generate]") {
  // All corners of this curve are smooth, so no element may have two edges on it.
  const Mesh mesh = meshed(one_cell(2));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int e = 0; e < 3; ++e)
      CHECK_FALSE((mesh.is_constrained(half_edge(t, e)) && mesh.is_constrained(half_edge(t, (e + 1) % 3))));
}

TEST_CASE("a closed curve of one or two spans is split into at least three", "[generate]") {
  BoundaryComplex b = with_faces({"lens"});
  b.curves.push_back(closed_curve("lens", BSpline(2, true, {0, 0, 1, 1, 2}, {{0, 0}, {1, -1}, {2, 0}, {1, 1}}), 0));
  CHECK(meshed(b).spline(0).span_count() >= 3);
  BoundaryComplex drop = with_faces({"drop"});
  drop.vertices = {{0, 0}};
  drop.curves.push_back(open_curve(drop, "drop", 0, 0, {{3, -1}, {3, 1}}, 0));
  CHECK(meshed(drop).spline(0).span_count() >= 3);
}

TEST_CASE("two open curves between the same two vertices bound a lens", "[generate]") {
  BoundaryComplex b = with_faces({"lens"});
  b.vertices = {{0, 0}, {1, 0}};
  b.curves.push_back(open_curve(b, "lower", 0, 1, {{0.5, -0.1}}, 0));
  b.curves.push_back(open_curve(b, "upper", 1, 0, {{0.5, 0.1}}, 0));
  meshed(b);
}

TEST_CASE("a curve with the same face on both sides stays in the mesh", "[generate]") {
  BoundaryComplex b = square();
  b.vertices.insert(b.vertices.end(), {{0.2, 0.5}, {0.8, 0.5}});
  b.curves.push_back(open_curve(b, "slit", 4, 5, {{0.5, 0.9}}, 0, 0));
  const Mesh mesh = meshed(b);
  int constrained = 0;
  for (const HalfEdgeId h : mesh.half_edges())
    constrained += mesh.is_constrained(h) && mesh.constraint_curve(mesh.constraint(h)) == 4;
  CHECK(constrained == 2 * mesh.spline(4).span_count());
}

TEST_CASE("faces that touch in a vertex only are meshed", "[generate]") {
  BoundaryComplex b = with_faces({"low", "high"});
  b.vertices = {{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}, {1, 1}};
  const std::vector<std::array<int, 3>> sides{{0, 1, 0}, {1, 2, 0}, {2, 0, 0}, {2, 4, 1}, {4, 3, 1}, {3, 2, 1}};
  for (const auto& [from, to, face] : sides) b.curves.push_back(open_curve(b, "", from, to, {}, face));
  CHECK(meshed(b).triangle_count() == 2);
}

TEST_CASE("curves close to each other are meshed, down to a gap of 1e-8", "[generate]") {
  const double gap = GENERATE(1e-2, 1e-4, 1e-7, 1e-8);
  CAPTURE(gap);
  meshed(eccentric_ring(gap));
}

TEST_CASE("small angles between curves are meshed, and cusps are listed", "[generate]") {
  for (const double height : {0.3, 1e-2, 1e-4, 1e-6}) {
    CAPTURE(height);
    CHECK(meshed(crescent(height)).boundary().cusps.empty());
  }
  CHECK(meshed(crescent(0)).boundary().cusps == std::vector<int>{0});
}

TEST_CASE("a spiral and a sliver are meshed", "[generate]") {
  meshed(spiral(6, 0.05));
  meshed(spiral(3, 1e-4));
  BoundaryComplex sliver = with_faces({"sliver"});
  sliver.curves.push_back(closed_curve(
      "ellipse",
      closed_spline(2,
                    {{1, 0}, {0.7, 7e-5}, {0, 1e-4}, {-0.7, 7e-5}, {-1, 0}, {-0.7, -7e-5}, {0, -1e-4}, {0.7, -7e-5}}),
      0));
  meshed(sliver);
}

TEST_CASE("many cells of random shape in a channel are meshed", "[generate][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  const int degree = 2 + static_cast<int>(seed % 3);
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  BoundaryComplex b = with_faces({"plasma"});
  b.vertices = {{-1, -1}, {20, -1}, {20, 9}, {-1, 9}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "wall", i, (i + 1) % 4, {}, 0));
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 5; ++j) {
      const double turn = 3 * u(random), flat = 0.5 + 0.4 * u(random), second = 0.1 * u(random);
      const auto radius = [=](double a) {
        return 0.9 * std::sqrt(flat * flat + (1 - flat * flat) * std::pow(std::cos(a - turn), 2)) +
               second * std::cos(3 * a);
      };
      const Point center = 2.0 * Point{double(i), double(j)};
      const int face = static_cast<int>(b.faces.size());
      b.faces.push_back({"cell " + std::to_string(face), {}});
      b.curves.push_back(closed_curve("", polar_spline(degree, 9 + (i + j) % 5, center, radius), face, 0));
    }
  meshed(b);
}

TEST_CASE("faces that no curve separates are refused with the place", "[generate]") {
  BoundaryComplex b = interface(2);
  b.curves[4].right = 2;  // the cell's outside should be plasma
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(b, {}, mesh);
  CHECK_FALSE(outcome.ok);
  CHECK_THAT(outcome.failure, Catch::Contains("are not separated by a curve near (") && Catch::Contains("parameters"));
}

TEST_CASE("the same boundary gives the same mesh, bit for bit", "[generate]") {
  const MeshData a = meshed(interface(3)).to_data(), b = meshed(interface(3)).to_data();
  CHECK(a.points == b.points);
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("points stand in the document's order: vertices, edges, interiors", "[generate]") {
  const MeshData data = meshed(interface(4)).to_data();
  const int size = net_size(data.degree);
  int corners = 0, edges = 0;
  for (std::size_t n = 0; n < data.triangles.size(); ++n) {
    const int index = static_cast<int>(n) % size;
    if (index < 3) corners = std::max(corners, data.triangles[n] + 1);
    if (index < 3 * data.degree) edges = std::max(edges, data.triangles[n] + 1);
  }
  CHECK(corners + (edges - corners) == edges);
  for (std::size_t n = 0; n < data.triangles.size(); ++n) {
    const int index = static_cast<int>(n) % size;
    if (index >= 3) CHECK(data.triangles[n] >= corners);
    if (index >= 3 * data.degree) CHECK(data.triangles[n] >= edges);
  }
}
