// lib/pliant/flow/hold_gaps.h: takes out of a motion what would close gaps between boundaries.
#pragma once
#include <span>

#include "pliant/flow/move_curves.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Changes the displacements of a step so that curves which have no end in common stay `least` apart.
///
/// Where two places come nearer than that, the part of their approach along the line between them that is too much is
/// taken from both, in the shares in which they approach (a wall at rest stays at rest); what runs along the gap stays.
/// A gap that is thinner already, and would close further, is opened by at most a tenth of `least` in a step. The
/// places are spread over the spans; each acts on the Greville points beside it, again until none comes too near. It
/// is a policy, no proof: the gap that results has to be measured.
///
/// Returns     how many places were held
/// Complexity  O(control points log) where no two curves can meet in this step
int hold_gaps(const BoundaryComplex& boundary, BoundaryDisplacements& displacements, double least);

/// Fills in corrections of control points that are not known, so that they fade away from the known ones.
/// Shapes      known, corrections: point_slots
/// Complexity  O(triangles) for each of a few dozen rings of elements around corrections that are not 0
void spread_corrections(const Mesh& mesh, std::span<const char> known, std::span<Vector> corrections);

}  // namespace pliant
