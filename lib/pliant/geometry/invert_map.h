// lib/pliant/geometry/invert_map.h: Newton's method for chi(xi) = p (paper §5.2.1).
#pragma once
#include <optional>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// The barycentric coordinates of p, by damped Newton from `start` (default: the barycentric coordinates in the
/// straight triangle), also where they lie outside [0, 1] (up to `reach` outside). Empty when Newton does not converge
/// to |chi(xi) - p| <= tolerance.
std::optional<Barycentric> invert_map(int degree, std::span<const Point> net, const Point& p, double tolerance,
                                      const Barycentric* start = nullptr, double reach = 1.0);

/// What `find_in_element` knows of a point and a closed element.
enum class SearchAnswer { found, absent, undecided };
struct ElementSearch {
  SearchAnswer answer = SearchAnswer::undecided;
  Barycentric xi{};  ///< where found; no coordinate below -1e-12
};

/// Whether the closed element contains p, by bisection of its control net, with Newton in pieces that are nearly
/// straight. It depends neither on Newton's convergence nor on the map being injective:
///   found      |chi(xi) - p| <= tolerance, by evaluation
///   absent     a proof, for the doubles as stored: the pieces cover the element, and a line separates p from each of
///              their control nets, by more than the bound of all rounding errors
///   undecided  20000 pieces did neither
/// Requires a tolerance above rounding (it is raised to 64 p u times the element's reach from p).
///
/// Complexity  O(p^3) a piece; for elements with det J > 0 the pieces of one size that come near p are few, so some
///             log(size / distance of p from the boundary); *undecided* takes an element that is folded, or flat along
///             a line
ElementSearch find_in_element(int degree, std::span<const Point> net, const Point& p, double tolerance);

}  // namespace pliant
