#pragma once  // lib/pliant/geometry/invert_map.h: Newton's method for chi(xi) = p (paper §5.2.1)
#include <optional>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// The barycentric coordinates of p, by damped Newton from `start` (default: the barycentric coordinates in the
/// straight triangle), also where they lie outside [0, 1] (up to `reach` outside). Empty when Newton does not converge
/// to |chi(xi) - p| <= tolerance.
std::optional<Barycentric> invert_map(int degree, std::span<const Point> net, const Point& p, double tolerance,
                                      const Barycentric* start = nullptr, double reach = 1.0);

/// The barycentric coordinates of p inside the closed element, by subdivision of the control net's boxes and Newton in
/// the pieces: finds p whenever the (valid) element contains it. Coordinates are clamped to >= -1e-12.
std::optional<Barycentric> invert_map_by_subdivision(int degree, std::span<const Point> net, const Point& p,
                                                     double tolerance);

}  // namespace pliant
