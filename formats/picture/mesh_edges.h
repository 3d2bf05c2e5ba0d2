// formats/picture/mesh_edges.h: the edges of a mesh document, each once, for those who draw them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct MeshEdge {
  std::vector<PointId> points;      ///< degree + 1 control points
  std::array<TriangleId, 2> sides;  ///< its triangles; the second is none at the outer boundary
  std::int32_t constrained = none;  ///< index into constrained_edges, or none
};

struct MeshEdges {
  std::vector<MeshEdge> edges;             ///< in the order in which the triangles meet them
  std::vector<std::int32_t> of_half_edge;  ///< index into `edges` for each half-edge 3t + e
  /// True if the half-edge runs from the edge's first point to its last.
  bool runs_forward(const MeshData& mesh, HalfEdgeId h) const;
};

/// Finds the edges of a mesh.
/// Requires    M1 and M2 (check_structure)
/// Complexity  O(mesh)
MeshEdges find_edges(const MeshData& mesh);

/// The positions of control points.
std::vector<Point> positions(const MeshData& mesh, const std::vector<PointId>& points);
/// The control points of triangle t.
std::span<const PointId> element_points(const MeshData& mesh, TriangleId t);
/// The positions of the net of triangle t.
std::vector<Point> element_net(const MeshData& mesh, TriangleId t);
/// x and y of points, one point behind the other: what evaluates several components takes them so.
std::vector<double> rows_of(const std::vector<Point>& points);
/// The box of all control points.
Box bounding_box(const MeshData& mesh);

/// Upper bound of an edge's distance from the straight line between its ends, at equal parameters; exact for degree 2.
double bulge(const std::vector<Point>& polygon);

}  // namespace pliant
