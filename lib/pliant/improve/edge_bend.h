// lib/pliant/improve/edge_bend.h: how far is an edge from straight?
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The greatest distance of an edge's control points from where they would be if the edge were straight with equally
/// spaced control points; squared.
double squared_bend(const Mesh& mesh, HalfEdgeId h);

}  // namespace pliant
