// lib/pliant/improve/coarsening/local_feature_size.h: how far a curve is from its medial axis.
#pragma once
#include <vector>

#include "pliant/improve/coarsening/curve_chains.h"

namespace pliant {

/// The local feature size at the vertices on curves, by point slot; infinite elsewhere. It is the radius of the smaller
/// of the two disks that touch the curve there, one from each side, and reach as far as the next point of a curve: the
/// radius of curvature where a curve bends, half the gap where another stretch of a curve is near. Curves that meet do
/// not count for each other (Ruppert), nor do a curve's two stretches at a corner, and a curve's ends have no size of
/// their own. Measured between vertices and middles of spans.
/// Reference   Amenta, Bern, Eppstein, The crust and the beta-skeleton (the measure); Ma, Bae, Choi, 3D medial axis
///             point approximation using nearest neighbors and the normal field (how it is found)
/// Complexity  O(points on curves * log)
std::vector<double> local_feature_sizes(const Mesh& mesh, const std::vector<CurveChain>& chains);

}  // namespace pliant
