// lib/pliant/generate/patch_region.h: a connected region of one face that is to be meshed anew, and its border.
#pragma once
#include <span>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// A region that grows from an invalid element, never across a constrained edge.
class PatchRegion {
 public:
  /// Makes the region of the cluster of invalid elements around the seed, and one ring around that. `invalid` tells for
  /// each triangle slot whether its element is invalid; later slots have valid elements.
  PatchRegion(const Mesh& mesh, const std::vector<char>& invalid, TriangleId seed);

  /// Adds rings, and the clusters of invalid elements that these touch; false if there was nothing to add.
  bool grow(int rings);

  const std::vector<TriangleId>& triangles() const { return triangles_; }
  bool contains(TriangleId t) const { return static_cast<std::size_t>(t) < member_.size() && member_[index(t)]; }
  /// Adds an element that was split off.
  void add(TriangleId t);

 private:
  bool is_invalid(TriangleId t) const { return index(t) < invalid_.size() && invalid_[index(t)]; }
  bool add_ring();
  bool add_cluster();
  void fill_notches();

  const Mesh& mesh_;
  const std::vector<char>& invalid_;
  std::vector<TriangleId> triangles_;
  std::vector<char> member_;
};

/// An edge on the border of a region. The region lies on its left, and on both sides if the edge is a slit: an edge on
/// a curve inside the face.
struct BorderEdge {
  PointId from, to;
  bool is_slit;
};

/// A region as a boundary to be meshed.
struct RegionBoundary {
  BoundaryComplex complex;  ///< one face, one curve for each edge of the border, in their order
  std::vector<BorderEdge> border;
  std::vector<PointId> vertices;  ///< the mesh's point for each vertex of the complex; lone vertices come last
};
RegionBoundary boundary_of(const Mesh& mesh, const PatchRegion& region);

}  // namespace pliant
