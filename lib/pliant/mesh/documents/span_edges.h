// lib/pliant/mesh/documents/span_edges.h: the constrained edges of a mesh in the order of its document.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// An edge that lies on a curve, as one of its half-edges.
struct SpanEdge {
  CurveId curve = none;
  int number = 0;           ///< which span of the curve it is
  double start = 0;         ///< the parameter of the curve at which the span starts
  HalfEdgeId half_edge{0};  ///< the one in the curve's direction; the other one where that has no triangle
  bool is_forward = true;   ///< the half-edge runs in the curve's direction
};

/// All constrained edges, sorted by curve and span.
///
/// Complexity  O(triangles + n log n) with n constrained edges
std::vector<SpanEdge> span_edges(const Mesh& mesh);

}  // namespace pliant
