// lib/pliant/geometry/placement/improve_point.cpp: a quasiconvex program over points of the elements, with cuts.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/placement/disk_program.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/placement/placement_star.h"
#include "pliant/geometry/placement/shape_bounds.h"
#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {
namespace {

using Outcome = Placement::Outcome;
using Program = Placement::Program;

constexpr int most_rounds = 60;         // rounds of cuts
constexpr int plain_rounds = 6;         // rounds that cut at the optimum only; later ones also cut on the way to it
constexpr double close_enough = 5e-11;  // a value this close to the bound of the optimum is always good enough

/// tau as a function of the place q, where the Jacobian's columns (along xi2 and xi3) are fixed + q * rate. Empty if
/// tau changes by less than rounding over the whole star.
std::optional<ShapeFunction> shape_function(const Vector& fixed_2, const Vector& fixed_3, double rate_2,
                                            double rate_3) {
  // T = J E^-1, where E is the map from the unit right triangle to the equilateral one.
  constexpr double root = std::numbers::inv_sqrt3;
  const Vector a1 = fixed_2, a2 = root * (2 * fixed_3 - fixed_2);
  const double n1 = rate_2, n2 = root * (2 * rate_3 - rate_2);
  const double n = n1 * n1 + n2 * n2;
  if (n <= 1e-24 * (squared_length(a1) + squared_length(a2))) return std::nullopt;
  const double by = 1 / n;
  return ShapeFunction{-by * (n1 * a1 + n2 * a2), by * perpendicular(n2 * a1 - n1 * a2)};
}

/// tau at a point where the Jacobian has these columns.
double shape_of(const Vector& along_2, const Vector& along_3) {
  const Vector second = std::numbers::inv_sqrt3 * (2 * along_3 - along_2);
  const double square = squared_length(along_2) + squared_length(second);
  return square > 0 ? 2 * cross(along_2, second) / square : 0;
}

/// tau at points xi of the elements, each as a function of the place of the moving control point. Such points are added
/// as cuts. Memory is reused from call to call.
class ElementShapes {
 public:
  std::vector<ShapeFunction> functions;
  double cap;  ///< the least tau found at points where it does not depend on the place

  void begin(PlacementStar& star, double width) {
    star_ = &star;
    width_ = width;
    terms_ = &JacobianTerms::of(star.degree());
    worst_.resize(star.count());
    functions.clear();
    cap = 1;
    for (std::size_t e = 0; e < star.count(); ++e) sample(e);
  }

  /// Bounds of the least shape with the moving point at a place. The worst point of each element is kept for `cut`.
  ShapeBounds at(const Point& place) {
    ShapeBounds least{1, 1, {}};
    for (std::size_t e = 0; e < worst_.size(); ++e) {
      worst_[e] = least_shape(star_->degree(), star_->net(e, place), width_);
      least.lower = std::min(least.lower, worst_[e].lower);
      least.upper = std::min(least.upper, worst_[e].upper);
    }
    return least;
  }

  /// Adds the worst points of all elements whose shape is below `value`; false if none of them depends on the place.
  bool cut(double value) {
    const std::size_t before = functions.size();
    for (std::size_t e = 0; e < worst_.size(); ++e)
      if (worst_[e].upper < value) add(e, worst_[e].worst);
    return functions.size() > before;
  }

 private:
  void add(std::size_t e, const Barycentric& xi) {
    const int p = star_->degree(), moving = star_->moving(e);
    const std::span<const Point> net = star_->net(e, {});
    std::array<double, max_partials> basis;
    if (p == 2)
      std::copy_n(xi.begin(), 3, basis.begin());
    else
      bernstein_basis(p - 1, xi, basis);
    Vector along_2, along_3;
    double rate_2 = 0, rate_3 = 0;
    for (std::size_t m = 0; m < terms_->partials.size(); ++m) {
      const auto& [first, second, third] = terms_->partials[m];
      const double b = basis[m];
      const Point& from = net[static_cast<std::size_t>(first)];
      along_2 += b * (net[static_cast<std::size_t>(second)] - from);
      along_3 += b * (net[static_cast<std::size_t>(third)] - from);
      rate_2 += b * ((second == moving) - (first == moving));
      rate_3 += b * ((third == moving) - (first == moving));
    }
    if (const auto f = shape_function(along_2, along_3, rate_2, rate_3))
      functions.push_back(*f);
    else
      cap = std::min(cap, shape_of(along_2, along_3));
  }

