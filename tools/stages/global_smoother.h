// tools/stages/global_smoother.h: the global smoother as the stage smoothcurves uses it, if its program has one.
#pragma once
#include <string>

#include "pliant/improve/global/smooth_globally.h"
#include "pliant/improve/smooth_curves.h"

namespace pliant {

/// The global smoother stands on Ceres, which not every program is to contain: so the stage does not name its functions
/// but gets them.
struct GlobalSmoother {
  /// Smooths all inner control points at once.
  SmoothOutcome (*smooth)(Mesh& mesh, const GlobalSmoothOptions& options);
  /// A sentence, if --global would have made a better mesh of the input than local smoothing has: fewer elements
  /// invalid, or as many, neither the least shape nor the least scaled Jacobian lower, and one of them higher. It is
  /// tried: small meshes as a whole, of large ones what was too curved and the rings around it. Else empty, as where
  /// the outcome has no input.
  std::string (*advice)(SmoothOutcome& outcome, const Mesh& result, bool vertices);
  const char* licence;  ///< of programs that contain it
};

}  // namespace pliant
