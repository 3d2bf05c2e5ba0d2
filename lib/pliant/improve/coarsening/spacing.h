// lib/pliant/improve/coarsening/spacing.h: the sizing function of coarsening at the vertices (paper §5.3.3).
#pragma once
#include <vector>

#include "pliant/improve/coarsening/curve_chains.h"
#include "pliant/improve/coarsening/vertex_graph.h"
#include "pliant/improve/sizing.h"

namespace pliant {

/// What a vertex is to coarsening.
enum class VertexRole : char {
  inner,  ///< on no curve
  curve,  ///< passed by one curve
  kept    ///< a curve's end, where several meet, or needed by geometry
};

/// By point slot. A vertex is `kept` where it ends a curve or several pass, and where the curve's control polygon needs
/// its knot to stay within `polygon_tolerance` (Douglas and Peucker; 0: not asked): where a control point next to the
/// knot is kept.   Complexity O(mesh + control points * log)
std::vector<VertexRole> vertex_roles(const Mesh& mesh, const std::vector<CurveChain>& chains, double polygon_tolerance);

/// The wanted length of edges at each vertex, by point slot: what the goals' bounds on size and area ask for, at most
/// `bounds` (by point slot; empty: none), at `kept` vertices at most the distance of the next ones along their curves.
/// Then made Lipschitz: it grows by at most `gradation` times the distance, along edges. Where nothing bounds it, the
/// mesh's size.   Complexity O(mesh * log)
std::vector<double> wanted_spacing(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                   const std::vector<VertexRole>& roles, const QualityGoals& goals,
                                   const std::vector<double>& bounds, double gradation);

}  // namespace pliant
