// lib/pliant/mesh/star.h: the triangles around a vertex, and its link.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The half-edges that leave a vertex, counter-clockwise; around an inner vertex they go all the way round.
struct Star {
  std::vector<HalfEdgeId> outgoing;  ///< one in each triangle of the star
  bool is_closed = false;            ///< the vertex is not on the outer boundary
  int components = 0;                ///< 1, or more at a pinched vertex: half-disks, one after the other

  int degree() const { return static_cast<int>(outgoing.size()); }
};

/// Fills `star` (its memory is reused).   Complexity O(degree)
void find_star(const Mesh& mesh, PointId v, Star& star);

/// The half-edge from a to b, or none.
HalfEdgeId find_half_edge(const Mesh& mesh, PointId a, PointId b);

/// True if an edge joins a and b, whichever way round its triangles have it.
bool are_joined(const Mesh& mesh, PointId a, PointId b);

/// True if the star's vertex belongs to the boundary complex: an edge at it lies on a curve, or it is a lone vertex.
bool is_on_curve(const Mesh& mesh, const Star& star);

}  // namespace pliant
