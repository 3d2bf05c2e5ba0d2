// tests/quality/quality_report_test.cpp: figures of the report against closed formulas, and against each other.
#include "pliant/quality/quality_report.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/tangent_jump.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

const MetricSummary& metric(const QualityReport& report, const std::string& name) {
  return *std::ranges::find(report.metrics, name, &MetricSummary::name);
}

/// The control values of the coordinate x: a field whose integral is the first moment of area.
Field abscissa(const MeshData& data) {
  Field field{"x", 2, false, {}, {}, {}};
  for (const Point& p : data.points) field.values.insert(field.values.end(), {p.x, 1.0});
  return field;
}

}  // namespace

TEST_CASE("the area of a face is what Green's theorem says of its curve", "[quality]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  const MeshData data = samples::three_disks(degree);
  const QualityReport report = report_quality(data);
  CHECK(report.faults.empty());
  REQUIRE(report.faces.size() == 3);
  for (std::size_t f = 0; f < 3; ++f) {
    const BSpline& outline = data.boundary.curves[f].spline;
    CHECK(report.faces[f].name == data.boundary.faces[f].name);
    CHECK(report.faces[f].area == Approx(outline.area()).epsilon(1e-12));
    CHECK(report.faces[f].perimeter == Approx(outline.arc_length()).epsilon(1e-9));
    CHECK(report.faces[f].triangles == 24);
  }
  CHECK(report.triangles == 72);
  CHECK(report.vertices == 3 * 17);
  CHECK(report.control_points == static_cast<std::int64_t>(data.points.size()));
  CHECK(report.degree == degree);
  CHECK(report.invalid == 0);
  CHECK(report.degenerate == 0);
  CHECK(report.overlaps == 0);
  CHECK(report.area == Approx(report.faces[0].area + report.faces[1].area + report.faces[2].area));
}

TEST_CASE("histograms hold every value and the worst come first", "[quality]") {
  const MeshData data = samples::three_disks(3);
  const int bins = GENERATE(1, 7, 20);
  const QualityReport report = report_quality(data, {4, bins, {}, 1e-3});
  REQUIRE(report.metrics.size() == 11);
  for (const MetricSummary& summary : report.metrics) {
    CAPTURE(summary.name);
    CHECK(summary.histogram.size() == static_cast<std::size_t>(bins));
    CHECK(std::accumulate(summary.histogram.begin(), summary.histogram.end(), std::int64_t{0}) == summary.count);
    CHECK(summary.count + summary.missing == (summary.name == "edge_length" ? 3 * 40 : 72));
    CHECK(summary.histogram_low <= summary.min);
    CHECK(summary.histogram_high >= summary.max);
    CHECK(summary.min <= summary.mean);
    CHECK(summary.mean <= summary.max);
    REQUIRE(summary.worst.size() == 4);
    const bool most = summary.name == "jacobian_max" || summary.name == "distortion" || summary.name == "turning_angle";
    CHECK(summary.worst[0].value == (most ? summary.max : summary.min));
    for (std::size_t k = 1; k < 4; ++k)
      CHECK((most ? summary.worst[k].value <= summary.worst[k - 1].value
                  : summary.worst[k].value >= summary.worst[k - 1].value));
  }
  CHECK(metric(report, "shape").min > 0);
  CHECK(metric(report, "distortion").min >= 1);
  CHECK(metric(report, "element_area").mean == Approx(report.area / 72));
}

TEST_CASE("the figures of faces add up to those of the whole", "[quality]") {
  MeshData data = samples::three_disks(2);
  data.fields.push_back(abscissa(data));
  const QualityReport whole = report_quality(data);
  double area = 0, integral = 0, least = HUGE_VAL;
  std::int64_t triangles = 0;
  for (const std::string name : {"upper", "lower", "right"}) {
    const QualityReport part = report_quality(data, {5, 20, {name}, 1e-3});
    REQUIRE(part.faces.size() == 1);
    CHECK(part.faces[0].name == name);
    area += part.area, triangles += part.triangles, integral += part.fields[0].integral[0];
    least = std::min(least, part.fields[0].min[0]);
  }
  CHECK(area == Approx(whole.area));
  CHECK(triangles == whole.triangles);
  CHECK(integral == Approx(whole.fields[0].integral[0]));
  CHECK(least == whole.fields[0].min[0]);
  CHECK_THROWS_AS(report_quality(data, {5, 20, {"middle"}, 1e-3}), std::invalid_argument);
}

