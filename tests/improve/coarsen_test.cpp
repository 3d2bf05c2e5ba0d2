// tests/improve/coarsen_test.cpp: coarsening goes as far as sizes, shapes and curves let it, and no farther.
#include "pliant/improve/coarsen.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// A mesh whose elements are refined to this share of the whole area, and to the default least angle.
Mesh fine_mesh(const Sample& sample, int degree, double share, bool by_face = false) {
  Mesh mesh = mesh_of(sample.boundary, degree, by_face);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = share * area_of(mesh);
  refine(mesh, options);
  return mesh;
}

CoarsenOptions options_for(const Mesh& mesh, double tolerance) {
  CoarsenOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / 12;
  options.tolerance = tolerance * mesh.size();
  options.step_tolerance = *options.tolerance / 4;
  return options;
}

/// How many equilateral triangles of the wanted lengths h fill the mesh: the integral of 4/(sqrt(3) h²).
double wanted_count(const Mesh& mesh, const QualityGoals& goals) {
  double sum = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Point middle =
        (1.0 / 3) * (mesh.point(mesh.corner(t, 0)) + mesh.point(mesh.corner(t, 1)) + mesh.point(mesh.corner(t, 2)));
    double h = goals.length_for_area(mesh.face(t));
    if (goals.size) h = std::min(h, goals.size(middle, 0));
    sum += area_at(mesh, t) / (h * h);
  }
  return 4 / std::sqrt(3.0) * sum;
}

/// The same goals for ten times as many triangles.
QualityGoals tenfold(QualityGoals goals) {
  if (goals.max_area < HUGE_VAL) goals.max_area /= 10;
  if (goals.size)
    goals.size = [coarse = goals.size](const Point& p, double time) { return coarse(p, time) / std::sqrt(10.0); };
  return goals;
}

}  // namespace

TEST_CASE("a mesh ten times too fine is coarsened to the number of triangles that sizes ask for, within 15 percent",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3);
  using namespace samples;
  const std::vector<Sample> all{{"cell", one_cell(degree)},
                                {"annulus", annulus(degree)},
                                {"cells in a channel", samples::interface(degree)},
                                {"gear", gear(6)}};
  for (const Sample& sample : all) {
    if (degree == 3 && sample.name != "annulus") continue;  // the others take long
    for (const char* const kind : {"uniform", "area", "graded"}) {
      CAPTURE(degree, sample.name, kind);
      Mesh mesh = mesh_of(sample.boundary, degree);
      const double area = area_of(mesh), length = std::sqrt(area / 500);
      CoarsenOptions coarse;
      coarse.goals.emplace();
      if (kind == std::string("uniform")) coarse.goals->size = [=](const Point&, double) { return length; };
      if (kind == std::string("area")) coarse.goals->max_area = area / 500;
      if (kind == std::string("graded"))
        coarse.goals->size = [=, from = mesh.box().low](const Point& p, double) {
          return 0.4 * length + 0.1 * (p.x - from.x);
        };
      coarse.tolerance = 1e-2 * mesh.size();
      RefineOptions fine;
      fine.goals = tenfold(*coarse.goals);
      refine(mesh, fine);
      const BoundaryComplex was = mesh.boundary();
      const double wanted = wanted_count(mesh, *coarse.goals);
      const PassReport report = coarsen(mesh, coarse);
      check_left(mesh);
      CAPTURE(wanted, mesh.triangle_count());
      CHECK(mesh.triangle_count() < 1.15 * wanted);
      CHECK(mesh.triangle_count() > 0.85 * wanted);
      double least = 60;
      for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) least = std::min(least, least_angle(mesh, t));
      CHECK(least >= 20.7 - 1e-9);
      for (std::size_t c = 0; c < was.curves.size(); ++c) {
        const double off = distance_of_curves(was.curves[c].spline, mesh.boundary().curves[c].spline, 60);
        CHECK(off <= mesh.boundary().curves[c].removal_error + 1e-4 * mesh.size());
        CHECK(mesh.boundary().curves[c].removal_error <= coarse.tolerance);
      }
      CHECK(linear_error(mesh) < 1e-11);
      fine.goals = coarse.goals;
      const std::string text = text_of(mesh);
      CHECK(value_of(refine(mesh, fine), "insertions") == 0);
      const bool is_same = text_of(mesh) == text;
      CHECK(is_same);
    }
  }
}

