// tools/stages/ceres_smoother.h: the global smoother, for the programs that are to contain it.
#pragma once
#include "stages/global_smoother.h"

namespace pliant {

/// Null in builds without Ceres (-DPLIANT_CERES=OFF).
const GlobalSmoother* ceres_smoother();

}  // namespace pliant
