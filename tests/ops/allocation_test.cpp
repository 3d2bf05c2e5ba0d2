// tests/ops/allocation_test.cpp: operations allocate nothing once their scratch memory has grown.
#include "ops/carried_domains.h"
#include "support/counted_malloc.h"

#ifdef PLIANT_COUNTS_MALLOC

using namespace pliant;

TEST_CASE("operations that leave the curves alone allocate nothing in the steady state", "[ops]") {
  const int degree = GENERATE(2, 3);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  Mesh mesh = carried_disk(degree, by_face, 16);
  std::mt19937_64 random(3);
  // Where a sign depends on the last bits, predicates and certificates compute with exact numbers, which allocate.
  // Therefore vertices are moved so that no three are in a line, and refused operations are not counted.
  std::uniform_real_distribution<double> jitter(-0.02, 0.02);
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_vertex(p) && length(mesh.point(p)) < 0.6)
      mesh.set_point(p, mesh.point(p) + Vector{jitter(random), jitter(random)});
  REQUIRE(find_invalid(mesh).empty());
  std::array<long, 5> allocated{}, done{};  // insert a vertex, remove it, split an edge, flip, remove any vertex
  for (int round = 0; round < 5; ++round) {
    allocated = done = {};
    const auto count = [&](std::size_t kind, auto&& operation) {
      const long before = allocations;
      if (!operation()) return;
      allocated[kind] += allocations - before;
      ++done[kind];
    };
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      InsertResult inserted;
      count(0, [&] {
        inserted = insert_point(mesh, triangle_of(h), {0.3, 0.45, 0.25});
        return inserted.outcome == Outcome::done;
      });
      if (inserted.outcome == Outcome::done)
        count(1, [&] { return remove_inner_vertex(mesh, inserted.vertex) == Outcome::done; });
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      count(2, [&] {
        inserted = split_edge(mesh, h, 0.375);
        return inserted.outcome == Outcome::done;
      });
      if (inserted.outcome == Outcome::done)
        count(1, [&] { return remove_inner_vertex(mesh, inserted.vertex) == Outcome::done; });
    }
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      // These operations change the mesh; they are rolled back, so that every round starts with the same mesh.
      Transaction undone(mesh);
      count(3, [&] { return flip_edge(mesh, h) == Outcome::done; });
      count(4, [&] { return remove_inner_vertex(mesh, mesh.origin(h)) == Outcome::done; });
    }
  }
  CAPTURE(done);
  for (const long each : done) CHECK(each > 10);
  CHECK(allocated == std::array<long, 5>{});
}

#endif