TEST_CASE("the integral of a field is exact: of one it is the area, of x the first moment", "[quality]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  MeshData data = samples::disk(degree, 9, {2, -1}, 0.5);
  data.fields.push_back(abscissa(data));
  const QualityReport report = report_quality(data);
  REQUIRE(report.fields.size() == 1);
  const FieldFigures& figures = report.fields[0];
  CHECK(figures.integral[1] == Approx(report.area).epsilon(1e-13));
  CHECK(figures.integral[0] == Approx(2 * report.area).epsilon(1e-12));  // the cell is symmetric about its centre
  CHECK(figures.min[1] == 1);
  CHECK(figures.max[1] == 1);
  Box box;
  for (const Point& p : data.points) box.extend(p);
  CHECK(figures.min[0] == box.low.x);
  CHECK(figures.max[0] == box.high.x);
}

TEST_CASE("a field by face counts on each face with its own values, and has no integral if a place is missing",
          "[quality]") {
  MeshData data = samples::three_disks(2);
  Field field{"p", 1, true, {}, {}, {}};
  const auto n = static_cast<std::size_t>(net_size(2));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    field.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::ranges::sort(field.places);
  field.places.erase(std::unique(field.places.begin(), field.places.end()), field.places.end());
  for (const auto& [point, face] : field.places) field.values.push_back(face + 1);
  data.fields.push_back(field);
  const QualityReport report = report_quality(data);
  CHECK(report.faults.empty());
  CHECK(report.fields[0].min[0] == 1);
  CHECK(report.fields[0].max[0] == 3);
  CHECK(report.fields[0].integral[0] ==
        Approx(report.faces[0].area + 2 * report.faces[1].area + 3 * report.faces[2].area));
  data.fields[0].places.pop_back();
  data.fields[0].values.pop_back();
  const QualityReport broken = report_quality(data);
  CHECK_FALSE(broken.faults.empty());
  CHECK(std::isnan(broken.fields[0].integral[0]));
  CHECK(broken.fields[0].max[0] == 3);
}

TEST_CASE("splines of a mesh are smooth to rounding, and a control point moved aside shows as an angle", "[quality]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  MeshData data = samples::disk(degree, 12, {100, 50}, 3);
  REQUIRE(tangent_jump(data).has_value());
  CHECK(*tangent_jump(data) < 1e-12);
  // A leg of a mesh edge is turned by a known small angle; the spline stays, so only the edges show it.
  const ConstrainedEdge& edge = data.constrained_edges[3];
  const Point start = data.points[static_cast<std::size_t>(edge.points[0])];
  Point& next = data.points[static_cast<std::size_t>(edge.points[1])];
  const double angle = 1e-8;
  const Vector leg = next - start;
  next = start + leg + angle * perpendicular(leg);
  // At degree 2 the moved point also ends the edge, where the angle changes by about as much.
  CHECK(*tangent_jump(data) == Approx(angle).epsilon(degree == 2 ? 0.3 : 1e-4));
}

TEST_CASE("a mesh of straight curves has no tangent jump to speak of", "[quality]") {
  CHECK_FALSE(tangent_jump(samples::disk(1)).has_value());
  CHECK_FALSE(report_quality(samples::disk(1)).tangent_jump.has_value());
}

TEST_CASE("faults of a broken document are reported with its figures", "[quality]") {
  MeshData data = samples::disk(2);
  const auto n = static_cast<std::size_t>(net_size(2));
  data.triangles.erase(data.triangles.begin(), data.triangles.begin() + static_cast<std::ptrdiff_t>(n));
  data.triangle_faces.erase(data.triangle_faces.begin());
  REQUIRE(check_arrays(data).empty());
  const QualityReport report = report_quality(data);
  CHECK_FALSE(report.faults.empty());
  CHECK(report.triangles == 23);
  CHECK(report.metrics.size() == 11);
}

TEST_CASE("a tangled element is counted, and named among the worst", "[quality]") {
  MeshData data = samples::disk(2);
  const auto n = static_cast<std::size_t>(net_size(2));
  const double sound = report_quality(data).area;
  std::swap(data.triangles[5 * n + 3], data.triangles[5 * n + 4]);  // two edge points exchanged
  const QualityReport report = report_quality(data);
  CHECK(report.invalid == 1);
  REQUIRE(report.invalid_elements.size() == 1);
  CHECK(report.invalid_elements[0].triangle == 5);
  CHECK(metric(report, "jacobian").min < 0);
  CHECK(metric(report, "jacobian").worst[0].triangle == 5);
  CHECK(metric(report, "shape").min < 0);
  CHECK(metric(report, "shape").histogram_low == -1);
  CHECK_FALSE(report.faults.empty());
  CHECK(report.area != sound);
}

TEST_CASE("a mesh without triangles has a report", "[quality]") {
  MeshData data;
  data.degree = 3;
  const QualityReport report = report_quality(data);
  CHECK(report.triangles == 0);
  CHECK(report.metrics.size() == 11);
  for (const MetricSummary& summary : report.metrics) {
    CHECK(std::isnan(summary.min));
    CHECK(summary.histogram.size() == 20);
    CHECK(std::isfinite(summary.histogram_low));
    CHECK(std::isfinite(summary.histogram_high));
  }
}
