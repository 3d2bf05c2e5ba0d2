// lib/pliant/improve/thin_gaps.h: gaps between two stretches of boundary that are thin compared with the spans there.
#pragma once
#include "pliant/improve/sizing.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// True if an inner edge joins two vertices on curves, and is shorter at both than a quarter of the longest span that
/// ends there. To fill such a gap with triangles of its width would take many times as many triangles as there are
/// spans. Where the criteria keep thin gaps (QualityGoals::keeps_thin), a triangle whose shortest edge crosses one does
/// not count as poor.
///
/// Ensures     the answer depends on the edges at both ends alone, not on their order
/// Complexity  O(degree of both vertices)
bool crosses_thin_gap(const Mesh& mesh, HalfEdgeId h);

/// How many triangles it takes to fill the thin gaps of a mesh with triangles of their own width.
struct ThinGaps {
  double triangles = 0;  ///< an estimate: twice the length of each gap over its width
  Point thinnest;        ///< where the most are needed for one span
};
/// Estimates that from the triangles which cross a thin gap and which `refine` would attack as too poor.
///
/// Complexity  O(mesh)
ThinGaps find_thin_gaps(const Mesh& mesh, const QualityGoals& goals);

}  // namespace pliant
