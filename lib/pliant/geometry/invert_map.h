// lib/pliant/geometry/invert_map.h: which barycentric coordinates an element's map takes to a point (paper §5.2.1).
#pragma once
#include <optional>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// The barycentric coordinates xi with chi(xi) = p, by damped Newton steps from `start`, or else from the coordinates
/// of p in the straight triangle. They may lie outside the element: each is in [-reach, 1 + reach].
///
/// Refuses     empty when Newton does not converge to |chi(xi) - p| <= tolerance
std::optional<Barycentric> invert_map(int degree, std::span<const Point> net, const Point& p, double tolerance,
                                      const Barycentric* start = nullptr, double reach = 1.0);

/// What `find_in_element` found out about a point and a closed element.
enum class SearchAnswer { found, absent, undecided };
struct ElementSearch {
  SearchAnswer answer = SearchAnswer::undecided;
  Barycentric xi{};  ///< if found, the coordinates of the point, none of them below -1e-12
};

/// Whether the closed element contains p, by bisection of its control net, with Newton in pieces that are nearly
/// straight. The answer depends neither on Newton's convergence nor on the map being injective:
///
///   found      |chi(xi) - p| <= tolerance
///   absent     this is proved for the doubles as stored: pieces cover the
///              element, and a line separates p from the control net of each
///              by more than all rounding errors
///   undecided  20000 pieces showed neither
///
/// A tolerance below rounding is raised to 64 degree 2^-53 times the greatest distance, in x or y, between p and a
/// control point. Only an element that is folded, or flat along a line, leaves the question undecided.
///
/// Complexity  O(degree^3) for each piece; in elements with det J > 0 only few
///             pieces of each size come near p, so their count grows like
///             log(element size / distance of p from the element's boundary)
ElementSearch find_in_element(int degree, std::span<const Point> net, const Point& p, double tolerance);

}  // namespace pliant
