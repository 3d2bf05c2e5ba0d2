// formats/picture/tessellation.h: curved elements as straight triangles that meet along their edges.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "formats/picture/coloring.h"
#include "formats/picture/mesh_edges.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct TessellationOptions {
  int subdivide = 0;               ///< pieces of every edge; 0: by curvature and colour, a power of two for each edge
  double tolerance = 0;            ///< how far an edge's chords may be from it, a length
  double color_tolerance = 0;      ///< how far values may be off inside a piece
  double color_spread = HUGE_VAL;  ///< how much values may differ within a piece: viewers mix its corners' colours
};

/// Straight triangles, and the edges as polylines of their vertices.
struct Tessellation {
  std::vector<Point> vertices;
  std::vector<double> values;              ///< of each vertex; NaN where there is none; empty without values
  std::vector<FaceId> vertex_faces;        ///< the face of an element at the vertex
  std::vector<std::uint32_t> triangles;    ///< three vertices each
  std::vector<std::uint32_t> marked;       ///< the same, for elements that are not valid
  std::vector<std::uint32_t> inner_lines;  ///< two vertices each, of edges that are not constrained
};

/// Vertices are shared by the elements around them where their colours agree: everywhere for a continuous field,
/// within a face for faces and fields by face; an element with a metric has its own.
/// Requires    M1 and M2; `without` in ascending order: the elements that go to `marked`
Tessellation tessellate(const MeshData& mesh, const MeshEdges& edges, const ElementValues& values, ColorBy::Kind kind,
                        const std::vector<TriangleId>& without, const TessellationOptions& options);

/// A polyline on the edge, n + 1 points, ends bit for bit; and unit tangents there (0 where there is none).
struct Polyline {
  std::vector<Point> points;
  std::vector<Vector> tangents;
};
Polyline sample_edge(const std::vector<Point>& polygon, int n);

/// Pieces of an edge so that its chords are within the tolerance: a power of two, at most 32.
int edge_pieces(const std::vector<Point>& polygon, double tolerance);

/// The lattice of an element cut n times, whose edges are cut only counts[e] times (each divides n). Nodes are (i, j),
/// with the weights (n - i - j, i, j) / n.
struct ElementLattice {
  int n;
  std::array<int, 3> counts;
  /// Where a node goes: on an edge to the nearest of the edge's own cuts.
  std::array<int, 2> moved(int i, int j) const;
  /// Triples of moved nodes, counter-clockwise, without the triangles that collapse; they cover the element once.
  std::vector<std::array<std::array<int, 2>, 3>> triangles() const;
};

}  // namespace pliant
