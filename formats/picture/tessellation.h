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
  int subdivide = 0;               ///< pieces of every edge; 0: as many as curvature, colour and height need
  double tolerance = 0;            ///< how far an edge's chords may be from the edge, a length
  double color_tolerance = 0;      ///< how far values may be off inside a piece
  double color_spread = HUGE_VAL;  ///< how much values may differ at a piece's corners, whose colours viewers mix
  const ElementValues* heights = nullptr;  ///< what lifts the vertices, if anything does
  double height_tolerance = 0;             ///< how far heights may be off inside a piece, as values
};

/// Straight triangles, and the edges as polylines of their vertices.
struct Tessellation {
  std::vector<Point> vertices;
  std::vector<double> values;        ///< value of each vertex, NaN where it has none; empty where nothing has values
  std::vector<double> heights;       ///< of each vertex; empty without `TessellationOptions::heights`
  std::vector<FaceId> vertex_faces;  ///< for each vertex the face of an element at it
  std::vector<std::uint32_t> triangles;    ///< three vertices each
  std::vector<std::uint32_t> marked;       ///< three vertices each, of the elements in `without`
  std::vector<std::uint32_t> inner_lines;  ///< two vertices each, of edges that are not constrained
  std::vector<int> cuts;                   ///< pieces of each of the `MeshEdges`
};

/// Cuts the elements of a mesh into triangles. Elements share the vertices at which their colours and heights agree:
/// all of them for a continuous field, those within a face for faces and fields by face, none for a metric. The
/// elements of `without`, those that are not valid, go to `marked`.
///
/// Requires    M1 and M2; `without` in ascending order
Tessellation tessellate(const MeshData& mesh, const MeshEdges& edges, const ElementValues& values, ColorBy::Kind kind,
                        const std::vector<TriangleId>& without, const TessellationOptions& options);

/// n + 1 points on an edge, whose ends are those of the edge bit for bit, and the unit tangents there (0 where the edge
/// has none).
struct Polyline {
  std::vector<Point> points;
  std::vector<Vector> tangents;
};
Polyline sample_edge(const std::vector<Point>& polygon, int n);

/// The least number of pieces whose chords are within the tolerance of the edge, at most 32.
int edge_pieces(const std::vector<Point>& polygon, double tolerance);

/// The lattice of an element whose inside is cut into n steps, while edge e is cut only into counts[e], which divides
/// n. Node (i, j) has the barycentric coordinates (n - i - j, i, j) / n.
struct ElementLattice {
  int n;
  std::array<int, 3> counts;
  /// Where node (i, j) goes: a node on an edge goes to the nearest of the edge's own cuts.
  std::array<int, 2> moved(int i, int j) const;
  /// Triples of moved nodes, counter-clockwise. Triangles that collapse are left out; the others cover the element
  /// once.
  std::vector<std::array<std::array<int, 2>, 3>> triangles() const;
};

}  // namespace pliant
