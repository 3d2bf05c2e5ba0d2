// lib/pliant/improve/coarsening/curve_chains.h: the vertices on each curve, in its order.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The vertices of one curve and the breaks at which they stand, both ends of an open curve too; a closed curve's
/// first vertex is not repeated.
struct CurveChain {
  std::vector<double> breaks;
  std::vector<PointId> vertices;
  bool closed = false;
};

/// By curve.   Complexity O(mesh + edges on curves * log)
std::vector<CurveChain> curve_chains(const Mesh& mesh);

}  // namespace pliant
