// lib/pliant/improve/refining/find_poor.h: the triangles that are to be flipped or cut before a round of refinement.
#pragma once
#include <vector>

#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/improve/sizing.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The length of the longest edge of a logical triangle.
double longest_edge(const Mesh& mesh, TriangleId t);

/// Does the triangle lie opposite a small angle between two curves? Then no operation can give it a better shape.
bool is_excused(const Mesh& mesh, TriangleId t, const SharpCorners& corners);

/// The triangles that refinement attacks or that are turned over, ascending.
/// Complexity  O(mesh)
std::vector<TriangleId> find_bad(const Mesh& mesh, const QualityGoals& goals);

/// Those of `bad`, found by find_bad, that are turned over or whose shape misses the goals (Attack::is_poor), without
/// those that a small angle between curves excuses.
std::vector<TriangleId> find_poor(const Mesh& mesh, const QualityGoals& goals, const std::vector<TriangleId>& bad);

}  // namespace pliant
