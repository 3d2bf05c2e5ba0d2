// lib/pliant/improve/smooth_curves.h: elements too curved, worst first (paper §5.3.4).
#pragma once
#include <optional>
#include <vector>

#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/improve/smoothing/unmended.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/refit_options.h"
#include "pliant/quality/too_curved.h"

namespace pliant {

/// Whether the outcome has the mesh as it was given, for a trial of another smoother.
enum class KeepInput { never, where_invalid, where_curved };

struct SmoothOptions {
  CurvatureBounds bounds;
  PlacementMeasure measure = PlacementMeasure::element;  ///< what optimal placement looks at
  bool vertices = false;  ///< also move vertices that are on no curve, where edges alone do not help
  bool flips = false;     ///< also flip edges of elements that are not valid
  // With either, straight triangles that are turned over are turned back where no element is worse for it.
  bool split = false;   ///< split constrained edges of elements that nothing else can mend
  int max_sweeps = 20;  ///< visits of one element
  RefitOptions refit;
  KeepInput keep_input = KeepInput::never;  ///< where elements are invalid, or too curved, by edges alone
  Progress* progress = nullptr;             ///< counts visits
};

struct SmoothOutcome {
  std::vector<TriangleId> invalid;        ///< elements left invalid or degenerate, ascending
  std::vector<UnmendedElement> unmended;  ///< elements left too curved, those among them, ascending
  std::optional<Mesh> input;              ///< the mesh as it was, by SmoothOptions::keep_input; fields are not kept
  std::vector<TriangleId>
      input_poor;  ///< elements of it: those that edges alone left too curved, then others, worst first
  PassReport report;
};

/// Visits the elements that are not fine, the worst first, by a priority queue on their excess (CurvatureTest). At a
/// visit each free edge in turn, and the inside of the element, gets new places for its control points, one after the
/// other: optimal placement from where they are, optimal placement by det J, or straightened by half or altogether.
/// Where none helps, edges are flipped (`flips`) or vertices moved with the edges around them (`vertices`); where that
/// does not help, small steps of the element's own points are tried.
///
/// A change is kept only if the list of the excesses of all elements that it touches, sorted from the worst, falls
/// lexicographically, by a hundredth at the first place where it differs (a twentieth where vertices move or after a
/// search); excesses below 0.8 count as 0.8, and what edges on curves turn by does not count (movable_excess). So the
/// sorted list of the whole mesh falls with every change, and no sweep makes the worst element worse; no valid element
/// becomes invalid unless another one becomes valid. An element is visited again when its excess has changed
/// by a hundredth, at most `max_sweeps` times after each of these beginnings. It ends when no visit finds a change to
/// keep.
///
/// Where edges alone leave elements invalid, vertices are moved and edges flipped for these elements whatever the
/// options say.
///
/// `vertices`, `flips` and `split` begin, in this order, where what came before has left elements too curved, and keep
/// a change only if neither the least shape nor the least scaled Jacobian of the mesh (LeastQuality) falls below what
/// it was at this beginning, and no more elements are invalid: an option more never leaves a worse mesh.
///
/// Edges and vertices on curves stay as they are, but for knots inserted by `split`. Fields: TrialPatch::apply, flips.
/// Elements may be invalid before; what is left invalid is told.
SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options = {});

}  // namespace pliant
