// lib/pliant/improve/coarsen.h: remove vertices that neither size nor geometry needs (paper §5.3.3).
#pragma once
#include <optional>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct CoarsenOptions {
  std::optional<QualityGoals> goals;  ///< absent: those of the mesh's criteria (goals_of)
  /// Bound of each curve's accumulated knot-removal error (length); absent: 1e-3 of the mesh's size.
  std::optional<double> tolerance;
  std::optional<double> step_tolerance;  ///< bound of the error of one removal (length); absent: a tenth of `tolerance`
  double polygon_tolerance = 0;  ///< Douglas-Peucker on the control polygons (length); 0: geometry does not decide
  double feature_share = 0;      ///< no length above this part of the local feature size; 0: not asked
  double factor = 1.0;           ///< scales the spheres of the sizing function
  bool keep_area = false;        ///< removals keep the area enclosed by their curve
  RefitOptions refit;
  bool uses_forecast = true;  ///< false: every removal is tried on the mesh itself; for tests
};

/// Removes vertices: the wanted spacing (size bounds, made Lipschitz) chooses a maximal set with disjoint spheres that
/// is kept, beside what the curves' geometry needs; the others are slated and removed one by one. Where a removal
/// leaves a triangle which `refine` with the same goals would attack, slated corners of it go with it, as many as it
/// takes; if that does not help all of it is rolled back, and vertices stay whose removal would let refine succeed on
/// what it had left: so that the two never chase each other. No removal lowers the least shape of what it touches below
/// what is accepted (removal_chain.h), nor below half of what it was. What stayed so is chosen first in another round.
/// Most refusals are foretold (removal_forecast.h), or remembered from the round before.
///
/// Complexity   a round: 0.5 µs a triangle to choose, about 1 µs for each vertex tried, 10 to 20 µs for each removed;
///              another follows where one has removed more than a vertex in 1,000 triangles, or in small meshes any.
///              Where elements are left that refine would attack: refine's on a copy, too
///
/// With bounds on size some (4/sqrt(3)) times the integral of 1/length² triangles are
/// left.
///
/// Throws       std::invalid_argument as goals_of
PassReport coarsen(Mesh& mesh, const CoarsenOptions& options = {});

}  // namespace pliant
