// lib/pliant/improve/global/minimize_deformation.h: lowers the deformation energy of some elements, by Ceres.
#pragma once
#include <span>

#include "pliant/improve/global/deformation_energy.h"
#include "pliant/improve/global/free_points.h"

namespace pliant {

struct MinimizeOptions {
  bool vertices = false;  ///< vertices move, too
  bool any_area = false;  ///< elements may have any area; only how uneven det J is counts
  double smoothing = 0;   ///< the e of DeformationEnergy; with 0 no step may leave an element without certificate
  int max_iterations = 60;
  double tolerance = 1e-4;  ///< the last step lowers the energy by less than this share of it
  bool direct = false;      ///< the normal equations are factored; else solved by conjugate gradients
};
struct MinimizeOutcome {
  double energy_before = 0, energy_after = 0;  ///< sums over the elements; NaN if the first is infinite
  int iterations = 0;                          ///< steps taken
};
/// Moves the free points that no other elements contain, by Levenberg and Marquardt's method, so that the sum of the
/// deformation energies of these elements falls to a minimum.
///
/// Shapes      `wanted` has a shape for each element
/// Ensures     the energy is not greater than before; with smoothing 0 all elements are valid if they were
MinimizeOutcome minimize_deformation(FreePoints& points, std::span<const TriangleId> elements,
                                     std::span<const WantedShape> wanted, const MinimizeOptions& options);

}  // namespace pliant
