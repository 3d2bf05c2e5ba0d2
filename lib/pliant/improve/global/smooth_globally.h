// lib/pliant/improve/global/smooth_globally.h: moves all free control points at once, to lower the deformation energy.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct GlobalSmoothOptions {
  bool vertices = false;  ///< inner vertices move, too
  double good = 0.999;    ///< elements with a scaled Jacobian above this stay, if they are not near worse ones
  int rings = 3;          ///< how many rings of elements around worse ones move with these
  std::span<const TriangleId> only;  ///< unless empty: only these elements, and the rings around them, may move
  RefitOptions refit;
  Progress* progress = nullptr;  ///< is told how many steps were taken
};
struct GlobalSmoothOutcome {
  std::vector<TriangleId> invalid;   ///< elements left invalid, ascending, by their numbers afterwards
  std::vector<TriangleId> elements;  ///< elements whose points could move, ascending, by their numbers before
  PassReport report;
};

/// Moves the control points of unconstrained edges and those inside elements so that the sum of the deformation
/// energies (DeformationEnergy) is least. Each element is compared with its logical triangle, or with a thicker one
/// where that is flat or inverted; its area does not count. With `vertices`, inner vertices move, too, in a first pass
/// in which each element is compared with an equilateral triangle of the mean area around it.
///
/// Invalid elements and those around them come first. Their energy is smoothed, ever less, until all are valid. What
/// cannot be untangled by that stays as it is, and `invalid` names it. Then all elements are improved by the energy
/// itself; a step that would leave an element without its certificate is not taken.
///
/// Points on curves stay bit for bit, and so does a mesh in which every element is good. Fields are refitted. Their
/// integrals are kept where all elements around the points that move together are valid.
///
/// Complexity  some ten Gauss-Newton steps by conjugate gradients, each O(elements); with vertices fixed the number of
///             steps does not grow with the mesh
GlobalSmoothOutcome smooth_globally(Mesh& mesh, const GlobalSmoothOptions& options = {});

}  // namespace pliant
