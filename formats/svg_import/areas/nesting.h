// formats/svg_import/areas/nesting.h: what lies on either side of loops that neither cross nor touch.
#pragma once
#include <optional>
#include <vector>

#include "formats/svg_import/areas/loops.h"
#include "pliant/geometry/point.h"

namespace pliant::svg {

/// A loop with the shape that it belongs to.
struct ShapeLoop {
  int shape;
  const Loop* loop;
};

inline constexpr int nothing = -1;

/// The shapes that fill the points just inside and just outside of a loop, or `nothing`.
struct Sides {
  int inner = nothing, outer = nothing;
  bool is_counterclockwise = false;
};

/// Two shapes that fill the same points.
struct Overlap {
  int over, under;  ///< numbers of the shapes
  Point place;      ///< a point on a loop of `over`, inside of `under`
};

struct Nesting {
  std::vector<Sides> sides;       ///< of each loop
  std::vector<Overlap> overlaps;  ///< at most most_overlaps; where there are any, `sides` means nothing
};
inline constexpr std::size_t most_overlaps = 20;

/// Counts the windings of every shape around the points beside each loop. `even_odd` tells each shape's fill rule.
/// Requires    loops that do not meet, as check_boundary_geometry finds out
/// Complexity  O(n log n + pairs of boxes that overlap), n parts of curves with monotone x
Nesting nest(const std::vector<ShapeLoop>& loops, const std::vector<bool>& even_odd);

}  // namespace pliant::svg
