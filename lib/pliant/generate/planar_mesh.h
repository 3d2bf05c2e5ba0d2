// lib/pliant/generate/planar_mesh.h: the faces of a boundary, triangulated with the chords of its curves.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {

/// Straight triangles that fill the faces. Half-edge 3t + e runs from corner e to corner e + 1.
struct PlanarMesh {
  std::vector<Point> points;  ///< the boundary's nodes, then free points
  std::vector<std::array<int, 3>> corners;
  std::vector<int> faces;  ///< the face of each triangle
  std::vector<int> twins;  ///< the twin of each half-edge; -1 on the outer boundary
  std::vector<int> spans;  ///< the span whose chord each half-edge is; -1 for inner ones

  int origin(int h) const { return corners[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)]; }
  int target(int h) const { return corners[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>((h + 1) % 3)]; }
  int twin(int h) const { return twins[static_cast<std::size_t>(h)]; }
  int span(int h) const { return spans[static_cast<std::size_t>(h)]; }
};

/// Makes the constrained Delaunay triangulation of the chords and the free points. The curves around a triangle tell
/// its face. Returns why it could not be made, with the place (faces that no curve separates, chords that cross); empty
/// if it could.
std::string triangulate_faces(const BoundaryComplex& boundary, const BoundarySpans& spans,
                              const std::vector<Point>& free_points, PlanarMesh& mesh);

/// The angle at a corner between two constrained edges of one triangle.
struct CornerAngle {
  double logical;  ///< the angle between the chords, in (0, pi)
  double curved;   ///< the angle between the tangents of the curves, within pi of `logical`
};
/// The angle at the origin of a half-edge. Requires that this half-edge and the one before it lie on spans.
CornerAngle angle_at(const BoundarySpans& spans, const PlanarMesh& mesh, int half_edge);

/// Points that split the ears which cover a smooth or reflex corner of the boundary. Once they are among the free
/// points, these ears are no longer Delaunay. Ears that one point splits together get only that one.
std::vector<Point> points_for_ears(const BoundarySpans& spans, const PlanarMesh& mesh);

}  // namespace pliant
