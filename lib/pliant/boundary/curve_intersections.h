// lib/pliant/boundary/curve_intersections.h: where do two Bézier curves meet? Bézier clipping.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Parameters in [0, 1] on two curves at which they meet.
struct Meeting {
  double s, t;
};

/// Which ends of two curves are known to be the same point (bit for bit): meetings there are not reported.
struct CommonEnds {
  bool start_start = false, start_end = false, end_start = false, end_end = false;
};

/// Where two curves meet. Reported are crossings, to the last digits that the angle allows; the ends of stretches along
/// which the curves are closer than `tolerance` (overlaps, tangential contacts); and ends of one curve that are that
/// close to the other. A place may be reported more than once, a few tolerances apart. Near a common end the tolerance
/// shrinks in proportion to the distance from it, so that curves which are tangent there do not overlap.
///
/// The search uses Bézier clipping; Newton's method where the ranges of the tangents are apart; halving where clipping
/// does not help.
///
/// Requires    both curves are monotone in x and in y
/// Complexity  bounded: at most 4000 pairs of parts; curves that need more are taken to meet where the search ended
std::vector<Meeting> find_meetings(std::span<const Point> a, std::span<const Point> b, const CommonEnds& common,
                                   double tolerance);

/// Only those meetings at which an end of one curve lies on the other; again without common ends.
std::vector<Meeting> find_end_meetings(std::span<const Point> a, std::span<const Point> b, const CommonEnds& common,
                                       double tolerance);

}  // namespace pliant
