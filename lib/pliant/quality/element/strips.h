// lib/pliant/quality/element/strips.h: finds the boxes that a horizontal line meets (private to this layer).
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Boxes sorted into horizontal strips of equal height, so that few boxes have to be looked at that a line does not
/// meet.
class Strips {
 public:
  explicit Strips(std::span<const Box> boxes) {
    Box all;
    for (const Box& box : boxes) {
      all.extend(box.low);
      all.extend(box.high);
    }
    // There are so many strips that a box is in about eight of them on average.
    double heights = 0;
    for (const Box& box : boxes) heights += (box.high.y - box.low.y) / (all.high.y - all.low.y);
    const double wanted = std::min(7 / heights, 0.25) * static_cast<double>(boxes.size());
    const auto count = static_cast<std::size_t>(wanted >= 1 ? wanted : 1);
    low_ = all.low.y;
    per_height_ = static_cast<double>(count) / (all.high.y - all.low.y);
    if (!std::isfinite(per_height_)) per_height_ = 0;
    strips_.resize(count);
    for (std::size_t k = 0; k < boxes.size(); ++k)
      for (std::size_t s = index(boxes[k].low.y); s <= index(boxes[k].high.y); ++s) strips_[s].push_back(k);
  }

  /// The numbers of all boxes that the line at this height meets, and of some others, ascending.
  std::span<const std::size_t> at(double y) const { return strips_[index(y)]; }

 private:
  std::size_t index(double y) const {
    const double place = (y - low_) * per_height_;
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(strips_.size() - 1)));
  }
  double low_ = 0, per_height_ = 0;
  std::vector<std::vector<std::size_t>> strips_;
};

}  // namespace pliant
