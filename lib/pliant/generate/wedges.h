// lib/pliant/generate/wedges.h: curves that leave a vertex in nearly the same direction, and spans of equal reach
// there.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {

/// The narrow wedges between curves: pairs of curves that leave a common vertex, the corner, under less than 1e-3
/// radians. No splits separate the hulls of their spans there but very many; but where the ends of two spans have the
/// same distances from the corner, their chords are in the order of the curves, however much these bend.
class Wedges {
 public:
  /// Complexity  O(spans, and pairs of curves at each vertex)
  Wedges(const BoundaryComplex& boundary, const BoundarySpans& spans);

  /// The corner between the curves of two spans that is nearest to the first, a node; none: -1.
  int corner_between(std::size_t i, std::size_t j) const;

  /// An end of a span, and how far it is from a corner.
  struct End {
    double radius = 0;
    Point place;
  };
  /// Both ends of a span, the nearer first; nothing where it does not lead straight away from the corner or towards it.
  std::optional<std::array<End, 2>> ends(std::size_t i, int corner) const;
  /// As far from the corner, but for rounding, or compared with how far they are apart across the wedge: spans that
  /// turn by at most 60 degrees have chords in the same order then.
  bool are_level(const End& a, const End& b) const;
  /// The parameter, in (0, 1), at which a span is that far from the corner.   Requires ends(i, corner)
  double place_at(std::size_t i, int corner, double radius) const;
  /// Where to halve a span: in a wedge at the mean of its ends' distances from the corner, so that two spans of equal
  /// reach stay so; elsewhere at the middle of its parameters.
  double middle_of(std::size_t i) const;

 private:
  int nearest(std::size_t i, const std::vector<int>& corners) const;

  const BoundarySpans& spans_;
  std::map<std::pair<int, int>, std::vector<int>> corners_;  // by two curves
  std::map<int, std::vector<int>> corners_of_;               // by a curve
  double rounding_ = 0;  // of distances: some units in the last place of the largest coordinate
};

}  // namespace pliant
