// lib/pliant/geometry/placement/disk_program.h: the place where the least shape of many triangles is greatest.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// How the shape tau at one point of an element depends on the place q of one control point:
/// tau(q) = 2 v.r / (|r|^2 + |v|^2), r = q - base. So tau >= t > 0 in the disk with centre base + v / t and radius
/// |v| sqrt(1 / t^2 - 1), and 1 / tau is a convex function where it is positive.
struct ShapeFunction {
  Point base;
  Vector v;
  double operator()(const Point& q) const {
    const Vector r = q - base;
    return 2 * dot(v, r) / (squared_length(r) + squared_length(v));
  }
};

struct DiskOptimum {
  Point place;
  double value;  ///< the least of the functions at the place
};

/// The functions that determine an optimum, and the optimum. When functions are added, the old basis is a good start
/// for the new optimum.
struct DiskBasis {
  std::array<std::size_t, 3> members{};
  std::size_t count = 0;  ///< 0: none is known
  Point place;
  double value = 1;  ///< what all members are at the place
};

/// Maximises the least of the functions. This is a quasiconvex program, whose optimum is determined by at most three
/// functions (Amenta, Bern, Eppstein 1999). They are exchanged one by one. The optimum of two is where their disks
/// first touch, in closed form; the optimum of three is where their circles meet, by Newton's method. The value is
/// within 1e-10 of the optimum; empty if no place has values above 1e-10.
///
/// Requires    at least one function; sizes of the order of 1; `basis` is empty, or what the program left behind when
///             it was solved with the first of these functions
std::optional<DiskOptimum> maximise_least(std::span<const ShapeFunction> functions, DiskBasis& basis);
inline std::optional<DiskOptimum> maximise_least(std::span<const ShapeFunction> functions) {
  DiskBasis basis;
  return maximise_least(functions, basis);
}

}  // namespace pliant
