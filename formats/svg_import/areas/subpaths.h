// formats/svg_import/areas/subpaths.h: the subpaths of an outline as Bézier pieces.
#pragma once
#include <functional>
#include <vector>

#include "formats/svg_import/areas/loops.h"

namespace pliant::svg {

/// The subpaths of an outline as pieces. `finish` is called with the pieces of each, the ends of the subpath, and
/// whether a step closes it.
class Subpaths {
 public:
  using Finish = std::function<void(std::vector<Piece>, const Point& start, const Point& end, bool is_closed)>;

  Subpaths(const LoopOptions& options, LoopCounts& counts, Finish finish, bool follows_back = false)
      : fit_(options.degree, options.tolerance / 2, follows_back), counts_(counts), finish_(std::move(finish)) {}

  void read(const Outline& outline);

 private:
  void finish(bool is_closed);
  void add(Step step, const Point* p);

  BezierFit fit_;
  LoopCounts& counts_;
  Finish finish_;
  std::vector<Piece> pieces_;
  Point start_, at_;
};

}  // namespace pliant::svg
