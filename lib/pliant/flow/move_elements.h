// lib/pliant/flow/move_elements.h: the control points of a mesh whose boundary has moved.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "pliant/flow/move_curves.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Places of all control points (by slot): constrained edges are the extraction of the moved curves (M4, bit for bit);
/// the others are given by `fill`, which gets the displacements of the control points that are known and completes
/// them.   Complexity O(mesh)
///
/// Shapes      known: point_slots; displacements: point_slots x 2
using FillDisplacements = std::function<void(std::span<char> known, std::span<double> displacements)>;
std::vector<Point> move_elements(const Mesh& mesh, const MovedBoundary& boundary, const FillDisplacements& fill);

}  // namespace pliant
