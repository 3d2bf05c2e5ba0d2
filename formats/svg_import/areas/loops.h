// formats/svg_import/areas/loops.h: the closed loops that bound a filled shape, as B-splines.
#pragma once
#include <vector>

#include "formats/svg_import/areas/bezier_fit.h"
#include "formats/svg_import/areas/outline.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant::svg {

inline constexpr std::size_t max_pieces = 5'000'000;  ///< most pieces of all loops together

struct LoopOptions {
  int degree = 2;
  double tolerance = 1e-6;  ///< length: half of it is for fitting the pieces, half for joining them smoothly
  double size = 1;          ///< size of the drawing
};

/// One closed curve, or open ones that form a loop: each starts bit for bit where the one before it ends.
struct Loop {
  std::vector<BSpline> curves;
  std::vector<bool> cusps;  ///< for each curve: does it start in a cusp?
};

struct LoopCounts {
  long pieces = 0;        ///< Bézier pieces
  long fitted = 0;        ///< pieces that are not exact
  long curves = 0;        ///< cubic curves and arcs of the drawing that those stand for
  long arcs = 0;          ///< how many of them are arcs
  long smooth = 0;        ///< joins that became simple knots (degree 3: double ones)
  long corners = 0;       ///< joins that became corners
  long no_area = 0;       ///< loops without an interior, left out
  double fit_error = 0;   ///< upper bound of the distance of the pieces from the drawing (length)
  double join_error = 0;  ///< upper bound of how far smooth joins move them (length)
};

/// The loops of an outline as a fill takes them: open subpaths are closed by a line.
std::vector<Loop> make_loops(const Outline& outline, const LoopOptions& options, LoopCounts& counts);

/// The curves of an outline as a stroke follows them: those of an open subpath are open, those of a closed one closed
/// unless it has corners in cusps or runs along itself.
std::vector<BSpline> make_lines(const Outline& outline, const LoopOptions& options, LoopCounts& counts);

}  // namespace pliant::svg
