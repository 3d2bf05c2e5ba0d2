// lib/pliant/mesh/documents/document_unit.cpp: the power of two by which a document is scaled, and scaling that loses
// no digit.
#include "pliant/mesh/documents/document_unit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr int tame_exponent = 60;  // documents of size 2^-60 to 2^60 stay: no product in use leaves the doubles there

/// The larger of width and height: unlike the diagonal it does not round, so a power of two changes it exactly.
double extent(const Box& box) {
  return box.low.x <= box.high.x ? std::max(box.high.x - box.low.x, box.high.y - box.low.y) : 0;
}

double extent_of(const MeshData& data) {
  Box box = bounding_box(data.boundary);
  for (const Point& p : data.points) box.extend(p);
  return extent(box);
}

/// The power of two by which the lengths of a document of this size are multiplied.
double factor_for(double size) {
  if (size == 0) return 1;
  if (!(size >= least_document_size && size <= greatest_document_size))
    throw InputError(
        "", "the size of the document is " + (std::isfinite(size) ? describe_number(size) : "above 1e308") +
                "; sizes from " + describe_number(least_document_size, 1e-3 * least_document_size) + " (2^-510) to " +
                describe_number(greatest_document_size, 1e-3 * greatest_document_size) + " (2^510) are supported");
  const int exponent = std::ilogb(size);
  return std::abs(exponent) <= tame_exponent ? 1 : std::ldexp(1.0, -exponent);
}

void scale(Point& p, double factor) { p *= factor; }

void scale(BoundaryComplex& boundary, double factor) {
  for (Point& p : boundary.vertices) scale(p, factor);
  for (Curve& curve : boundary.curves) {
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
    curve.removal_error *= factor;
  }
  boundary.unit /= factor;
}

/// Throws if scaling a coordinate and scaling it back would not give the same number.
void require_exact(const Point& p, double factor, double size, const std::string& array, std::size_t index) {
  const auto is_exact = [factor](double x) { return x * factor / factor == x; };
  if (is_exact(p.x) && is_exact(p.y)) return;
  const bool is_x = !is_exact(p.x);
  throw InputError(array + "/" + std::to_string(2 * index + (is_x ? 0 : 1)),
                   "is " + describe_number(is_x ? p.x : p.y) + " in a document of size " + describe_number(size) +
                       "; beside that size coordinates of at least " +
                       describe_number(std::ldexp(size, -1000), 1e-3 * std::ldexp(size, -1000)) +
                       " are supported, and 0");
}

void require_exact(const BoundaryComplex& boundary, double factor, double size, const std::string& pointer) {
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
    require_exact(boundary.vertices[v], factor, size, pointer + "/vertices", v);
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const std::vector<Point>& points = boundary.curves[c].spline.points();
    for (std::size_t i = 0; i < points.size(); ++i)
      require_exact(points[i], factor, size, pointer + "/curves/" + std::to_string(c) + "/points", i);
  }
}

}  // namespace

void require_document_size(const MeshData& data) { factor_for(extent_of(data)); }

bool has_tame_size(const Mesh& mesh) {
  Box box = bounding_box(mesh.boundary());
  box.extend(mesh.measured_box().low);
  box.extend(mesh.measured_box().high);
  return factor_for(extent(box)) == 1;
}

void normalize_unit(MeshData& data) {
  const double size = extent_of(data), factor = factor_for(size);
  if (factor == 1) return;
  for (std::size_t p = 0; p < data.points.size(); ++p) require_exact(data.points[p], factor, size, "/points", p);
  require_exact(data.boundary, factor, size, "/boundary");
  for (Point& p : data.points) scale(p, factor);
  scale(data.boundary, factor);
}

void normalize_unit(BoundaryComplex& boundary) {
  const double size = extent(bounding_box(boundary)), factor = factor_for(size);
  if (factor == 1) return;
  require_exact(boundary, factor, size, "");
  scale(boundary, factor);
}

void restore_unit(MeshData& data) {
  const double unit = data.boundary.unit;
  if (unit == 1) return;
  for (Point& p : data.points) {
    scale(p, unit);
    if (!is_finite(p)) throw std::domain_error("the result is too large: coordinates leave the range of doubles");
  }
  restore_unit(data.boundary);
}

void restore_unit(BoundaryComplex& boundary) {
  if (boundary.unit != 1) scale(boundary, boundary.unit);
}

void restore_unit(PassReport& report, double unit) {
  if (unit == 1) return;
  report.resolution *= unit;
  for (const std::size_t k : report.lengths) report.values[k].second *= unit;
  for (RefusedAt& refused : report.refused_at) scale(refused.place, unit);
}

}  // namespace pliant
