// tests/mesh/check_mesh_test.cpp: breaches of the invariants in documents are found and named
#include "pliant/mesh/check_mesh.h"

#include <catch2/catch.hpp>

#include "support/sample_meshes.h"

using namespace pliant;

TEST_CASE("a cusp that names no vertex is a fault of the arrays", "[mesh]") {
  MeshData data = samples::disk(2);
  REQUIRE(check_arrays(data).empty());
  for (const int v : {-1, 0, 1000000}) {
    data.boundary.cusps = {v};
    const auto faults = check_arrays(data);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].place == "/boundary/cusps/0");
  }
}

TEST_CASE("a point that stands twice in one edge breaks M1", "[mesh]") {
  MeshData data = samples::disk(3);
  REQUIRE(check_structure(data).empty());
  const auto& layout = NetLayout::of(3);
  const auto first = static_cast<std::size_t>(layout.edge_index(0, 1)),
             second = static_cast<std::size_t>(layout.edge_index(0, 2));
  const PointId kept = data.triangles[first], dropped = data.triangles[second];
  for (PointId& p : data.triangles)
    if (p == dropped) p = kept;
  bool found = false;
  for (const Fault& fault : check_structure(data))
    found = found || fault.text.find("used in two places") != fault.text.npos;
  CHECK(found);
}
