// lib/pliant/ops/refit/third_derivatives.h: third derivatives of displacements, which flips must not enlarge.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// The derivatives xxx, xxy, xyy, yyy of a function; or those along (2, 2, 2), (2, 2, 3), (2, 3, 3), (3, 3, 3), where 2
/// and 3 are the sides from the first corner of a triangle.
using Thirds = std::array<double, 4>;
/// How often each is among the eight of the symmetric tensor.
inline constexpr Thirds third_counts{1, 3, 3, 1};

/// Turns derivatives along the sides of a straight triangle into those along x and y.
class ThirdsInPlane {
 public:
  /// Requires    a triangle that is not degenerate
  ThirdsInPlane(const Point& a, const Point& b, const Point& c);
  Thirds operator()(const Thirds& along_sides) const;

 private:
  std::array<Thirds, 4> rows_;
};

/// The third derivatives along the sides of polynomials of a degree, themselves polynomials of degree - 3.
///
/// Shapes      net: two doubles (a vector) for each control point; out: for each of the four derivatives the two
///             components, each with net_size(degree - 3) coefficients
/// Requires    degree >= 3
void third_differences(int degree, std::span<const double> net, std::span<double> out);

/// The third derivatives along the sides of all basis functions at the nodes of node_basis(degree): node after node,
/// each with net_size(degree) of them. Built once for each degree; thread-safe.   Requires    degree >= 3
const std::vector<Thirds>& thirds_at_nodes(int degree);

}  // namespace pliant
