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
    for (std::uint64_t bit = std::uint64_t{1} << (bits_ - 1); bit > 0; bit >>= 1) {
      const bool right = x & bit, up = y & bit;
      place = 4 * place + (right ? (up ? 2 : 3) : (up ? 1 : 0));
      if (up) continue;  // the upper quarters are like the whole; the lower two are mirrored at a diagonal
      if (right) x = ~x, y = ~y;
      std::swap(x, y);
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
