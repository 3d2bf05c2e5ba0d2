// tests/ops/allocation_test.cpp: operations allocate nothing once their scratch memory has grown
#include <atomic>
#include <cstdlib>

#include "ops/carried_domains.h"

// What the C library's malloc is asked for, by `new` and by Eigen; sanitizers have one of their own.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLIANT_OWN_MALLOC
#endif
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(PLIANT_OWN_MALLOC)

namespace {
std::atomic<long> allocations{0};
}

extern "C" void* __libc_malloc(std::size_t);  // NOLINT: glibc names it
extern "C" void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

using namespace pliant;

TEST_CASE("operations that leave the curves alone allocate nothing in the steady state", "[ops]") {
  const int degree = GENERATE(2, 3);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  Mesh mesh = carried_disk(degree, by_face, 16);
  std::mt19937_64 random(3);
  // No three vertices in a line, and what is refused not counted: where a sign hangs on the last bits, predicates and
  // certificates take exact numbers, which allocate.
  std::uniform_real_distribution<double> jitter(-0.02, 0.02);
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_vertex(p) && length(mesh.point(p)) < 0.6)
      mesh.set_point(p, mesh.point(p) + Vector{jitter(random), jitter(random)});
  REQUIRE(find_invalid(mesh).empty());
  std::array<long, 5> allocated{}, done{};  // insert, remove it, split, flip, remove any
  for (int round = 0; round < 5; ++round) {
    allocated = done = {};
    const auto count = [&](std::size_t kind, auto&& operation) {
      const long before = allocations;
      if (!operation()) return;
      allocated[kind] += allocations - before;
      ++done[kind];
    };
    for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      InsertResult inserted;
      count(0, [&] {
        inserted = insert_point(mesh, triangle_of(h), {0.3, 0.45, 0.25});
        return inserted.refusal == Refusal::done;
      });
      if (inserted.refusal == Refusal::done)
        count(1, [&] { return remove_inner_vertex(mesh, inserted.vertex) == Refusal::done; });
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      count(2, [&] {
        inserted = split_edge(mesh, h, 0.375);
        return inserted.refusal == Refusal::done;
      });
      if (inserted.refusal == Refusal::done)
        count(1, [&] { return remove_inner_vertex(mesh, inserted.vertex) == Refusal::done; });
    }
    for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h)) continue;
      // These change the mesh: taken back, so that every round meets the same one.
      Transaction undone(mesh);
      count(3, [&] { return flip_edge(mesh, h) == Refusal::done; });
      count(4, [&] { return remove_inner_vertex(mesh, mesh.origin(h)) == Refusal::done; });
    }
  }
  CAPTURE(done);
  for (const long each : done) CHECK(each > 10);
  CHECK(allocated == std::array<long, 5>{});
}

#endif
