// formats/picture/gltf_height.cpp: where the values of a field are above the plane of a glTF scene.
#include "formats/picture/gltf_height.h"

#include <cmath>

#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr double part_of_size = 0.25;

}  // namespace

void GltfHeights::add(const ValueRange& values) {
  range_.extend(values.low);
  range_.extend(values.high);
  if (range_.is_empty()) return;
  constexpr double most = 1e30;  // as for lengths
  if (!std::isfinite(range_.high - range_.low) || !(std::abs(height_of(range_.high)) <= most))
    throw InputError("/fields",
                     "the heights reach farther than 1e30 times the first mesh's size, beyond the single precision of "
                     "glTF; a smaller SCALE is wanted");
}

double GltfHeights::height_of(double value) const {
  const double above = value - zero();
  if (scale_) return above * *scale_ / place_.scale;
  const double range = range_.high - range_.low;
  return range > 0 ? above / range * part_of_size * place_.size : 0;
}

double GltfHeights::scale() const {
  if (scale_) return *scale_;
  const double range = range_.high - range_.low;
  return range > 0 ? part_of_size * place_.size * place_.scale / range : 1;
}

Vector positive_extent(const Box& box) {
  const Vector extent = box.high - box.low;
  return {extent.x > 0 ? extent.x : 1, extent.y > 0 ? extent.y : 1};
}

}  // namespace pliant
