// formats/picture/gltf_place.h: where the scene of a glTF file is, so that single precision is enough for its vertices.
#pragma once
#include "formats/picture/coloring.h"
#include "pliant/geometry/point.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The first mesh says where the scene is, and in which unit: a power of two, so that nothing is rounded.
struct GltfPlace {
  double scale = 1;  ///< the unit; 1 for sizes that viewers are made for
  Point center;      ///< of the first mesh, in this unit
  double size = 0;   ///< of the first mesh, in this unit

  GltfPlace() = default;
  /// Throws      InputError for a box that is wider than the largest double
  explicit GltfPlace(const Box& box);
  /// Around what the vertices of a frame with this box are: the first mesh's centre, unless the frame is so far away
  /// that single precision would show. All in the unit.
  /// Throws      InputError for a frame so small that it would be a point
  Point origin_of(const Box& box) const;
};

/// Is the metric a length or an area, which depends on the unit?
bool has_unit(const ColorBy& color);
/// The geometry alone, as seen from there.
MeshData moved(const MeshData& mesh, const Point& origin);
/// Throws      InputError for what single precision cannot hold
void require_drawable(const Box& box);

}  // namespace pliant
