// lib/pliant/improve/smooth_curves.h: mends elements that are too curved, the worst first (paper §5.3.4).
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

/// When the outcome is to contain a copy of the mesh as it was given, so that another smoother can be tried on it:
/// where edges alone leave elements invalid, or too curved.
enum class KeepInput { never, where_invalid, where_curved };

struct SmoothOptions {
  CurvatureBounds bounds;
  PlacementMeasure measure = PlacementMeasure::element;  ///< what optimal placement maximises
  bool vertices = false;  ///< vertices that are on no curve may move, too, where edges alone do not help
  bool flips = false;     ///< edges of elements that are not valid may be flipped
  // With either of the two, logical triangles that are turned over are turned back where that makes no element worse.
  bool split = false;   ///< edges on curves of elements that nothing else can mend may be split
  int max_sweeps = 20;  ///< the most visits of one element
  RefitOptions refit;
  KeepInput keep_input = KeepInput::never;
  Progress* progress = nullptr;  ///< is told how many visits were made
};

struct SmoothOutcome {
  std::vector<TriangleId> invalid;        ///< elements left invalid or degenerate, ascending
  std::vector<UnmendedElement> unmended;  ///< elements left too curved, the invalid ones included, ascending
  std::optional<Mesh> input;              ///< the mesh as it was given, by keep_input; its fields are not kept
  /// The elements of `input` that were too curved: first those that edges alone left so, then the others, worst first.
  std::vector<TriangleId> input_poor;
  PassReport report;
};

/// Visits the elements that are too curved, the worst first, by a priority queue on their excess (CurvatureTest).
///
/// A visit tries new places for the control points of each free edge and of the inside of the element: straightened by
/// half or altogether, optimal placement from where they are, optimal placement by det J. Where that does not help,
/// edges are flipped (`flips`) and vertices moved with the edges around them (`vertices`). Where nothing has changed,
/// a search moves the element's own points by small steps.
///
/// A change is kept only if it lowers the list of excesses of all elements that it touches. The lists are sorted from
/// the worst and compared lexicographically. At the first place where they differ the new excess must be lower by a
/// hundredth (by a twentieth where vertices move or after a search of a valid element). Excesses below 0.8 count as
/// 0.8, and the angle by which an edge on a curve turns does not count (movable_excess). So the sorted list of the
/// whole mesh falls with every change, the worst element never gets worse, and no valid element becomes invalid unless
/// another one becomes valid.
///
/// An element is visited again when its excess has changed by a hundredth. The work ends when no visit finds a change
/// to keep, or with `max_sweeps` visits of each element.
///
/// Where edges alone leave elements invalid, vertices are moved and edges flipped for these elements, whatever the
/// options say. Then `vertices`, `flips` and `split` are allowed one after the other, each for the elements that the
/// ones before it have left too curved; visits are counted anew. An option keeps a change only if neither the least
/// shape nor the least scaled Jacobian of the mesh (LeastQuality) falls below what it was when the option began, and no
/// more elements are invalid. So a further option never leaves a worse mesh.
///
/// Elements may be invalid at first; the outcome names those that stay so. Edges and vertices on curves stay as they
/// are, except that `split` inserts knots. Fields are refitted as TrialPatch::apply and flips do.
SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options = {});

}  // namespace pliant
