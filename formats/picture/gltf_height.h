// formats/picture/gltf_height.h: where the values of a field are above the plane of a glTF scene.
#pragma once
#include <optional>

#include "formats/picture/coloring.h"
#include "formats/picture/gltf_place.h"

namespace pliant {

/// Heights of values, once those of all frames are known: the least is in the plane.
class GltfHeights {
 public:
  GltfHeights() = default;
  /// `scale` is the height of the value 1 in mesh units; without it the range of all values is a quarter of the first
  /// mesh's size.
  GltfHeights(std::optional<double> scale, const GltfPlace& place) : scale_(scale), place_(place) {}

  /// Adds the values of a frame; an empty range adds none.
  /// Throws      InputError for heights that single precision cannot hold
  void add(const ValueRange& values);
  /// The height of a value of any frame, in the unit of the place.
  double height_of(double value) const;
  /// The height of the value 1, in mesh units. Not finite where the range is too small for that.
  double scale() const;
  /// The value in the plane.
  double zero() const { return range_.is_empty() ? 0 : range_.low; }

 private:
  std::optional<double> scale_;
  GltfPlace place_;
  ValueRange range_;
};

/// Width and height of a box; 1 where it has none, so that it can be divided by.
Vector positive_extent(const Box& box);

}  // namespace pliant
