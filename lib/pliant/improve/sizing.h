// lib/pliant/improve/sizing.h: the goals of refinement and coarsening: which sizes and shapes are wanted where.
#pragma once
#include <functional>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The wanted length of edges at a place and at a time (Mesh::time).
using SizeFunction = std::function<double(const Point&, double time)>;

/// The criteria of refine and coarsen in the form that the passes use. Lengths and areas are in the unit of the mesh,
/// min_angle in degrees, max_turning in radians.
struct QualityGoals {
  double min_angle = 20.7;        ///< the least angle of a logical triangle; 0: no such goal
  double max_area = HUGE_VAL;     ///< the largest area of an element
  std::vector<double> face_area;  ///< the same for each face; HUGE_VAL where there is no bound
  SizeFunction size;              ///< wanted lengths; empty: no such goal
  int size_field = none;          ///< a field of one component with wanted lengths; no bound where it is not above 0
  double max_turning = HUGE_VAL;  ///< the largest angle by which an edge on a curve may turn
  double resolution = HUGE_VAL;   ///< the greatest resolution error of a span of a curve (BSpline)
  double min_size = 0;            ///< the least distance of two vertices; 0: 1e-9 of the mesh's size
  bool keeps_thin = false;        ///< triangles that cross a thin gap (thin_gaps.h) do not count as poor

  /// The bound on the area of the elements of a face.
  double area_bound(FaceId f) const;
  /// Does any face have a bound on area?
  bool bounds_area() const;
  /// The mean length of edges that refinement to the bound on area ends with; infinite without a bound.
  double length_for_area(FaceId f) const;
  /// The length that `size` asks for at a place; infinite where it asks for none.
  double length_at(const Point& p, double time) const;
  /// The length that `size_field` asks for at a corner of a triangle; infinite where it asks for none.
  double length_by_field(const Mesh& mesh, TriangleId t, int corner) const;
  /// The same at a vertex, seen from a face around it.
  double length_by_field_at(const Mesh& mesh, PointId v, FaceId f) const;
};
/// The goals that the criteria of a mesh document state; `size` is the compiled expression of criteria.size, empty if
/// there is none.
///
/// Units       the criteria, `size` and the values of the size field are in the document's unit, the goals in the
/// mesh's Throws      std::invalid_argument where criteria.size_field names no field of one component
QualityGoals goals_of(const Mesh& mesh, SizeFunction size);
/// The same where the criteria have no size expression: what passes go by whose options have no goals.
/// Throws      std::invalid_argument where they have one, whose function only the caller can know
QualityGoals goals_of(const Mesh& mesh);

/// Throws std::invalid_argument, with the place, where `size`, in units of the document, is no length at a vertex: it
/// must be above zero; infinite asks for nothing.
void require_lengths(const Mesh& mesh, const SizeFunction& size);

}  // namespace pliant
