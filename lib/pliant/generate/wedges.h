// lib/pliant/generate/wedges.h: curves that leave a vertex in nearly the same direction, and how to split them alike.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {

/// The narrow wedges between curves: pairs of curves that leave a common vertex, the corner, at an angle of less than
/// 1e-3 radians. It would take very many splits to separate the hulls of their spans there. But where the ends of two
/// spans have the same distances from the corner, their chords are in the order of the curves, however much these bend.
class Wedges {
 public:
  /// Complexity  O(spans, and pairs of curves at each vertex)
  Wedges(const BoundaryComplex& boundary, const BoundarySpans& spans);

  /// The node at which the curves of two spans make a wedge, the one nearest to span i if there are several; -1 if
  /// none.
  int corner_between(std::size_t i, std::size_t j) const;

  /// An end of a span, and how far it is from a corner.
  struct End {
    double radius = 0;
    Point place;
  };
  /// Both ends of a span, the one nearer to the corner first. Nothing where the span's distance from the corner is not
  /// surely monotone along it.
  std::optional<std::array<End, 2>> ends(std::size_t i, int corner) const;
  /// Are two ends as far from the corner as each other: but for rounding, or but for a fifth of the distance between
  /// the two? Then the chords of spans that turn by at most 60 degrees are in the order of the curves.
  bool are_level(const End& a, const End& b) const;
  /// The parameter, in (0, 1), at which a span is that far from the corner. Requires that ends(i, corner) has a value.
  double place_at(std::size_t i, int corner, double radius) const;
  /// The parameter at which to halve a span. In a wedge it is where the distance from the corner is the mean of those
  /// of the span's ends, so that level spans stay level. Elsewhere it is 0.5.
  double middle_of(std::size_t i) const;

 private:
  int nearest(std::size_t i, const std::vector<int>& corners) const;

  const BoundarySpans& spans_;
  std::map<std::pair<int, int>, std::vector<int>> corners_;  // by two curves
  std::map<int, std::vector<int>> corners_of_;               // by a curve
  double rounding_ = 0;  // rounding of distances: some units in the last place of the largest coordinate
};

}  // namespace pliant
