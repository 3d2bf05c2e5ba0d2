// lib/pliant/improve/global/minimize_deformation.h: the least deformation energy of some elements, by Ceres.
#pragma once
#include <span>

#include "pliant/improve/global/deformation_energy.h"
#include "pliant/improve/global/free_points.h"

namespace pliant {

struct MinimizeOptions {
  bool vertices = false;  ///< vertices move, too
  bool any_area = false;  ///< elements may have any area, but det J should be even
  double smoothing = 0;   ///< e of DeformationEnergy; 0: steps are taken only if every element stays certified valid
  int max_iterations = 60;
  double tolerance = 1e-4;  ///< stop when a step lowers the energy by less than this part of it
  bool direct = false;      ///< factor the normal equations; else conjugate gradients
};
struct MinimizeOutcome {
  double energy_before = 0, energy_after = 0;  ///< sums over the elements; NaN before where that is infinite
  int iterations = 0;                          ///< steps taken
};
/// Moves the free points that only these elements contain, by Levenberg and Marquardt's method with sparse linear
/// algebra, towards the least sum of the elements' deformation energies.
/// Shapes      a wanted shape for each element
/// Ensures     the energy is not greater than before; with smoothing 0 all elements are valid if they were
MinimizeOutcome minimize_deformation(FreePoints& points, std::span<const TriangleId> elements,
                                     std::span<const WantedShape> wanted, const MinimizeOptions& options);

}  // namespace pliant