TEST_CASE("without a bound on size coarsening leaves less than twice the triangles of a new mesh", "[improve]") {
  const int degree = GENERATE(1, 2);
  Mesh mesh = fine_mesh({"gear", samples::gear(6)}, degree, 1.0 / 3000);
  CoarsenOptions options;
  options.tolerance = 1e-3 * mesh.size();
  Mesh first = mesh_of(samples::gear(6), degree);
  refine(first, {});
  coarsen(mesh, options);
  check_left(mesh);
  CHECK(mesh.triangle_count() < 2 * first.triangle_count());
}

TEST_CASE("a field of wanted lengths bounds sizes as an expression does", "[improve]") {
  Mesh mesh = fine_mesh({"cell", samples::one_cell(2)}, 2, 1.0 / 3000);
  const double length = std::sqrt(area_of(mesh) / 200);
  const auto wanted = [=](const Point& p) { return length * (1 + 0.2 * p.x); };
  MeshData data = mesh.to_data();
  samples::add_field(data, "wanted", 1, [&](const Point& p) { return std::vector<double>{wanted(p)}; });
  data.criteria.size_field = "wanted";
  mesh = Mesh(std::move(data));
  Mesh same = mesh;
  CoarsenOptions by_field, by_expression;
  by_field.goals = goals_of(mesh, {});
  by_expression.goals->size = [&](const Point& p, double) { return wanted(p); };
  by_field.tolerance = by_expression.tolerance = 1e-2 * mesh.size();
  coarsen(mesh, by_field);
  coarsen(same, by_expression);
  check_left(mesh);
  CHECK(std::abs(mesh.triangle_count() - same.triangle_count()) < 0.05 * same.triangle_count());
  CHECK(mesh.triangle_count() < 1.15 * wanted_count(same, *by_expression.goals));
  RefineOptions fine;
  fine.goals = by_field.goals;
  CHECK(value_of(refine(mesh, fine), "insertions") == 0);
  fine.goals->size_field = none;
  CHECK(value_of(refine(mesh, fine), "insertions") == 0);
  mesh.criteria.size_field = "noise";
  CHECK_THROWS_WITH(goals_of(mesh, {}), Catch::Contains("has 2 components"));
  mesh.criteria.size_field = "nothing";
  CHECK_THROWS_WITH(goals_of(mesh, {}), Catch::Contains("no field 'nothing'"));
}

TEST_CASE("the local feature size keeps elements small where curves bend or come close", "[improve]") {
  Mesh mesh = fine_mesh({"annulus", samples::annulus(2)}, 2, 1.0 / 3000);
  Mesh free = mesh;
  CoarsenOptions options;
  options.tolerance = 0.05 * mesh.size();
  coarsen(free, options);
  int last = free.triangle_count();
  for (const double share : {1.0, 0.5, 0.25}) {
    Mesh coarse = mesh;
    options.feature_share = share;
    coarsen(coarse, options);
    check_left(coarse);
    CHECK(coarse.triangle_count() > last);
    last = coarse.triangle_count();
  }
}

TEST_CASE("after coarsening there is nothing to refine", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const double tolerance = GENERATE(1e-3, 0.05);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, tolerance, sample.name);
    Mesh mesh = fine_mesh(sample, degree, 1.0 / 200);
    CoarsenOptions coarse = options_for(mesh, tolerance);
    coarse.goals->max_turning = 1.2;
    RefineOptions fine;
    fine.goals = coarse.goals;
    refine(mesh, fine);
    bool meets = true;
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) meets = meets && !refine_reason(mesh, t, *fine.goals);
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

