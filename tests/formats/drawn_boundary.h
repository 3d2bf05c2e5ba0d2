// tests/formats/drawn_boundary.h: small drawings as text, and areas and spans of the boundaries that are read from
// them.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "formats/svg_import/svg_reader.h"
#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/check_boundary.h"

namespace pliant::samples {

inline std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " + attributes + ">" +
         content + "</svg>";
}
inline std::string path(const std::string& d) { return svg("<path d='" + d + "'/>"); }

inline SvgImport read(const std::string& document, SvgReadOptions options = {}) {
  SvgImport import = read_svg(document, options);
  CHECK(check_boundary(import.boundary).empty());
  CHECK(check_boundary_geometry(import.boundary).empty());
  return import;
}

inline double face_area(const BoundaryComplex& boundary, int face) {
  double sum = 0;
  for (const Curve& curve : boundary.curves) {
    if (curve.left == face) sum += curve.spline.area();
    if (curve.right == face) sum -= curve.spline.area();
  }
  return sum;
}
inline double face_area(const BoundaryComplex& boundary, const std::string& name) {
  const int face = find_face(boundary, name);
  INFO(name);
  REQUIRE(face != outside);
  return face_area(boundary, face);
}
inline double area(const std::string& document, SvgReadOptions options = {}) {
  const SvgImport import = read(document, options);
  double sum = 0;
  for (std::size_t f = 0; f < import.boundary.faces.size(); ++f) sum += face_area(import.boundary, static_cast<int>(f));
  return sum;
}

/// All control points of all Bézier spans.
inline std::vector<std::vector<Point>> spans_of(const BoundaryComplex& boundary) {
  const BoundarySpans spans(boundary);
  std::vector<std::vector<Point>> out;
  for (std::size_t i = 0; i < spans.size(); ++i) out.emplace_back(spans.polygon(i).begin(), spans.polygon(i).end());
  return out;
}
inline bool has_span(const BoundaryComplex& boundary, const std::vector<Point>& polygon) {
  for (const auto& span : spans_of(boundary))
    if (span == polygon) return true;
  return false;
}

/// The greatest value of `off` at points on the curves; `off` is the distance from the true outline.
template <class Off>
double worst(const BoundaryComplex& boundary, const Off& off) {
  double most = 0;
  for (const Curve& curve : boundary.curves) {
    const double first = curve.spline.first_parameter(), period = curve.spline.period();
    for (int i = 0; i <= 4000; ++i)
      most = std::max(most, std::abs(off(curve.spline.evaluate(first + period * i / 4000))));
  }
  return most;
}

}  // namespace pliant::samples
