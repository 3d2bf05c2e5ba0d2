// tests/improve/passes_test.cpp: every pass on every sample: invariants, pipes, and scales that are powers of two.
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "improve/improve_meshes.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/smooth_curves.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

PassReport flip(Mesh& mesh, double) { return enforce_delaunay(mesh); }

PassReport refine_to_120th(Mesh& mesh, double whole_area) {
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = whole_area / 120;
  return refine(mesh, options);
}

PassReport coarsen_to_30th(Mesh& mesh, double whole_area) {
  CoarsenOptions options;
  options.goals.emplace();
  options.goals->max_area = whole_area / 30;
  options.tolerance = 0.01 * mesh.size();
  options.step_tolerance = *options.tolerance / 4;
  return coarsen(mesh, options);
}

PassReport smooth_to_1_01(Mesh& mesh, double) {
  SmoothOptions options;
  options.bounds.max_distortion = 1.01;
  return smooth_curves(mesh, options).report;
}

struct Pass {
  const char* name;
  PassReport (*run)(Mesh& mesh, double whole_area);
};

/// All passes in the order of a step, with goals that give each of them something to do.
// clang-format off
constexpr std::array passes{
    Pass{"enforce_delaunay", flip},
    Pass{"refine", refine_to_120th},
    Pass{"coarsen", coarsen_to_30th},
    Pass{"smooth_curves", smooth_to_1_01},
};
// clang-format on

/// The passes of so many steps, one after another.
std::vector<Pass> steps(int count) {
  std::vector<Pass> all;
  for (int step = 0; step < count; ++step) all.insert(all.end(), passes.begin(), passes.end());
  return all;
}

}  // namespace

TEST_CASE("every pass leaves every sample in order, and a pipe of passes equals one process", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool by_face = degree % 2 == 0;
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, by_face, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree, by_face);
    const double area = area_of(mesh);
    RandomOperations(mesh, 31).run(25);
    mesh.compact();
    std::string piped = text_of(mesh);
    for (const Pass& pass : steps(degree < 3 ? 2 : 1)) {
      CAPTURE(pass.name);
      pass.run(mesh, area);
      check_left(mesh);
      Mesh next(read_mesh(piped));
      pass.run(next, area);
      piped = text_of(next);
      const bool is_same = piped == text_of(mesh);
      REQUIRE(is_same);
    }
    CHECK(linear_error(mesh) < 1e-10);
  }
}

TEST_CASE("passes take the same decisions on a mesh that is scaled by a power of two", "[improve][property]") {
  // Every tolerance is relative to the size of the mesh, and a power of two changes no digits.
  const int degree = GENERATE(1, 2, 3);
  const double factor = GENERATE(0x1p-20, 0x1p20);
  CAPTURE(degree, factor);
  Mesh mesh = mesh_of(samples::biconcave_cell(degree), degree);
  MeshData data = mesh.to_data();
  for (Point& p : data.points) p *= factor;
  for (Curve& curve : data.boundary.curves)
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
  Mesh scaled(std::move(data));
  const double area = area_of(mesh);
  for (const Pass& pass : steps(2)) {
    CAPTURE(pass.name);
    pass.run(mesh, area);
    pass.run(scaled, factor * factor * area);
    REQUIRE(scaled.triangle_count() == mesh.triangle_count());
  }
  CHECK(area_of(scaled) == Approx(factor * factor * area_of(mesh)).epsilon(1e-12));
  check_left(scaled);
}
