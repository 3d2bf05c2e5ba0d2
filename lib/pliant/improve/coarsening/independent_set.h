// lib/pliant/improve/coarsening/independent_set.h: which vertices coarsening keeps (Talmor; Miller et al.; §5.3.3).
#pragma once
#include <vector>

#include "pliant/improve/coarsening/spacing.h"

namespace pliant {

/// By point slot, true for a maximal set of vertices of which no two inner ones are closer than 0.8 `factor` times the
/// mean of their wanted lengths, and no inner one is that close to another. All `kept` ones belong to it; between them,
/// along each curve, as many as the wanted lengths ask for, as even as they can be; then the inner ones, from those
/// outward: the nearest to what is chosen already comes first, which packs them densely and evenly. Before all these
/// come the `preferred` inner ones, where they are not too close to each other.
///
/// Reference   Talmor, Well-spaced points for numerical methods; Miller, Talmor, Teng, Optimal coarsening of
///             unstructured meshes
/// Complexity  O(V log V + the vertices in all spheres)
std::vector<bool> independent_set(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                  const std::vector<VertexRole>& roles, const std::vector<double>& spacing,
                                  const std::vector<PointId>& preferred, double factor);

}  // namespace pliant
