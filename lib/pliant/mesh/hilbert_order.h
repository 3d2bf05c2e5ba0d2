// lib/pliant/mesh/hilbert_order.h: places along Hilbert's curve: what follows each other there lies near in the plane.
#pragma once
#include <algorithm>
#include <cstdint>

#include "pliant/geometry/point.h"

namespace pliant {

/// Numbers points by where Hilbert's curve through a box passes them, on a grid of 2^bits by 2^bits cells.
/// Requires    1 <= bits <= 32
class HilbertOrder {
 public:
  HilbertOrder(const Box& box, int bits) : low_(box.low), bits_(bits) {
    const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    scale_ = extent > 0 && std::isfinite(extent) ? std::ldexp(1.0, bits) / extent : 0;
    if (!std::isfinite(scale_)) scale_ = 0;
  }
  /// The place of p on the curve. A point outside the grid has the place of the nearest cell.
  std::uint64_t operator()(const Point& p) const {
    std::uint64_t x = cell((p.x - low_.x) * scale_), y = cell((p.y - low_.y) * scale_), place = 0;
    for (int bit = bits_ - 1; bit >= 0; --bit) {
      const std::uint64_t right = (x >> bit) & 1, up = (y >> bit) & 1;
      place = 4 * place + ((3 * right) ^ up);
      // The upper quarters are like the whole; the lower two are mirrored at a diagonal. Masks do that without a
      // branch, which would be taken at random.
      const std::uint64_t lower = up - 1, turned = lower & (std::uint64_t{0} - right);  // all bits or none
      x ^= turned;
      y ^= turned;
      const std::uint64_t swapped = (x ^ y) & lower;
      x ^= swapped;
      y ^= swapped;
    }
    return place;
  }

 private:
  std::uint64_t cell(double place) const {
    const double most = std::ldexp(1.0, bits_) - 1;
    return place > 0 ? static_cast<std::uint64_t>(std::min(place, most)) : 0;
  }
  Point low_;
  int bits_;
  double scale_;
};

}  // namespace pliant
