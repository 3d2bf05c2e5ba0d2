// tests/mesh/documents_test.cpp: a live mesh and its document: compacting does what writing and reading again does.
#include <catch2/catch.hpp>

#include "formats/document/mesh_document.h"
#include "mesh/same_mesh.h"
#include "ops/random_operations.h"
#include "pliant/mesh/check_mesh.h"
#include "support/carried_members.h"
#include "support/document_texts.h"

using namespace pliant;
using samples::text_of;

TEST_CASE("compacting equals writing the document and reading it", "[mesh][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  Mesh mesh = carried_disk(degree, by_face);
  for (std::uint64_t round = 0; round < 4; ++round) {
    RandomOperations(mesh, round).run(80);
    const std::string text = text_of(mesh.to_data());
    const Mesh read(read_mesh(text));
    mesh.compact();
    REQUIRE(difference(mesh, read) == "");
    const bool is_same = text_of(mesh.to_data()) == text;
    CHECK(is_same);
    CHECK(mesh.triangle_slots() == mesh.triangle_count());
    CHECK(check_mesh(mesh).empty());
    // Further operations on the two meshes must give the same.
    Mesh other(read_mesh(text));
    RandomOperations(mesh, 50 + round).run(40);
    RandomOperations(other, 50 + round).run(40);
    REQUIRE(difference(mesh, other) == "");
  }
}

TEST_CASE("compacting again changes nothing, nor does it where only values have changed", "[mesh]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh = carried_disk(degree, true);
  RandomOperations(mesh, 4).run(50);
  mesh.compact();
  Mesh again = mesh;
  again.compact();
  CHECK(difference(mesh, again) == "");

  std::vector<double> row(static_cast<std::size_t>(mesh.width()), 0.25);
  mesh.put_fields(0, 0, row);
  mesh.set_point(mesh.net(0)[0], 1.5 * mesh.point(mesh.net(0)[0]));
  const Mesh read(mesh.to_data());
  mesh.compact();
  CHECK(difference(mesh, read) == "");
}

TEST_CASE("a document keeps what the mesh does not know, its criteria, time and by-face places", "[mesh]") {
  MeshData data = samples::three_disks(2);
  data.time = 0.1;
  data.criteria.max_area = 0.5;
  data.criteria.face_area = {{"upper", 0.25}};
  data.criteria.size = "0.1 + x";
  data.criteria.extra = samples::carried({{"wish", "1"}});
  data.extra = samples::carried({{"step", "[1,2]"}});
  data.boundary.extra = samples::carried({{"unit", "\"mm\""}});
  data.boundary.curves[1].extra = samples::carried({{"tension", "3.5"}});
  data.boundary.curves[1].removal_error = 1e-3;
  samples::add_field(data, "u", 2, [](const Point& p) { return std::vector<double>{p.y, -0.0}; });
  data.fields[0].extra = samples::carried({{"unit", "\"m/s\""}});
  const std::string text = text_of(data);
  const bool is_same = text_of(Mesh(read_mesh(text)).to_data()) == text;
  CHECK(is_same);
}

TEST_CASE("renumbering leaves the same elements and fields, and neighbours near each other", "[mesh]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool by_face = GENERATE(false, true);
  Mesh mesh = carried_disk(degree, by_face, 20);
  RandomOperations(mesh, 7, 600).run(3000);
  mesh.compact();
  Mesh renumbered = mesh;
  renumbered.renumber();
  CHECK(check_mesh(renumbered).empty());
  const auto rows_of = [](const Mesh& of) {
    std::vector<std::vector<double>> elements;
    for (TriangleId t = 0; t < of.triangle_slots(); ++t) {
      elements.emplace_back(static_cast<std::size_t>(of.net_size() * of.width()));
      of.gather(t, elements.back());
      elements.back().push_back(of.face(t));
    }
    std::sort(elements.begin(), elements.end());
    return elements;
  };
  const bool is_same = rows_of(mesh) == rows_of(renumbered);
  CHECK(is_same);
  CHECK(mesh.to_data().constrained_edges.size() == renumbered.to_data().constrained_edges.size());
  const auto apart = [](const Mesh& of) {
    double sum = 0;
    for (const HalfEdgeId h : of.half_edges())
      if (of.twin(h) != none) sum += std::abs(triangle_of(of.twin(h)) - triangle_of(h));
    return sum;
  };
  CHECK(apart(renumbered) < 0.5 * apart(mesh));
  Mesh again = renumbered;
  again.renumber();
  CHECK(difference(renumbered, again) == "");
}
