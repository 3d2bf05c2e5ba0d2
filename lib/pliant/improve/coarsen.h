#pragma once  // lib/pliant/improve/coarsen.h: remove vertices that neither size nor geometry needs (paper §5.3.3)
#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/outcome.h"

namespace pliant {

struct CoarsenOptions {
  QualityGoals goals;
  double tolerance = HUGE_VAL;       ///< bound of each curve's accumulated knot-removal error (length)
  double step_tolerance = HUGE_VAL;  ///< bound of the error of one removal (length)
  double polygon_tolerance = 0;      ///< Douglas-Peucker on the control polygons (length); 0: geometry does not decide
  double factor = 1.0;               ///< scales the spheres of the sizing function
  bool keep_area = false;            ///< removals keep the area enclosed by their curve
  RefitOptions refit;
};

/// Removes vertices: the wanted spacing (size bounds, made Lipschitz) chooses a maximal set with disjoint spheres that
/// is kept, beside what the curves' geometry needs; the others are removed one by one. A removal that leaves a triangle
/// which `refine` with the same goals would attack is rolled back, so that the two never chase each other.
PassReport coarsen(Mesh& mesh, const CoarsenOptions& options);

}  // namespace pliant
