// lib/pliant/geometry/placement/affine_program.h: the place where the least of affine functions is greatest.
#pragma once
#include <array>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// q -> a x + b y + c.
struct AffineFunction {
  double a, b, c;
  double operator()(const Point& q) const { return a * q.x + b * q.y + c; }
};

/// The optimum, and what proves it: `active` are three functions whose mean with the weights `share` (some may be 0) is
/// nowhere in the square above the optimum. A side of the square may take the place of a function; its index is -1.
struct AffineOptimum {
  Point place;
  double value;
  std::array<int, 3> active;
  std::array<double, 3> share;
  bool bounded;  ///< no side of the square takes part: the optimum is that of the whole plane
};

/// Maximises the least of the functions over the square |x|, |y| <= reach; if there are several optima, the result is
/// the one nearest to `near`. This is a linear program in (x, y, value), solved by the dual simplex method: every step
/// adds the function that is violated most, and costs one pass over the functions.
///
/// Requires    at least one function; coefficients of the order of 1, reach not beyond 1e6
AffineOptimum maximise_least(std::span<const AffineFunction> functions, double reach, const Point& near = {});

}  // namespace pliant
