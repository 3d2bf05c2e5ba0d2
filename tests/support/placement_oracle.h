// tests/support/placement_oracle.h: the best places of a star's point, found without the code under test.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "support/cut_polygon.h"
#include "support/oracle_element.h"
#include "support/placement_stars.h"

// The oracle shares nothing with the code that it judges but the order of control points. Its programs are convex in
// the place: det J at one xi is affine, and 1 / tau is convex where det J > 0. Costs can only fall on one side of a
// line through the polygon's centre of gravity; the other side is cut off, until no vertex promises less than the best
// cost.
namespace pliant::samples {

/// The optima of one star.
class PlacementOracle {
 public:
  explicit PlacementOracle(const PlacementStar& star, int fineness = 1) : star_(star), fineness_(fineness) {
    Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (std::size_t e = 0; e < star.nets.size(); ++e) {
      elements_.emplace_back(star.degree, star.nets[e], star.moving[e], fineness);
      for (std::size_t n = 0; n < star.nets[e].size(); ++n) {
        if (static_cast<int>(n) == star.moving[e]) continue;
        const Point& p = star.nets[e][n];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    middle_ = {(Real{low.x} + Real{high.x}) / 2, (Real{low.y} + Real{high.y}) / 2};
    half_ = std::max(Real{high.x} - middle_.x, Real{high.y} - middle_.y);
  }

  /// The greatest value, at places up to `reach` half extents away, of the least scaled coefficient of det J.
  Real best_coefficient(Real reach) const {
    // The coefficients are affine in the place, so that they are known everywhere from one place.
    std::vector<Cost> all;
    for (const OracleElement& element : elements_)
      for (const Cost& cost : element.coefficient_costs(middle_)) all.push_back(cost);
    return -least_cost(middle_, reach * half_, 1e-13L, [&](const Place& q) {
              Cost most{-HUGE_VALL, {0, 0}, true};
              for (const Cost& f : all) {
                const Real cost = f.cost + f.slope.x * (q.x - middle_.x) + f.slope.y * (q.y - middle_.y);
                if (cost > most.cost) most = {cost, f.slope, true};
              }
              return most;
            }).cost;
  }
  /// The same for the least scaled det J.
  Real best_area(Real reach, Real width = 1e-12L) const {
    return -least_cost(middle_, reach * half_, width, [this](const Place& q) { return area(q); }).cost;
  }
  struct BestShape {
    Real value, most;  ///< the best value that was found; no value is above `most`
    Point place;
  };
  /// The same for the least tau; 0 if it is positive nowhere.
  BestShape best_shape(Real reach, Real width = 1e-12L) const {
    const LeastCost best = least_cost(middle_, reach * half_, width, [this](const Place& q) {
      Cost most = area(q);
      if (most.cost >= 0) {
        most.is_allowed = false;
        return most;
      }
      most.cost = -HUGE_VALL;
      for (const OracleElement& element : elements_)
        if (const Cost cost = element.shape_cost(q); cost.cost > most.cost) most = cost;
      return most;
    });
    if (!best.is_found) return {0, 0, {}};
    const BestShape result{1 / best.cost,
                           best.sure > 0 ? 1 / best.sure : 1,
                           {static_cast<double>(best.place.x), static_cast<double>(best.place.y)}};
    // For p > 2 the search starts from samples only. If more samples find less at the place, they are used instead.
    if (star_.degree > 2 && fineness_ < 9) {
      const PlacementOracle finer(star_, 3 * fineness_);
      if (finer.shape_at(result.place) < result.value * (1 - 1e-11L)) return finer.best_shape(reach, width);
    }
    return result;
  }
  /// The same two for the control triangles; their areas are divided by the square of half the extent of the star.
  Real best_control_area(Real reach) const {
    const std::vector<Columns> triangles = control_triangles();
    return -least_cost(middle_, reach * half_, 1e-13L, [&](const Place& q) {
              return greatest_area(triangles, q, 1 / (2 * half_ * half_));
            }).cost;
  }
  BestShape best_control_shape(Real reach) const {
    const std::vector<Columns> triangles = control_triangles();
    const LeastCost best = least_cost(middle_, reach * half_, 1e-13L, [&](const Place& q) {
      Cost most = greatest_area(triangles, q, 1);
      if (most.cost >= 0) {
        most.is_allowed = false;
        return most;
      }
      most.cost = -HUGE_VALL;
      for (const Columns& c : triangles)
        if (const Cost cost = samples::shape_cost(c, q); cost.cost > most.cost) most = cost;
      return most;
    });
    if (!best.is_found) return {0, 0, {}};
    return {1 / best.cost,
            best.sure > 0 ? 1 / best.sure : 1,
            {static_cast<double>(best.place.x), static_cast<double>(best.place.y)}};
  }
  /// The least tau of the control triangles at a place.
  Real control_shape_at(const Point& p) const {
    Real least = 1;
    for (const Columns& c : control_triangles()) least = std::min(least, 1 / samples::shape_cost(c, {p.x, p.y}).cost);
    return least;
  }
  /// The least tau at a place; 0 if an element is tangled there.
  Real shape_at(const Point& p) const {
    const Place q{p.x, p.y};
    if (area(q).cost >= 0) return 0;
    Real most = 0;
    for (const OracleElement& element : elements_) most = std::max(most, element.shape_cost(q).cost);
    return 1 / most;
  }

 private:
  std::vector<Columns> control_triangles() const {
    std::vector<Columns> all;
    for (const OracleElement& element : elements_)
      for (const Columns& c : element.control_triangles()) all.push_back(c);
    return all;
  }
  static Cost greatest_area(const std::vector<Columns>& triangles, const Place& q, Real scale) {
    Cost most{-HUGE_VALL, {0, 0}, true};
    for (const Columns& c : triangles)
      if (const Cost cost = samples::area_cost(c, q, scale); cost.cost > most.cost) most = cost;
    return most;
  }
  Cost area(const Place& q) const {
    Cost most{-HUGE_VALL, {0, 0}, true};
    for (const OracleElement& element : elements_)
      if (const Cost cost = element.area_cost(q); cost.cost > most.cost) most = cost;
    return most;
  }

  const PlacementStar& star_;
  int fineness_;
  std::vector<OracleElement> elements_;
  Place middle_{};
  Real half_ = 1;
};

}  // namespace pliant::samples
