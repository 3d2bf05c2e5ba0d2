// tests/ops/inner_removal_test.cpp: vertices of any degree inside faces are removed, ear by ear.
#include "ops/carried_domains.h"

using namespace pliant;

TEST_CASE("most inner vertices can be removed where elements are straight or only curves bend them",
          "[ops][property]") {
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(degree);
  int inner = 0, removed = 0, highest = 0;
  for (const Domain& domain : domains) {
    CAPTURE(domain.name);
    Mesh mesh = carried(domain, degree);
    for (TriangleId t = 0, n = mesh.triangle_slots(); t < n; ++t) insert_point(mesh, t, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    RandomOperations(mesh, 3, 3 * mesh.triangle_count()).run(300);
    const Mesh original = mesh;
    Star star;
    for (PointId v = 0; v < original.point_slots(); ++v) {
      if (!original.is_point_alive(v) || !original.is_vertex(v)) continue;
      find_star(original, v, star);
      if (is_on_curve(original, star)) continue;
      ++inner;
      mesh = original;
      const int triangles = mesh.triangle_count();
      if (remove_inner_vertex(mesh, v) != Outcome::done) continue;
      ++removed;
      highest = std::max(highest, star.degree());
      CHECK(mesh.triangle_count() == triangles - 2);
      CHECK(!mesh.is_point_alive(v));
      require_every_invariant(mesh);
    }
  }
  CHECK(inner > 100);
  CHECK(highest > 7);
  // Most vertices that cannot be removed are beside edges on curves that were split. The two halves go on smoothly, so
  // that an element with its corner there could be valid by rounding at best.
  CHECK(removed > (degree == 1 ? 0.9 : 0.82) * inner);
}
