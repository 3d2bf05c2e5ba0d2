// tests/quality/quality_summary_test.cpp: the figures of a summary are those of the report.
#include "pliant/quality/quality_summary.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/quality/quality_report.h"
#include "support/sample_meshes.h"

using namespace pliant;

TEST_CASE("the figures of a summary are those of the report", "[quality]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool is_tangled = GENERATE(false, true);
  CAPTURE(degree, is_tangled);
  MeshData data = samples::three_disks(degree);
  if (is_tangled) data.points[0] = data.points[0] + Vector{1.5, 0.25};
  const QualityReport report = report_quality(data);
  const QualitySummary summary = summarize_quality(data);
  const auto metric = [&report](const char* name) {
    return *std::ranges::find(report.metrics, name, &MetricSummary::name);
  };
  CHECK(summary.triangles == report.triangles);
  CHECK(summary.invalid == report.invalid);
  CHECK((summary.invalid > 0) == is_tangled);
  CHECK(summary.degenerate == report.degenerate);
  CHECK(summary.min_logical_angle == metric("logical_angle").min);
  CHECK(summary.min_scaled_jacobian == metric("scaled_jacobian").min);
  CHECK(summary.min_shape == metric("shape").min);
  CHECK(summary.max_distortion == metric("distortion").max);
}

TEST_CASE("the norm of a field is the root of the integral of its square", "[quality]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  MeshData data = samples::three_disks(degree);
  // At each point the two components are 3 and x; on the last face, -2 times that.
  Field field{"both", 2, by_face, {}, {}, {}};
  const auto add = [&](PointId p, double factor) {
    field.values.insert(field.values.end(), {3 * factor, factor * data.points[static_cast<std::size_t>(p)].x});
  };
  const std::size_t n = data.triangles.size() / data.triangle_faces.size();
  for (std::size_t k = 0; by_face && k < data.triangles.size(); ++k)
    field.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::ranges::sort(field.places);
  field.places.erase(std::unique(field.places.begin(), field.places.end()), field.places.end());
  for (const auto& [p, f] : field.places) add(p, f == 2 ? -2 : 1);
  for (PointId p = 0; !by_face && p < static_cast<PointId>(data.points.size()); ++p) add(p, 1);
  data.fields = {field};
  const QualitySummary summary = summarize_quality(data);
  const QualityReport report = report_quality(data);
  REQUIRE(summary.fields.size() == 2);
  CHECK(summary.fields[0].field == "both");
  CHECK(summary.fields[1].component == 1);
  double square = 0;
  for (std::size_t f = 0; f < 3; ++f) square += (by_face && f == 2 ? 36 : 9) * report.faces[f].area;
  CHECK(summary.fields[0].l2 == Approx(std::sqrt(square)).epsilon(1e-12));
  CHECK(summary.fields[0].largest == (by_face ? 6 : 3));
  CHECK(summary.fields[1].largest ==
        Approx(std::max(std::abs(report.fields[0].min[1]), std::abs(report.fields[0].max[1]))));
}

TEST_CASE("growth is the ratio of after to before, for the components that both meshes have", "[quality]") {
  QualitySummary before, after;
  before.fields = {{"u", 0, 2, 1}, {"u", 1, 0, 0}, {"old", 0, 1, 1}};
  after.fields = {{"new", 0, 1, 1}, {"u", 0, 3, 0.5}, {"u", 1, 0, 0}};
  const auto growth = field_growth(before, after);
  REQUIRE(growth.size() == 2);
  CHECK(growth[0].field == "u");
  CHECK(growth[0].largest == 1.5);
  CHECK(growth[0].l2 == 0.5);
  CHECK(growth[1].component == 1);
  CHECK(growth[1].largest == 1);
  CHECK(growth[1].l2 == 1);
}
