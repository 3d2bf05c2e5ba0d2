#include "pliant/improve/enforce_delaunay.h"

#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "improve/improve_meshes.h"
#include "pliant/generate/triangulate_boundary.h"
#include "pliant/geometry/predicates.h"
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

}  // namespace

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
  CAPTURE(degree, seed);
  Mesh mesh = grid(degree, 8, seed);
  std::mt19937_64 random(seed);
  int flips = 0;
  for (int k = 0; k < 600; ++k)
    flips += flip_edge(mesh, static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()))) ==
             Refusal::done;
  REQUIRE(flips > 50);
  REQUIRE(count_not_delaunay(mesh) > 5);
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
