// lib/pliant/improve/thin_gaps.h: does an edge cross a gap between two stretches of boundary that is thin for their
// spans?
#pragma once
#include "pliant/improve/sizing.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// True if an inner edge joins two vertices on curves and is shorter than a quarter of the spans beside each of them:
/// triangles of the gap's width would be many times as many as the spans. Where the criteria keep thin gaps (`thin`), a
/// triangle whose shortest edge this is does not count as poor.
///
/// Ensures     depends on the edges at both ends alone, in any order of the mesh
/// Complexity  O(degree of both vertices)
bool crosses_thin_gap(const Mesh& mesh, HalfEdgeId h);

/// What filling the thin gaps of a mesh with triangles of their own width comes to.
struct ThinGaps {
  double triangles = 0;  ///< an estimate: of a strip, as many as its length has widths, twice
  Point thinnest;        ///< where most of them are wanted
};
/// Looks at the triangles that `refine` would attack as too poor, and not excuse by a small angle of the boundary.
/// Complexity  O(mesh)
ThinGaps find_thin_gaps(const Mesh& mesh, const QualityGoals& goals);

}  // namespace pliant