  /// The first cuts of an element: the nodes of its own degree, and the centre.
  void sample(std::size_t e) {
    const int p = star_->degree();
    if (p > 1) {  // on a straight element tau is the same everywhere
      const NetLayout& layout = NetLayout::of(p);
      const double by = 1.0 / p;
      for (int n = 0; n < layout.size(); ++n) {
        const auto& [i, j, k] = layout.exponents(n);
        add(e, {i * by, j * by, k * by});
      }
    }
    add(e, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  }

  PlacementStar* star_ = nullptr;
  const JacobianTerms* terms_ = nullptr;
  double width_ = 0;
  std::vector<ShapeBounds> worst_;
};

Placement improve_elements(PlacementStar& star, const Point& start, double accuracy) {
  thread_local ElementShapes shapes;
  shapes.begin(star, std::max(accuracy / 4, 1e-11));
  const ShapeBounds at_start = shapes.at(star.local(start));
  Placement best{Outcome::stuck, start, at_start.lower, Program::shape};
  // A new place must be better than the start could be, whose shape is only known to be between two bounds.
  double to_beat = -std::numeric_limits<double>::infinity();
  if (star.is_certified(start)) {
    best.outcome = Outcome::placed;
    to_beat = at_start.upper;
  }
  shapes.cut(2);
  const auto look_at = [&](const Point& place) {
    const ShapeBounds there = shapes.at(star.local(place));
    if (there.lower > to_beat && star.is_certified(place)) {
      best = {Outcome::placed, place, there.lower, Program::shape};
      to_beat = there.lower;
    }
    return there;
  };
  DiskBasis basis;
  for (int round = 0; round < most_rounds && !shapes.functions.empty(); ++round) {
    const auto optimum = maximise_least(shapes.functions, basis);
    if (!optimum) break;
    const double most = std::min(basis.value, shapes.cap), width = std::max(accuracy * most, close_enough);
    if (most <= to_beat || (best.outcome == Outcome::placed && most <= best.value + width)) break;
    const Point place = star.world(optimum->place);
    const ShapeBounds there = look_at(place);
    if (there.lower >= most - width || !shapes.cut(basis.value - width / 2)) break;
    if (round < plain_rounds) continue;
    // The worst point of an element moves with the place, so that cuts at places far outside the valid ones tell little
    // about these. Now cuts are also made half way between the best place and the optimum.
    if (best.outcome != Outcome::placed && round == plain_rounds) {
      const Placement valid = untangle_point(star.degree(), star.elements(), start);
      if (valid.outcome == Outcome::hopeless) return valid;
      if (valid.outcome == Outcome::placed) {
        look_at(valid.place);
        shapes.cut(basis.value);
      }
    }
    if (best.outcome != Outcome::placed) continue;
    look_at(0.5 * best.place + 0.5 * place);
    shapes.cut(basis.value - width / 2);
  }
  return best;
}

Placement improve_control_mesh(PlacementStar& star, const Point& start) {
  thread_local std::vector<ShapeFunction> functions;
  functions.clear();
  for (std::size_t e = 0; e < star.count(); ++e) {
    const auto net = star.net(e, {});
    star.for_control_triangles(e, [&](const std::array<int, 3>& corners, std::size_t which) {
      // The moving corner q is taken as the first one, so that both columns are a fixed corner minus q.
      const Point& second = net[static_cast<std::size_t>(corners[(which + 1) % 3])];
      const Point& third = net[static_cast<std::size_t>(corners[(which + 2) % 3])];
      functions.push_back(*shape_function(second, third, -1, -1));
    });
  }
  const auto least = [&star](const Point& world_place) {
    const Point q = star.local(world_place);
    double value = 1;
    for (const ShapeFunction& f : functions) value = std::min(value, f(q));
    return value;
  };
  Placement best{star.is_certified(start) ? Outcome::placed : Outcome::stuck, start, least(start), Program::shape};
  DiskBasis basis;
  const auto optimum = maximise_least(functions, basis);
  if (!optimum || (best.outcome == Outcome::placed && optimum->value <= best.value + close_enough)) return best;
  const Point goal = star.world(optimum->place);
  if (star.is_certified(goal)) return {Outcome::placed, goal, least(goal), Program::shape};
  // Elements may be tangled at the goal although their control triangles are not. Then the goal is approached from a
  // valid place: the valid places are a convex set, and the shape rises on the way to the goal.
  if (best.outcome != Outcome::placed) {
    best = untangle_point(star.degree(), star.elements(), start);
    if (best.outcome != Outcome::placed) return best;
    best.program = Program::shape;
    best.value = least(best.place);
  }
  const Point from = best.place;
  double low = 0, high = 1;
  for (int halvings = 0; halvings < 8; ++halvings) {
    const double middle = (low + high) / 2;
    const Point place = from + middle * (goal - from);
    if (!star.is_certified(place)) {
      high = middle;
      continue;
    }
    low = middle;
    if (const double value = least(place); value > best.value) best = {Outcome::placed, place, value, Program::shape};
  }
  return best;
}

}  // namespace

Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                        PlacementMeasure measure, double accuracy) {
  assert(!elements.empty());
  thread_local PlacementStar star;
  star.begin(degree, elements);
  const Placement best = measure == PlacementMeasure::element ? improve_elements(star, start, accuracy)
                                                              : improve_control_mesh(star, start);
  return best.outcome == Outcome::placed || best.program == Program::area
             ? best
             : untangle_point(degree, elements, start, measure);
}

}  // namespace pliant
