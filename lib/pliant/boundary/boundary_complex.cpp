// lib/pliant/boundary/boundary_complex.cpp: the input of a simulation: vertices, B-spline curves, faces (paper §7).
#include "pliant/boundary/boundary_complex.h"

#include <cassert>

namespace pliant {

int find_face(const BoundaryComplex& boundary, const std::string& name) {
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    if (boundary.faces[f].name == name) return static_cast<int>(f);
  return outside;
}

void elevate_curves(BoundaryComplex& boundary, int degree) {
  for (Curve& curve : boundary.curves) {
    assert(curve.spline.degree() <= degree);
    while (curve.spline.degree() < degree) curve.spline = curve.spline.elevated();
  }
}

Box bounding_box(const BoundaryComplex& boundary) {
  Box box;
  for (const Point& p : boundary.vertices) box.extend(p);
  for (const Curve& curve : boundary.curves)
    for (const Point& p : curve.spline.points()) box.extend(p);
  return box;
}

}  // namespace pliant
