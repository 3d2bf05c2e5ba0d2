// tests/formats/msh/msh_writer_test.cpp: a mesh that is written as MSH and read again is the same mesh.
#include "formats/msh/msh_writer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "formats/document/mesh_document.h"
#include "formats/msh/msh.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/check_mesh.h"
#include "support/msh_texts.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"

using namespace pliant;
using samples::msh_file, samples::written_kinds;

namespace {

MeshData meshed(const BoundaryComplex& boundary, int degree) {
  Mesh mesh;
  REQUIRE(mesh_from_boundary(boundary, {degree}, mesh).ok);
  return mesh.to_data();
}

/// By name: the triangles of each face, and the ends of each curve's edges, as the first mesh numbers them.
struct Named {
  std::map<std::string, std::set<std::size_t>> faces;
  std::map<std::string, std::set<std::pair<std::size_t, std::size_t>>> curves;
};
template <class TriangleNumber, class PointNumber>
Named named(const MeshData& mesh, TriangleNumber&& triangle, PointNumber&& point) {
  Named result;
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t)
    result.faces[mesh.boundary.faces[index(mesh.triangle_faces[t])].name].insert(triangle(t));
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    result.curves[mesh.boundary.curves[index(edge.curve)].name].insert(
        std::minmax(point(index(edge.points.front())), point(index(edge.points.back()))));
  return result;
}

/// What is read is what was written, up to its numbering.
void check_same(const MeshData& mesh, const MshWriteOptions& options, double tolerance) {
  const MshImport import = read_msh(msh_file(mesh, options));
  CHECK(import.warnings.empty());
  CHECK(check_structure(import.mesh).empty());
  const auto point_before = [&](std::size_t p) { return index(import.nodes.tag_of(p) - 1); };
  const auto triangle_before = [&](std::size_t t) { return index(import.elements.tag_of(t) - 1); };
  REQUIRE(import.mesh.degree == mesh.degree);
  REQUIRE(import.mesh.points.size() == mesh.points.size());
  REQUIRE(import.mesh.triangle_faces.size() == mesh.triangle_faces.size());
  Box box;
  for (const Point& p : mesh.points) box.extend(p);
  double worst = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    worst = std::max(worst, distance(import.mesh.points[p], mesh.points[point_before(p)]));
  CHECK(worst <= tolerance * box.size());
  const std::size_t n = index(net_size(mesh.degree));
  bool same_nets = true;
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t)
    for (std::size_t k = 0; k < n; ++k)
      same_nets = same_nets && point_before(index(import.mesh.triangles[n * t + k])) ==
                                   index(mesh.triangles[n * triangle_before(t) + k]);
  CHECK(same_nets);
  const auto itself = [](auto k) { return index(k); };
  const Named before = named(mesh, itself, itself), after = named(import.mesh, triangle_before, point_before);
  CHECK(before.faces == after.faces);
  CHECK(before.curves == after.curves);
  CHECK(import.mesh.boundary.faces.size() == mesh.boundary.faces.size());
  CHECK(import.mesh.boundary.curves.size() == mesh.boundary.curves.size());
}

}  // namespace

TEST_CASE("a mesh that is written and read is the same mesh, with its faces and curves", "[msh]") {
  const int degree = GENERATE(range(1, 6));
  for (const auto& boundary :
       {samples::one_cell(degree), samples::annulus(degree), samples::three_cells(degree), samples::interface(degree)})
    for (const MshWriteOptions& kind : written_kinds) {
      CAPTURE(degree, boundary.faces.front().name, kind.version, kind.binary);
      check_same(meshed(boundary, degree), kind, 1e-14);
    }
}

TEST_CASE("orders up to ten are written and read", "[msh]") {
  for (int degree = 1; degree <= max_degree; ++degree)
    for (const MshWriteOptions& kind : written_kinds) {
      CAPTURE(degree, kind.version, kind.binary);
      // Rounding, times the growth of the condition number of interpolation at equally spaced nodes.
      check_same(samples::disk(degree, std::max(8, degree)), kind, 2e-16 * std::pow(2.6, degree));
    }
}

TEST_CASE("straight elements on dyadic coordinates come back bit for bit", "[msh]") {
  samples::MeshBuilder builder(2);
  std::vector<PointId> v;
  for (const Point& p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}}) v.push_back(builder.add_vertex(p));
  builder.data().boundary = samples::with_faces({"one", "two"});
  builder.add_triangle(v[0], v[1], v[2], 0);
  builder.add_triangle(v[0], v[2], v[3], 1);
  BoundaryComplex& b = builder.data().boundary;
  b.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const int sides[5][4] = {
      {0, 1, 0, outside}, {1, 2, 0, outside}, {0, 2, 1, 0}, {2, 3, 1, outside}, {3, 0, 1, outside}};
  for (int k = 0; k < 5; ++k) {
    const auto [from, to, left, right] = sides[k];
    b.curves.push_back(samples::open_curve(b, k == 2 ? "between" : "wall", from, to,
                                           {0.5 * (b.vertices[index(from)] + b.vertices[index(to)])}, left, right));
    builder.data().constrained_edges.push_back({k, 0, builder.edge(v[index(from)], v[index(to)])});
  }
  REQUIRE(check_structure(builder.data()).empty());
  for (const MshWriteOptions& kind : written_kinds) {
    CAPTURE(kind.version, kind.binary);
    check_same(builder.data(), kind, 0);
  }
}

TEST_CASE("tangled elements are written as they are", "[msh]") {
  MeshData mesh = samples::disk(2);
  mesh.points[0] += {0.9, 0};
  REQUIRE(!find_invalid(mesh).empty());
  for (const MshWriteOptions& kind : written_kinds) {
    const MeshData again = read_msh(msh_file(mesh, kind)).mesh;
    CHECK(find_invalid(again).invalid == find_invalid(mesh).invalid);
  }
}

TEST_CASE("names that would end a line or a quotation are written so that the file stays whole", "[msh]") {
  MeshData mesh = samples::disk(2);
  mesh.boundary.faces[0].name = "a \"cell\"\nof\tmany";
  mesh.boundary.curves[0].name = "";
  for (int k = 0; k < 100; ++k) mesh.boundary.curves[0].name += "\xc3\xa9";
  for (const MshWriteOptions& kind : written_kinds) {
    const MshImport import = read_msh(msh_file(mesh, kind));
    CHECK(import.mesh.boundary.faces[0].name == "a 'cell' of many");
    CHECK(import.mesh.boundary.curves[0].name == mesh.boundary.curves[0].name.substr(0, 126));
  }
  mesh.boundary.curves[0].name = "";
  for (const MshWriteOptions& kind : written_kinds)
    CHECK(read_msh(msh_file(mesh, kind)).mesh.boundary.curves[0].name == "curve 1");
}
