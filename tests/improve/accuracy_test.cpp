// tests/improve/accuracy_test.cpp: an accuracy asked for sets the spans of curves and what removals may change.
#include <algorithm>
#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/check_mesh.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// The largest resolution error of a span, and how many spans there are.
struct Resolution {
  double error = 0;
  int spans = 0;
};
Resolution resolution_of(const Mesh& mesh) {
  Resolution result;
  for (const Curve& curve : mesh.boundary().curves) {
    const std::vector<double> breaks = curve.spline.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      result.error = std::max(result.error, curve.spline.resolution_error(breaks[i]));
      ++result.spans;
    }
  }
  return result;
}

}  // namespace

TEST_CASE("refining to an accuracy makes every span fine enough, and coarsening then leaves it so",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  int too_coarse = 0;
  double removals = 0;
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree, false);
    mesh.criteria.accuracy = 2e-3 * mesh.size();
    const double wanted = goals_of(mesh).resolution;
    too_coarse += resolution_of(mesh).error > wanted;
    refine(mesh);
    const Resolution refined = resolution_of(mesh);
    CHECK(refined.error <= wanted);
    CHECK(value_of(refine(mesh), "insertions") == 0);
    const PassReport coarsened = coarsen(mesh);
    CHECK(value_of(coarsened, "largest_error") <= wanted);
    CHECK(value_of(refine(mesh), "insertions") == 0);
    CHECK(resolution_of(mesh).error <= wanted);
    CHECK(check_mesh(mesh).empty());
    removals += value_of(coarsened, "curve_removals");
  }
  CHECK(too_coarse > 0);
  CHECK(removals > 0);
}

TEST_CASE("half the size of spans is what an accuracy of 2^-(degree + 1) of it asks for", "[improve]") {
  const int degree = GENERATE(2, 3);
  CAPTURE(degree);
  const auto spans = [degree](double accuracy) {
    Mesh mesh = mesh_of(samples::one_cell(degree), degree, false);
    mesh.criteria.min_angle = 0;
    mesh.criteria.accuracy = accuracy * mesh.size();
    refine(mesh);
    return resolution_of(mesh).spans;
  };
  const int few = spans(1e-4), many = spans(1e-4 / (8 << (3 * (degree - 1))));
  CAPTURE(few, many);
  // From one to the other the size falls by 2^(3 + 3 (degree - 1)) to the power of 1 / (degree + 1).
  const double expected = std::exp2(3.0 * degree / (degree + 1));
  CHECK(many > few * expected / 1.7);
  CHECK(many < few * expected * 1.7);
}
