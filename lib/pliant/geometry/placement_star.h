#pragma once  // lib/pliant/geometry/placement_star.h: the elements around a moving control point (private to this
              // layer)
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/optimal_placement.h"
#include "pliant/geometry/validity.h"

namespace pliant {

/// The elements in coordinates in which the moving point starts at the origin and the farthest fixed control point has
/// the distance 1: what is solved for is of the order of 1.
class PlacementStar {
 public:
  PlacementStar(int degree, std::span<const PlacementElement> elements, const Point& start)
      : degree_(degree), elements_(elements), start_(start) {
    for (const PlacementElement& element : elements)
      for (const Point& p : element.net) size_ = std::max(size_, length(p - start));
    if (size_ == 0) size_ = 1;
  }

  int degree() const { return degree_; }
  std::size_t count() const { return elements_.size(); }
  int moving(std::size_t e) const { return elements_[e].moving; }
  double size() const { return size_; }
  std::span<const PlacementElement> elements() const { return elements_; }

  /// The net of element e in these coordinates, the moving point at `place`.
  std::span<const Point> net(std::size_t e, const Point& place = {}) {
    for (std::size_t n = 0; n < points(); ++n) buffer_[n] = (elements_[e].net[n] - start_) / size_;
    buffer_[static_cast<std::size_t>(elements_[e].moving)] = place;
    return {buffer_.data(), points()};
  }
  Point world(const Point& place) const { return start_ + size_ * place; }
  /// The net of element e as stored, the moving point at `place`.
  std::span<const Point> world_net(std::size_t e, const Point& place) {
    std::copy_n(elements_[e].net.begin(), points(), buffer_.begin());
    buffer_[static_cast<std::size_t>(elements_[e].moving)] = place;
    return {buffer_.data(), points()};
  }
  bool is_certified(const Point& world_place) {
    for (std::size_t e = 0; e < count(); ++e)
      if (certify(degree_, world_net(e, world_place)) != Validity::valid) return false;
    return true;
  }

  /// Calls visit(corners, which) for each control triangle of the element that the moving point is a corner of (the
  /// `which`-th, 0..2); counter-clockwise in an element that is.
  template <class Visit>
  void for_control_triangles(std::size_t e, Visit visit) const {
    const NetLayout& layout = NetLayout::of(degree_);
    const auto triangle = [&](const std::array<int, 3>& corners) {
      for (std::size_t which = 0; which < 3; ++which)
        if (corners[which] == elements_[e].moving) visit(corners, which);
    };
    for (int i = 0; i < degree_; ++i)
      for (int j = 0; i + j < degree_; ++j) {
        triangle({layout.index(i + 1, j), layout.index(i, j + 1), layout.index(i, j)});
        if (i + j < degree_ - 1)  // the one upside down between its neighbours
          triangle({layout.index(i + 1, j + 1), layout.index(i, j + 1), layout.index(i + 1, j)});
      }
  }

 private:
  std::size_t points() const { return static_cast<std::size_t>(net_size(degree_)); }

  int degree_;
  std::span<const PlacementElement> elements_;
  Point start_;
  double size_ = 0;
  std::array<Point, net_size(max_degree)> buffer_;
};

}  // namespace pliant
