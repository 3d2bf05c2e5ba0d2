#include <algorithm>  // lib/pliant/geometry/improve_point.cpp: a quasiconvex program over points of the elements, with cuts
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/disk_program.h"
#include "pliant/geometry/optimal_placement.h"
#include "pliant/geometry/placement_star.h"
#include "pliant/geometry/shape_bounds.h"

namespace pliant {
namespace {

constexpr int most_rounds = 12;       // of cuts
constexpr double near_enough = 2e-3;  // relative to the optimum

/// tau as a function of the place q where the Jacobian's columns are fixed + q * rate (along xi2, xi3). Empty where
/// they hardly depend on q.
std::optional<ShapeFunction> shape_function(const Vector& fixed_2, const Vector& fixed_3, double rate_2,
                                            double rate_3) {
  // T = J E^-1, E the map from the unit right triangle to the equilateral one.
  constexpr double root = std::numbers::inv_sqrt3;
  const Vector a1 = fixed_2, a2 = root * (2 * fixed_3 - fixed_2);
  const double n1 = rate_2, n2 = root * (2 * rate_3 - rate_2);
  const double n = n1 * n1 + n2 * n2;
  if (n <= 1e-20) return std::nullopt;
  return ShapeFunction{(n1 * a1 + n2 * a2) / -n, perpendicular(n2 * a1 - n1 * a2) / n};
}

/// What the pointwise shape of the elements depends on; cuts are points xi.
class ElementShapes {
 public:
  explicit ElementShapes(PlacementStar& star) : star_(star), rows_(star.count()) {
    for (std::size_t e = 0; e < star.count(); ++e) {
      const auto net = star.net(e);
      for (std::size_t n = 0; n < net.size(); ++n)
        rows_[e].insert(rows_[e].end(), {net[n].x, net[n].y, static_cast<int>(n) == star.moving(e) ? 1.0 : 0.0});
      sample(e);
    }
  }

  std::vector<ShapeFunction> functions;

  /// The least shape with the point at a place of the plane; every element's worst point is kept for `cut`.
  ShapeBounds at(const Point& world_place) {
    worst_.clear();
    ShapeBounds least{1, 1, {}};
    for (std::size_t e = 0; e < star_.count(); ++e) {
      const ShapeBounds bounds = least_shape(star_.degree(), star_.world_net(e, world_place), near_enough / 4);
      worst_.push_back(bounds);
      least = {std::min(least.lower, bounds.lower), std::min(least.upper, bounds.upper), bounds.worst};
    }
    return least;
  }

  /// Adds the worst points of elements with less than `value`; false if there is none that depends on the place.
  bool cut(double value) {
    const std::size_t before = functions.size();
    for (std::size_t e = 0; e < worst_.size(); ++e)
      if (worst_[e].upper < value) add(e, worst_[e].worst);
    return functions.size() > before;
  }

 private:
  void add(std::size_t e, const Barycentric& xi) {
    std::array<double, 3> value, along_2, along_3;
    evaluate_net(star_.degree(), 3, rows_[e], xi, value, along_2, along_3);
    if (const auto f = shape_function({along_2[0], along_2[1]}, {along_3[0], along_3[1]}, along_2[2], along_3[2]))
      functions.push_back(*f);
  }

  /// A first choice: the nodes of the element's own degree, and the centre.
  void sample(std::size_t e) {
    const int p = star_.degree();
    if (p > 1) {  // on a straight element tau is the same everywhere
      const NetLayout& layout = NetLayout::of(p);
      for (int n = 0; n < layout.size(); ++n) {
        const auto [i, j, k] = layout.exponents(n);
        add(e, {static_cast<double>(i) / p, static_cast<double>(j) / p, static_cast<double>(k) / p});
      }
    }
    add(e, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  }

  PlacementStar& star_;
  std::vector<std::vector<double>> rows_;
  std::vector<ShapeBounds> worst_;
};

Placement improve_elements(PlacementStar& star, const Point& start) {
  ElementShapes shapes(star);
  const ShapeBounds at_start = shapes.at(start);
  Placement best{star.is_certified(start) ? Placement::Outcome::placed : Placement::Outcome::stuck, start,
                 at_start.lower};
  // What would be gained must exceed what is not known of the start.
  double to_beat =
      best.outcome == Placement::Outcome::placed ? at_start.upper : -std::numeric_limits<double>::infinity();
  shapes.cut(2);
  for (int round = 0; round < most_rounds && !shapes.functions.empty(); ++round) {
    const auto optimum = maximise_least(shapes.functions);
    if (!optimum || optimum->value <= to_beat) break;
    const Point place = star.world(optimum->place);
    const ShapeBounds there = shapes.at(place);
    if (there.lower > to_beat && star.is_certified(place)) {
      best = {Placement::Outcome::placed, place, there.lower};
      to_beat = there.lower;
    }
    if (there.upper >= optimum->value * (1 - near_enough) || !shapes.cut(optimum->value * (1 - near_enough))) break;
  }
  return best;
}

Placement improve_control_mesh(PlacementStar& star, const Point& start) {
  std::vector<ShapeFunction> functions;
  for (std::size_t e = 0; e < star.count(); ++e) {
    const auto net = star.net(e);
    star.for_control_triangles(e, [&](const std::array<int, 3>& corners, std::size_t which) {
      // The moving corner taken as the first: both columns fall by q.
      const Point& second = net[static_cast<std::size_t>(corners[(which + 1) % 3])];
      const Point& third = net[static_cast<std::size_t>(corners[(which + 2) % 3])];
      functions.push_back(*shape_function(second, third, -1, -1));
    });
  }
  const auto least = [&functions](const Point& q) {
    double value = 1;
    for (const ShapeFunction& f : functions) value = std::min(value, f(q));
    return value;
  };
  Placement best{star.is_certified(start) ? Placement::Outcome::placed : Placement::Outcome::stuck, start, least({})};
  const auto optimum = maximise_least(functions);
  if (!optimum || (optimum->value <= best.value && best.outcome == Placement::Outcome::placed)) return best;
  // Elements may be tangled there, though their control triangles are not. On the way back the least shape falls, but
  // from a start that is valid it stays above the start's.
  Point place = optimum->place;
  for (int halvings = 0; halvings < 8; ++halvings, place = place / 2)
    if (star.is_certified(star.world(place))) return {Placement::Outcome::placed, star.world(place), least(place)};
  return best;
}

}  // namespace

Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                        PlacementMeasure measure) {
  assert(!elements.empty());
  PlacementStar star(degree, elements, start);
  return measure == PlacementMeasure::element ? improve_elements(star, start) : improve_control_mesh(star, start);
}

}  // namespace pliant
