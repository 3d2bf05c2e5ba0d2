// tests/improve/straighten_edges_test.cpp: straighten_edges leaves no inner edge curved that can be straight.
#include "pliant/improve/smoothing/straighten_edges.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/smooth_edge.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

double bend(const Mesh& mesh, HalfEdgeId h) {
  double most = 0;
  for (int k = 1; k < mesh.degree(); ++k) {
    const double w = double(k) / mesh.degree();
    const Point straight = (1 - w) * mesh.point(mesh.origin(h)) + w * mesh.point(mesh.target(h));
    most = std::max(most, distance(mesh.point(mesh.edge_point(h, k)), straight));
  }
  return most;
}

}  // namespace

TEST_CASE("inner edges are straight afterwards, or cannot be without making an element invalid", "[improve]") {
  const int degree = GENERATE(2, 3, 4);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree);
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = area_of(mesh) / 150;
    refine(mesh, options);
    const double area = area_of(mesh);
    const StraightenCounts counts = straighten_edges(mesh);
    CHECK(find_invalid(mesh).empty());
    CHECK(check_mesh(mesh).empty());
    CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
    long curved = 0;
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (mesh.is_constrained(h) || mesh.twin(h) == none || h > mesh.twin(h)) continue;
      if (bend(mesh, h) <= 1e-13 * mesh.size()) continue;
      ++curved;
      Mesh copy = mesh;
      CHECK(straighten_edge(copy, h, 0) != Outcome::done);
    }
    CHECK(curved == counts.left);
    // Nothing is left to do.
    CHECK(straighten_edges(mesh).straightened == 0);
  }
}
