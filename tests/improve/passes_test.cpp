// tests/improve/passes_test.cpp: all passes on all samples: invariants, pipes, any place and scale.
#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/smooth_curves.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// The passes of a step, with goals that give each of them something to do.
PassReport run_pass(int pass, Mesh& mesh, double area) {
  if (pass == 0) return enforce_delaunay(mesh);
  if (pass == 1) {
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = area / 120;
    return refine(mesh, options);
  }
  if (pass == 2) {
    CoarsenOptions options;
    options.goals.emplace();
    options.goals->max_area = area / 30;
    options.tolerance = 0.01 * mesh.size();
    options.step_tolerance = *options.tolerance / 4;
    return coarsen(mesh, options);
  }
  SmoothOptions options;
  options.bounds.max_distortion = 1.01;
  return smooth_curves(mesh, options).report;
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
    for (int pass = 0; pass < (degree < 3 ? 8 : 4); ++pass) {
      CAPTURE(pass);
      run_pass(pass % 4, mesh, area);
      check_left(mesh);
      Mesh next(read_mesh(piped));
      run_pass(pass % 4, next, area);
      piped = text_of(next);
      const bool is_same = piped == text_of(mesh);
      REQUIRE(is_same);
    }
    CHECK(linear_error(mesh) < 1e-10);
  }
}

TEST_CASE("the passes are the same wherever the mesh lies and however large it is, up to powers of two",
          "[improve][property]") {
  // Every tolerance is relative: a mesh scaled by a power of two takes the same decisions.
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
  for (int pass = 0; pass < 8; ++pass) {
    CAPTURE(pass);
    run_pass(pass % 4, mesh, area);
    run_pass(pass % 4, scaled, factor * factor * area);
    REQUIRE(scaled.triangle_count() == mesh.triangle_count());
  }
  CHECK(area_of(scaled) == Approx(factor * factor * area_of(mesh)).epsilon(1e-12));
  check_left(scaled);
}
