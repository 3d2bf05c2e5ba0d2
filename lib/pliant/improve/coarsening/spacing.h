// lib/pliant/improve/coarsening/spacing.h: the sizing function of coarsening at the vertices (paper §5.3.3).
#pragma once
#include <vector>

#include "pliant/improve/coarsening/curve_chains.h"
#include "pliant/improve/coarsening/vertex_graph.h"
#include "pliant/improve/sizing.h"

namespace pliant {

/// Whether coarsening may remove a vertex, and how.
enum class VertexRole : char {
  inner,  ///< on no curve
  curve,  ///< in the interior of one curve
  kept    ///< not removed: a curve ends there, several curves pass, or a curve's shape needs it
};

/// The role of each vertex, by point slot. A vertex is `kept` where a curve ends or several curves pass, where it
/// belongs to no curve but to the boundary complex, and where Douglas and Peucker's method with `polygon_tolerance` (0:
/// not used) keeps a control point whose support contains its knot.
///
/// Complexity  O(triangles + n log n) with n control points
std::vector<VertexRole> vertex_roles(const Mesh& mesh, const std::vector<CurveChain>& chains, double polygon_tolerance);

/// The wanted length of edges at each vertex, by its number in the graph: the least of what the goals ask for by size
/// and area, of `bounds` (by the same number), and at `kept` vertices of the distance of the next kept ones along their
/// curves. Then it is made Lipschitz: along an edge it grows by at most `gradation` times the edge's length. It is at
/// most the size of the mesh.
///
/// Complexity  O(n log n) with n vertices
std::vector<double> wanted_spacing(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                   const std::vector<VertexRole>& roles, const QualityGoals& goals,
                                   std::vector<double> bounds, double gradation);

}  // namespace pliant
