// lib/pliant/generate/planar_mesh.h: the faces triangulated by the chords of their curves.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {

/// Straight triangles of the faces; what lies outside is dropped. Half-edge 3t + e runs from corner e to corner e + 1.
struct PlanarMesh {
  std::vector<Point> points;  ///< the boundary's nodes, then free points
  std::vector<std::array<int, 3>> corners;
  std::vector<int> faces;  ///< of each triangle
  std::vector<int> twins;  ///< of each half-edge; -1 on the outer boundary
  std::vector<int> spans;  ///< on which each half-edge lies; -1 for an inner one

  int origin(int h) const { return corners[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)]; }
  int target(int h) const { return corners[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>((h + 1) % 3)]; }
  int twin(int h) const { return twins[static_cast<std::size_t>(h)]; }
  int span(int h) const { return spans[static_cast<std::size_t>(h)]; }
};

/// Constrained Delaunay triangulation of the chords and the free points, each triangle named by the curves around it.
/// Returns why it could not be made, with the place (faces that curves do not separate, chords that cross); else empty.
std::string triangulate_faces(const BoundaryComplex& boundary, const BoundarySpans& spans,
                              const std::vector<Point>& free_points, PlanarMesh& mesh);

/// A corner between two constrained edges of one triangle.
struct CornerAngle {
  double logical;  ///< between the chords, in (0, pi)
  double curved;   ///< between the curves' tangents, within pi of `logical`
};
CornerAngle angle_at(const BoundarySpans& spans, const PlanarMesh& mesh, int half_edge);

/// Points that split the ears which cover a smooth or reflex corner of the boundary: once they are among the free
/// points, these ears are no longer Delaunay. Of ears that one point splits together only one is answered.
std::vector<Point> points_for_ears(const BoundarySpans& spans, const PlanarMesh& mesh);

}  // namespace pliant
