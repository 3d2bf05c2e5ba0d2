// lib/pliant/improve/coarsening/curve_chains.h: the vertices on each curve, in its order.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The vertices of one curve, and the breaks at which they stand. Both ends of an open curve are among them; the first
/// vertex of a closed curve is not repeated at the end.
struct CurveChain {
  std::vector<double> breaks;
  std::vector<PointId> vertices;
  bool closed = false;
};

/// The chain of each curve.
///
/// Complexity  O(triangles + n log n) with n edges on curves
std::vector<CurveChain> curve_chains(const Mesh& mesh);

}  // namespace pliant
