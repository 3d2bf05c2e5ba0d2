// lib/pliant/improve/coarsening/local_feature_size.h: how far a curve is from its medial axis: the local feature size.
#pragma once
#include <vector>

#include "pliant/improve/coarsening/curve_chains.h"

namespace pliant {

/// The local feature size at the vertices on curves, by point slot; infinite at all others.
///
/// Two disks touch a curve at a point, one from each side, and reach as far as the next point of a curve. The radius of
/// the smaller one is the local feature size: the radius of curvature where a curve bends, half the gap where another
/// stretch of a curve is near. Curves that meet do not count for each other (Ruppert), nor do the two stretches of a
/// curve at a corner; the ends of a curve have no size of their own. Curves are sampled at vertices and at the middles
/// of spans.
///
/// Reference   Amenta, Bern, Eppstein, The crust and the beta-skeleton (the measure); Ma, Bae, Choi, 3D medial axis
///             point approximation using nearest neighbors and the normal field (how it is found)
/// Complexity  O(n log n) with n samples
std::vector<double> local_feature_sizes(const Mesh& mesh, const std::vector<CurveChain>& chains);

}  // namespace pliant
