// formats/picture/gltf_place.h: where the scene of a glTF file is, so that single precision is enough for its vertices.
#pragma once
#include "formats/picture/coloring.h"
#include "pliant/geometry/point.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The scene's place and unit, which the first mesh decides. The unit is a power of two, so that scaling rounds
/// nothing.
struct GltfPlace {
  double scale = 1;  ///< the unit; 1 for sizes that viewers are made for
  Point center;      ///< centre of the first mesh's box, in this unit
  double size = 0;   ///< size of the first mesh, in this unit

  GltfPlace() = default;
  /// Throws      InputError for a box that is wider than the largest double
  explicit GltfPlace(const Box& box);
  /// The point that a frame's vertices are relative to: the first mesh's centre, unless a frame with this box is so far
  /// from it that single precision would show. Box and result are in the unit.
  /// Throws      InputError for a frame so small that it would be a point
  Point origin_of(const Box& box) const;
};

/// Is the metric a length or an area, which depends on the unit?
bool has_unit(const ColorBy& color);
/// The mesh relative to `origin`, without fields and boundary.
MeshData moved(const MeshData& mesh, const Point& origin);
/// Throws      InputError for a box that single precision cannot hold
void require_drawable(const Box& box);

}  // namespace pliant
