// lib/pliant/improve/sizing.h: which size is wanted where.
#pragma once
#include <functional>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Wanted edge length at a place and time (the mesh's time).
using SizeFunction = std::function<double(const Point&, double time)>;

/// The criteria of refine and coarsen in the form that the passes use: lengths and areas in mesh units, angle in
/// degrees.
struct QualityGoals {
  double min_angle = 20.7;        ///< least angle of a logical triangle, degrees; 0: do not ask
  double max_area = HUGE_VAL;     ///< of an element
  std::vector<double> face_area;  ///< by face: HUGE_VAL where not bounded
  SizeFunction size;              ///< empty: not asked
  int size_field = none;          ///< a field of wanted edge lengths, one component; no bound where not above 0
  double max_turning = HUGE_VAL;  ///< of an edge, radians
  double min_size = 0;            ///< no two vertices closer; 0: 1e-9 of the mesh's size
  bool keeps_thin = false;        ///< what crosses a thin gap (thin_gaps.h) does not count as poor

  double area_bound(FaceId f) const;
  bool bounds_area() const;  ///< of some face
  /// The length of edges at which refinement to the bound on area ends, on average; infinite without a bound.
  double length_for_area(FaceId f) const;
  /// What `size` asks for at a place; infinite where nothing is asked.
  double length_at(const Point& p, double time) const;
  /// What `size_field` asks for at a corner of a triangle; infinite where nothing is asked.
  double length_by_field(const Mesh& mesh, TriangleId t, int corner) const;
  /// The same at a vertex, seen from a face around it.
  double length_by_field_at(const Mesh& mesh, PointId v, FaceId f) const;
};
/// From the document's criteria; `size` is the compiled expression of criteria.size (empty if there is none). Both, and
/// the values of the size field, are in the document's units; the goals are in those of the mesh.
/// Throws      std::invalid_argument where criteria.size_field names no field of one component
QualityGoals goals_of(const Mesh& mesh, SizeFunction size);
/// The same where the criteria have no size expression: what passes go by whose options have no goals.
/// Throws      std::invalid_argument where they have one, whose function only the caller can know
QualityGoals goals_of(const Mesh& mesh);

/// Throws std::invalid_argument, with the place, where `size`, in units of the document, is no length at a vertex: it
/// must be above zero; infinite asks for nothing.
void require_lengths(const Mesh& mesh, const SizeFunction& size);

}  // namespace pliant
