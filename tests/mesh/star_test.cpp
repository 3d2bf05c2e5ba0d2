// tests/mesh/star_test.cpp: stars hold every triangle around their vertices.
#include "pliant/mesh/star.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "ops/random_operations.h"

using namespace pliant;

namespace {

bool is_around(const Mesh& mesh, TriangleId t, PointId v) {
  return mesh.is_alive(t) && (mesh.corner(t, 0) == v || mesh.corner(t, 1) == v || mesh.corner(t, 2) == v);
}

}  // namespace

TEST_CASE("a star holds every triangle around its vertex, counter-clockwise, and is closed inside only",
          "[mesh][property]") {
  const int degree = GENERATE(1, 2, 3);
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(degree, seed);
  Mesh mesh = carried_disk(degree);
  RandomOperations(mesh, seed).run(120);
  Star star;
  int vertices = 0, edges = 0;
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    if (!mesh.is_point_alive(v) || !mesh.is_vertex(v)) continue;
    ++vertices;
    find_star(mesh, v, star);
    std::set<TriangleId> found, wanted;
    for (const HalfEdgeId h : star.outgoing) {
      CHECK(mesh.origin(h) == v);
      found.insert(triangle_of(h));
    }
    bool on_outer = false, on_curve = false;
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      if (!is_around(mesh, t, v)) continue;
      wanted.insert(t);
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(t, e);
        if (mesh.origin(h) != v && mesh.target(h) != v) continue;
        on_outer = on_outer || mesh.twin(h) == none;
        on_curve = on_curve || mesh.is_constrained(h);
      }
    }
    CHECK(found == wanted);
    CHECK(star.degree() == static_cast<int>(wanted.size()));
    CHECK(star.is_closed == !on_outer);
    CHECK(is_on_curve(mesh, star) == on_curve);
    // The third side of each triangle is the first side of the next one.
    for (std::size_t k = 0; k + 1 < star.outgoing.size(); ++k)
      CHECK(mesh.apex(star.outgoing[k]) == mesh.target(star.outgoing[k + 1]));
    if (star.is_closed) {
      CHECK(mesh.apex(star.outgoing.back()) == mesh.target(star.outgoing.front()));
    } else {
      CHECK(mesh.twin(star.outgoing.front()) == none);
      CHECK(mesh.twin(previous(star.outgoing.back())) == none);
    }
    edges += star.degree() + (star.is_closed ? 0 : 1);
  }
  CHECK(vertices - edges / 2 + mesh.triangle_count() == 1);  // Euler's formula for a disk
}

TEST_CASE("a half-edge is found by its ends if there is one", "[mesh]") {
  Mesh mesh = carried_disk(2);
  RandomOperations(mesh, 12).run(60);
  std::vector<PointId> vertices;
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_point_alive(p) && mesh.is_vertex(p)) vertices.push_back(p);
  for (const PointId a : vertices)
    for (const PointId b : vertices) {
      HalfEdgeId wanted = none;
      for (const HalfEdgeId h : mesh.half_edges())
        if (mesh.is_alive(triangle_of(h)) && mesh.origin(h) == a && mesh.target(h) == b) wanted = h;
      if (find_half_edge(mesh, a, b) != wanted) FAIL_CHECK("from " << a << " to " << b);
    }
}
