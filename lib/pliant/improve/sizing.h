#pragma once  // lib/pliant/improve/sizing.h: which size is wanted where
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
  double max_turning = HUGE_VAL;  ///< of an edge, radians
  double min_size = 0;            ///< no two vertices closer; 0: 1e-9 of the mesh's size

  double area_bound(FaceId f) const;
};
/// From the document's criteria; `size` is the compiled expression of criteria.size (empty if there is none).
QualityGoals goals_of(const Mesh& mesh, SizeFunction size);

}  // namespace pliant
