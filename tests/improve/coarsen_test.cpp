#include "pliant/improve/coarsen.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// Refined to an area, with all angles reached.
Mesh fine_mesh(const Sample& sample, int degree, double share) {
  Mesh mesh = mesh_of(sample.boundary, degree);
  RefineOptions options;
  options.goals.max_area = share * area_of(mesh);
  refine(mesh, options);
  return mesh;
}

CoarsenOptions options_for(const Mesh& mesh, double tolerance) {
  CoarsenOptions options;
  options.goals.max_area = area_of(mesh) / 12;
  options.tolerance = tolerance * mesh.size();
  options.step_tolerance = options.tolerance / 4;
  return options;
}

}  // namespace

TEST_CASE("after coarsening there is nothing to refine", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const double tolerance = GENERATE(1e-3, 0.05);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, tolerance, sample.name);
    Mesh mesh = fine_mesh(sample, degree, 1.0 / 200);
    CoarsenOptions coarse = options_for(mesh, tolerance);
    coarse.goals.max_turning = 1.2;
    RefineOptions fine;
    fine.goals = coarse.goals;
    refine(mesh, fine);
    bool meets = true;
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) meets = meets && !refine_reason(mesh, t, fine.goals);
    const int before = mesh.triangle_count();
    const PassReport report = coarsen(mesh, coarse);
    CHECK(mesh.triangle_count() < before);
    CHECK(value_of(report, "removals") > 0);
    check_left(mesh);
    if (!meets) continue;
    const std::string text = text_of(mesh);
    const PassReport again = refine(mesh, fine);
    CHECK(value_of(again, "insertions") == 0);
    CHECK(value_of(again, "left") == 0);
    const bool is_same = text_of(mesh) == text;
    CHECK(is_same);
  }
}

TEST_CASE("coarsening ends: a second run removes little, a third nothing more", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh = fine_mesh({"cell", samples::biconcave_cell(degree)}, degree, 1.0 / 200);
  const CoarsenOptions options = options_for(mesh, 1e-3);
  const double first = value_of(coarsen(mesh, options), "removals");
  double rest = 0;
  for (int run = 0; run < 6; ++run) rest += value_of(coarsen(mesh, options), "removals");
  CHECK(rest < 0.25 * first);
  CHECK(value_of(coarsen(mesh, options), "removals") == 0);
}

TEST_CASE("curves stay within their removal error, which adds up and is bounded", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool keep_area = GENERATE(false, true);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, keep_area, sample.name);
    if (degree == 4 && sample.name != "biconcave cell" && sample.name != "divided square") continue;  // for time
    Mesh mesh = fine_mesh(sample, degree, 1.0 / 100);
    const BoundaryComplex original = mesh.boundary();
    CoarsenOptions options = options_for(mesh, 0);
    options.keep_area = keep_area;
    std::vector<double> accumulated(original.curves.size(), 0);
    for (const double tolerance : {0.002, 0.01, 0.03}) {
      options.tolerance = tolerance * mesh.size();
      options.step_tolerance = options.tolerance / 2;
      const PassReport report = coarsen(mesh, options);
      check_left(mesh);
      CHECK(value_of(report, "largest_error") <= options.step_tolerance);
      double largest = 0;
      for (std::size_t c = 0; c < original.curves.size(); ++c) {
        CAPTURE(c);
        const Curve& now = mesh.boundary().curves[c];
        const BSpline& was = original.curves[c].spline;
        CHECK(now.removal_error <= options.tolerance);
        CHECK(now.removal_error >= accumulated[c]);
        accumulated[c] = now.removal_error;
        largest = std::max(largest, now.removal_error);
        const double slack = 1e-4 * mesh.size();  // of the polygon that stands for the other curve
        CHECK(distance_of_curves(was, now.spline, 60) <= now.removal_error + slack);
        CHECK(distance_of_curves(now.spline, was, 60) <= now.removal_error + slack);
        if (keep_area && now.spline.closed()) CHECK(now.spline.area() == Approx(was.area()).epsilon(1e-12));
      }
      CHECK(value_of(report, "accumulated_error") == largest);
    }
    CHECK(linear_error(mesh) < 1e-11);
    // A curve that has used up its tolerance is left alone.
    MeshData data = mesh.to_data();
    for (Curve& curve : data.boundary.curves) curve.removal_error = options.tolerance * (1 + 1e-12);
    Mesh used(std::move(data));
    CHECK(value_of(coarsen(used, options), "curve_removals") == 0);
  }
}

TEST_CASE("the area of the whole region is kept with keep_area", "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh = fine_mesh({"cells", samples::three_cells(degree)}, degree, 1.0 / 150);
  const double area = area_of(mesh);
  CoarsenOptions options = options_for(mesh, 0.02);
  options.keep_area = true;
  CHECK(value_of(coarsen(mesh, options), "curve_removals") > 0);
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
}

TEST_CASE("removals that leave the curves where they are keep integrals, linear functions and the region",
          "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh = fine_mesh({"channel", samples::interface(degree)}, degree, 1.0 / 200);
  const double area = area_of(mesh), integral = integral_of(mesh, 1, 0);
  CoarsenOptions options = options_for(mesh, 0);  // only knots that were inserted, or on straight walls, may go
  const PassReport report = coarsen(mesh, options);
  CHECK(value_of(report, "interior_removals") > 20);
  CHECK(value_of(report, "accumulated_error") == 0);
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-13));
  CHECK(linear_error(mesh) < 1e-11);
  CHECK(integral_of(mesh, 1, 0) == Approx(integral).margin(1e-12 * std::max(1.0, area)));
}

TEST_CASE("knots that Douglas-Peucker needs stay, so that the polygon's shape does", "[improve]") {
  const int degree = GENERATE(2, 3);
  Mesh mesh = fine_mesh({"cell", samples::biconcave_cell(degree)}, degree, 1.0 / 100);
  const BSpline was = mesh.spline(0);
  CoarsenOptions options = options_for(mesh, 1);
  options.step_tolerance = options.tolerance;
  options.goals.min_angle = 0;
  Mesh loose = mesh;
  coarsen(loose, options);
  options.polygon_tolerance = 0.01;
  coarsen(mesh, options);
  check_left(mesh);
  CHECK(mesh.spline(0).span_count() > loose.spline(0).span_count());
}

TEST_CASE("a smaller factor keeps more vertices", "[improve]") {
  const int degree = GENERATE(1, 2);
  const Mesh mesh = fine_mesh({"cell", samples::one_cell(degree)}, degree, 1.0 / 300);
  int last = 0;
  for (const double factor : {2.0, 1.0, 0.5, 0.25}) {
    Mesh coarse = mesh;
    CoarsenOptions options = options_for(mesh, 1e-3);
    options.factor = factor;
    coarsen(coarse, options);
    CHECK(coarse.triangle_count() >= last);
    last = coarse.triangle_count();
  }
}
