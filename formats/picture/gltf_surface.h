// formats/picture/gltf_surface.h: what lies in a frame of a glTF scene: vertices with heights, bands, normals.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/picture/coloring.h"
#include "formats/picture/tessellation.h"

namespace pliant {

/// The box that positions are parts of. Heights are values of a field; without heights they are one empty range.
struct GltfBox {
  Box plane;
  ValueRange heights;

  void extend(std::span<const Point> points, std::span<const double> values);
  /// The height's place in the box, from 0 to 1; 0 where the box is flat.
  double place(double height) const {
    return heights.low < heights.high && std::isfinite(height) ? heights.place(height) : 0;
  }
};

/// The corners of the polygon that is drawn for a circle, counter-clockwise.
std::vector<Point> corners_of(const Circle& circle);

/// A row of pairs of points, left and right of curves. Quadrilateral k lies between pairs k and k + 1; those between
/// curves that do not join have no area.
struct GltfBand {
  std::vector<Point> points;
  std::vector<double> heights;  ///< of each point; empty without heights
};

struct BandOptions {
  double half_width = 0;
  double tolerance = 0;  ///< how far chords may be from the edges
  int subdivide = 0;     ///< pieces of every edge; 0: as many as it takes
};

/// A band along all constrained edges: most viewers draw lines no wider than a pixel. Edges that follow each other
/// smoothly share a pair. With heights a band is cut as the elements are, and there is one for each side of an edge at
/// which heights jump.
GltfBand outline_band(const MeshData& mesh, const MeshEdges& edges, const ElementValues* heights,
                      const std::vector<int>& cuts, const BandOptions& options);

/// The unit normals of vertices in the coordinates of the box in x and y (not scaled there) and its parts in z: the
/// mean of those of the triangles around, weighted by area. (0, 0, 1) where there are none.
std::vector<std::array<float, 3>> vertex_normals(const Tessellation& pieces, const GltfBox& box, const Vector& unit);

}  // namespace pliant
