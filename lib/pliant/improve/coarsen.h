// lib/pliant/improve/coarsen.h: removes vertices that neither sizes nor the geometry need (paper §5.3.3).
#pragma once
#include <optional>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct CoarsenOptions {
  std::optional<QualityGoals> goals;  ///< absent: those of the mesh's criteria (goals_of)
  /// Bound of each curve's accumulated error of knot removal (length). Absent: 1e-3 of the mesh's size; none where the
  /// goals have a resolution.
  std::optional<double> tolerance;
  /// Bound of the error of one removal (length); absent: a tenth of `tolerance`, at most the resolution of the goals.
  std::optional<double> step_tolerance;
  double polygon_tolerance = 0;  ///< tolerance of Douglas and Peucker's method, which picks the control points that
                                 ///< a curve's shape needs (length); 0: no vertex is kept for that
  double feature_share = 0;      ///< wanted lengths are at most this share of the local feature size; 0: no such bound
  double factor = 1.0;           ///< scales the spheres of the sizing function
  bool keep_area = false;        ///< removals keep the area enclosed by their curve
  RefitOptions refit;
  bool uses_forecast = true;  ///< false (for tests): every removal is tried on the mesh itself
};

/// Removes vertices in rounds. A round chooses the vertices that stay: those that the curves' geometry needs, and a
/// maximal set of others whose spheres are disjoint. The radius of a vertex's sphere is the wanted length of edges
/// there (the bounds on size, made Lipschitz), scaled. All other vertices are *slated*, and removed one by one.
///
/// A removal is refused
/// - where it leaves a triangle that `refine` with the same goals would attack, and did not before. First the slated
///   corners of such a triangle are removed with it, as many as it takes; if that does not help, all are rolled back.
/// - where it lowers the least shape of the elements that it touches below what is accepted (removal_chain.h), or below
///   half of what that was.
/// Most refusals are foretold (removal_forecast.h), or remembered from an earlier round. Vertices whose removal was
/// refused are chosen first in the next round.
///
/// A triangle that refine had given up may become one that it can mend when vertices around it go. Vertices that allow
/// that are kept, too: so coarsen and refine never undo each other's work again and again.
///
/// With bounds on size about 4/sqrt(3) times the integral of 1/length² triangles are left.
///
/// Complexity  a round takes 0.5 µs for each triangle to choose, about 1 µs for each vertex tried, 10 to 20 µs for each
///             one removed. Another round follows where one has removed at least a vertex in 1,000 triangles. Where
///             elements are left that refine would attack, the time of refine on copies is added
/// Throws      std::invalid_argument as goals_of
PassReport coarsen(Mesh& mesh, const CoarsenOptions& options = {});

}  // namespace pliant
