// lib/pliant/improve/coarsening/independent_set.h: which vertices coarsening keeps (Talmor; Miller et al.; §5.3.3).
#pragma once
#include <vector>

#include "pliant/improve/coarsening/spacing.h"

namespace pliant {

/// Chooses, by wanted lengths (by number in the graph), a maximal set of vertices in which no inner vertex is closer to
/// another one than 0.8 `factor` times the mean of the two wanted lengths. Returns for each point slot whether it was
/// chosen. The order of choice:
/// - all `kept` vertices, and between them along each curve as many as the wanted lengths ask for, as even as possible;
/// - the `preferred` inner vertices, where they are not too close to each other or to the ones before;
/// - the other inner vertices, from the chosen ones outward. The vertex nearest to what is chosen already comes first,
///   which packs them densely and evenly.
///
/// Reference   Talmor, Well-spaced points for numerical methods; Miller, Talmor, Teng, Optimal coarsening of
///             unstructured meshes
/// Complexity  O(V log V) with V vertices, plus the vertices in all spheres
std::vector<bool> independent_set(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                  const std::vector<VertexRole>& roles, const std::vector<double>& spacing,
                                  const std::vector<PointId>& preferred, double factor);

}  // namespace pliant
