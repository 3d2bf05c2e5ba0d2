// lib/pliant/flow/move_elements.h: finds the new places of all control points once the boundary has moved.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "pliant/flow/move_curves.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Completes the displacements of control points: fills in those with known[p] == 0.
/// Shapes      known: point_slots; displacements: point_slots x 2
using FillDisplacements = std::function<void(std::span<char> known, std::span<double> displacements)>;

/// The new places of all control points (by slot). Those on curves are extracted from the moved curves, so that M4
/// holds bit for bit; all others move by the displacements that `fill` finds.
///
/// Complexity  O(mesh)
std::vector<Point> move_elements(const Mesh& mesh, const MovedBoundary& boundary, const FillDisplacements& fill);

}  // namespace pliant
