// lib/pliant/boundary/boundary_complex.h: the input of a simulation: vertices, B-spline curves, faces (paper §7).
#pragma once
#include <string>
#include <vector>

#include "pliant/boundary/extra_members.h"
#include "pliant/geometry/point.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant {

inline constexpr int outside = -1;    ///< in place of a face
inline constexpr int no_vertex = -1;  ///< start and end of a closed curve

/// A region of the plane with a name.
struct Face {
  std::string name;
  ExtraMembers extra;
};

/// A B-spline and the faces that it separates. An open curve runs from vertex `start` to vertex `end`, whose positions
/// equal its end control points bit for bit.
struct Curve {
  std::string name;
  BSpline spline;
  int start = no_vertex;
  int end = no_vertex;
  int left = outside;        ///< face on the left, going along the curve
  int right = outside;       ///< face on the right
  double removal_error = 0;  ///< a bound of how far knot removals have moved the curve in all (length)
  ExtraMembers extra;
};

/// Vertices, curves and faces; also the geometry that every mesh carries along.
struct BoundaryComplex {
  std::vector<Point> vertices;
  std::vector<Face> faces;
  std::vector<Curve> curves;
  std::vector<int> cusps;  ///< vertices where two curves leave with tangent angle 0
  /// A length here, times `unit`, is one in the document: a power of two, 1 except for documents of extreme size
  /// (normalize_unit).
  double unit = 1;
  ExtraMembers extra;
};

/// Index of the face of that name, or `outside`.
int find_face(const BoundaryComplex& boundary, const std::string& name);

/// Raises every curve to `degree`; the multiplicities of its knots grow accordingly, and its shape stays.
/// Requires    no curve has a higher degree
void elevate_curves(BoundaryComplex& boundary, int degree);

/// The box of all control points and vertices.
Box bounding_box(const BoundaryComplex& boundary);

}  // namespace pliant