TEST_CASE("coarsening ends: later runs remove less than a quarter of what the first did, and then nothing",
          "[improve]") {
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
    if (degree == 4 && sample.name != "biconcave cell" && sample.name != "divided square")
      continue;  // the others take long
    Mesh mesh = fine_mesh(sample, degree, 1.0 / 100);
    const BoundaryComplex original = mesh.boundary();
    CoarsenOptions options = options_for(mesh, 0);
    options.keep_area = keep_area;
    std::vector<double> accumulated(original.curves.size(), 0);
    for (const double tolerance : {0.002, 0.01, 0.03}) {
      options.tolerance = tolerance * mesh.size();
      options.step_tolerance = *options.tolerance / 2;
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
        const double slack = 1e-4 * mesh.size();  // the polygon that stands for the other curve is off by this
        CHECK(distance_of_curves(was, now.spline, 60) <= now.removal_error + slack);
        CHECK(distance_of_curves(now.spline, was, 60) <= now.removal_error + slack);
        if (keep_area && now.spline.closed()) CHECK(now.spline.area() == Approx(was.area()).epsilon(1e-12));
      }
      CHECK(value_of(report, "accumulated_error") == largest);
    }
    CHECK(linear_error(mesh) < 1e-11);
    // A curve that has used up its tolerance is left alone.
    MeshData data = mesh.to_data();
    for (Curve& curve : data.boundary.curves) curve.removal_error = *options.tolerance * (1 + 1e-12);
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

TEST_CASE("where curves move, integrals are kept if that is asked for, linear functions otherwise", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  const bool by_face = GENERATE(false, true);
  Mesh mesh = fine_mesh({"cells", samples::three_cells(degree)}, degree, 1.0 / 150, by_face);
  CoarsenOptions options = options_for(mesh, 0.05);
  options.goals->max_area = HUGE_VAL;
  CAPTURE(degree, by_face);
  Mesh reproduced = mesh;
  const double linear = integral_of(mesh, 0, 0), noise = integral_of(mesh, 1, 0);
  const PassReport report = coarsen(reproduced, options);
  REQUIRE(value_of(report, "curve_removals") > 0);
  CHECK(value_of(report, "integral_change") > 1e-6);
  CHECK(linear_error(reproduced) < 1e-11);
  options.refit.region_change = RegionChange::conserve;
  CHECK(value_of(coarsen(mesh, options), "integral_change") < 1e-12);
  check_left(mesh);
  const double scale = area_of(mesh) * mesh.size();
  CHECK(integral_of(mesh, 0, 0) == Approx(linear).margin(1e-12 * scale));
  CHECK(integral_of(mesh, 1, 0) == Approx(noise).margin(1e-12 * scale));
}

TEST_CASE("removals that leave the curves where they are keep integrals, linear functions and the region",
          "[improve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh = fine_mesh({"channel", samples::interface(degree)}, degree, 1.0 / 200);
  const double area = area_of(mesh), integral = integral_of(mesh, 1, 0);
  // Without tolerance only those knots may go that refinement has inserted, or that lie on straight walls.
  CoarsenOptions options = options_for(mesh, 0);
  const PassReport report = coarsen(mesh, options);
  CHECK(value_of(report, "interior_removals") > 20);
  CHECK(value_of(report, "accumulated_error") < 1e-13);
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
  options.goals->min_angle = 0;
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
  for (const double factor : {1.0, 0.5, 0.25}) {
    Mesh coarse = mesh;
    CoarsenOptions options = options_for(mesh, 1e-3);
    options.factor = factor;
    coarsen(coarse, options);
    CHECK(coarse.triangle_count() >= last);
    last = coarse.triangle_count();
  }
}
