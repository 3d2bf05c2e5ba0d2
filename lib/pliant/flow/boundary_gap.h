// lib/pliant/flow/boundary_gap.h: the thinnest gap between the curved boundaries in a mesh.
#pragma once
#include <optional>
#include <span>
#include <string>

#include "pliant/boundary/least_gap.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// A gap between two constrained edges (find_least_gap says what a gap is).
struct BoundaryGap {
  double distance;              ///< in lengths of the mesh (times boundary().unit: of the document)
  Point place, other;           ///< the two places that face each other
  CurveId first, second;        ///< their curves; the same one twice if it comes back to itself
  HalfEdgeId edge, other_edge;  ///< their edges
};

/// The thinnest gap that is thinner than `below`. It does not matter whether elements lie between the two curves.
///
/// Complexity  O(triangles + n log n) for n constrained edges where no gap is near `below`
std::optional<BoundaryGap> least_gap(const Mesh& mesh, double below);
/// The same with the control points elsewhere.   Shapes  points: point_slots
std::optional<BoundaryGap> least_gap(const Mesh& mesh, std::span<const Point> points, double below);

/// In words, for example: curve 1 ("cell") and curve 0 ("wall") are 0.01 apart at (0.25, 1). Lengths of the document.
std::string describe_gap(const Mesh& mesh, const BoundaryGap& gap);

}  // namespace pliant
