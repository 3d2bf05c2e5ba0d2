// lib/pliant/improve/global/smooth_globally.h: all free control points at once, towards the least deformation energy.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct GlobalSmoothOptions {
  bool vertices = false;             ///< inner vertices move, too
  double good = 0.999;               ///< elements with a scaled Jacobian above this, and away from worse ones, stay
  int rings = 3;                     ///< how many rings of elements around worse ones move with them
  std::span<const TriangleId> only;  ///< unless empty: only these, and the rings around them, may move
  RefitOptions refit;
  Progress* progress = nullptr;  ///< told the steps of the minimisation
};
struct GlobalSmoothOutcome {
  std::vector<TriangleId> invalid;   ///< elements left invalid, ascending (numbers in the compacted mesh)
  std::vector<TriangleId> elements;  ///< those whose points could move, ascending (numbers before)
  PassReport report;
};

/// Moves the control points of unconstrained edges and those inside elements so that the sum of the elements'
/// deformation energies (see DeformationEnergy) is least, each against the straight triangle on its vertices (a thicker
/// one where that is flat or inverted), of any area. With `vertices` inner vertices move first, each element against an
/// equilateral triangle of the mean area around it.
///
/// Elements that are not valid come first, with those around them: there the energy is smoothed, ever less, until all
/// are valid; what cannot be untangled so stays as it is, and `invalid` names it. Then all of them, with the energy
/// itself: a step that would leave an element without its certificate is not taken. Points on curves stay bit for bit.
/// A mesh in which every element is good is left bit for bit.
/// Fields are refitted, with their integrals where all elements around the points that move together are valid.
/// Complexity  some ten steps of Gauss and Newton's method by conjugate gradients, each O(elements): with vertices
/// fixed
///             their number does not grow with the mesh
GlobalSmoothOutcome smooth_globally(Mesh& mesh, const GlobalSmoothOptions& options = {});

}  // namespace pliant
