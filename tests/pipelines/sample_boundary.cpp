// tests/pipelines/sample_boundary.cpp: writes a sample boundary: sample_boundary NAME DEGREE [WIDTHS [EXPONENT]], moved
// by so many widths along x and half as many along y, then multiplied by that power of two.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "formats/document/mesh_document.h"
#include "support/sample_boundaries.h"

int main(int argc, char** argv) {
  using namespace pliant;
  if (argc < 3) return 2;
  const int degree = std::atoi(argv[2]);
  const std::map<std::string, BoundaryComplex> all{
      {"cell", samples::one_cell(degree)},
      {"biconcave", samples::biconcave_cell(degree)},
      {"three", samples::three_cells(degree)},
      {"annulus", samples::annulus(degree)},
      {"interface", samples::interface(degree)},
      {"square", samples::square()},
      {"divided", samples::divided_square()},
      {"gear", samples::gear()},
      {"glyph", samples::glyph()},
      {"crescent", samples::crescent(0.3)},
  };
  const auto found = all.find(argv[1]);
  if (found == all.end()) {
    for (const auto& [name, boundary] : all) {
      int most = 1;
      for (const Curve& curve : boundary.curves) most = std::max(most, curve.spline.degree());
      std::printf("%s %d\n", name.c_str(), most);
    }
    return 2;
  }
  BoundaryComplex boundary = found->second;
  const double by = (argc > 3 ? std::atof(argv[3]) : 0) * bounding_box(boundary).size();
  const int exponent = argc > 4 ? std::atoi(argv[4]) : 0;
  const auto place = [&](const Point& p) { return std::ldexp(1.0, exponent) * (p + Point{by, by / 2}); };
  for (Point& vertex : boundary.vertices) vertex = place(vertex);
  for (Curve& curve : boundary.curves) {
    const BSpline& spline = curve.spline;
    std::vector<Point> points = spline.points();
    for (Point& p : points) p = place(p);
    curve.spline = BSpline(spline.degree(), spline.closed(), spline.knots(), std::move(points));
  }
  std::string text;
  write_boundary(boundary, text);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}
