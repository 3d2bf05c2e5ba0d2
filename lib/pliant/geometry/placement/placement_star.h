// lib/pliant/geometry/placement/placement_star.h: the elements around a moving control point (private to this layer).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant {

/// The elements in local coordinates, in which the box of the fixed control points has a size of about 1 and is near
/// the origin: what is solved for is of the order of 1, wherever the moving point starts. Memory is reused from call to
/// call.
class PlacementStar {
 public:
  void begin(int degree, std::span<const PlacementElement> elements) {
    degree_ = degree;
    elements_ = elements;
    Box box;
    for (const PlacementElement& element : elements)
      for (std::size_t n = 0; n < points(); ++n)
        if (static_cast<int>(n) != element.moving) box.extend(element.net[n]);
    // Neither the shift nor the scale rounds. A coordinate is shifted only if all its values are within a factor of two
    // of the shift, and the scale is a power of two.
    const Point middle = 0.5 * box.low + 0.5 * box.high;
    const double half = std::max(box.high.x - middle.x, box.high.y - middle.y);
    size_ = 1;
    if (half > 0 && std::isfinite(half)) {
      int exponent = 0;
      std::frexp(half, &exponent);
      size_ = std::ldexp(1, std::clamp(exponent, -1000, 1000));
    }
    half_ = half / size_;
    origin_ = {std::fabs(middle.x) < 2 * half ? 0 : middle.x, std::fabs(middle.y) < 2 * half ? 0 : middle.y};
    middle_ = (middle - origin_) / size_;
    nets_.resize(elements.size() * points());
    auto to = nets_.begin();
    for (const PlacementElement& element : elements)
      for (std::size_t n = 0; n < points(); ++n) *to++ = local(element.net[n]);
  }

  int degree() const { return degree_; }
  std::size_t count() const { return elements_.size(); }
  int moving(std::size_t e) const { return elements_[e].moving; }
  std::span<const PlacementElement> elements() const { return elements_; }

  /// The box of the fixed control points: its middle, and the greater half side (0.5 to 1, or 0).
  const Point& middle() const { return middle_; }
  double half() const { return half_; }
  Point local(const Point& world_place) const { return (world_place - origin_) / size_; }
  Point world(const Point& place) const { return origin_ + size_ * place; }
  /// The net of element e in these coordinates, the moving point at `place`.
  std::span<const Point> net(std::size_t e, const Point& place) {
    Point* const net = nets_.data() + e * points();
    net[elements_[e].moving] = place;
    return {net, points()};
  }
  /// Whether every element, in its stored coordinates, is valid with the moving point at a place of the plane.
  bool is_certified(const Point& world_place) const {
    std::array<Point, net_size(max_degree)> net;
    for (const PlacementElement& element : elements_) {
      std::copy_n(element.net.begin(), points(), net.begin());
      net[static_cast<std::size_t>(element.moving)] = world_place;
      if (certify(degree_, {net.data(), points()}) != Validity::valid) return false;
    }
    return true;
  }

  /// Calls visit(corners, which) for each control triangle of the element that has the moving point as a corner, number
  /// `which` (0..2). The corners run counter-clockwise if those of the element do.
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
        if (i + j < degree_ - 1)  // the triangle between three of these, which is upside down
          triangle({layout.index(i + 1, j + 1), layout.index(i, j + 1), layout.index(i + 1, j)});
      }
  }

 private:
  std::size_t points() const { return static_cast<std::size_t>(net_size(degree_)); }

  int degree_ = 1;
  std::span<const PlacementElement> elements_;
  Point origin_, middle_;
  double size_ = 1, half_ = 1;
  std::vector<Point> nets_;
};

}  // namespace pliant
