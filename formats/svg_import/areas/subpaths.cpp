// formats/svg_import/areas/subpaths.cpp: the subpaths of an outline as Bézier pieces.
#include "formats/svg_import/areas/subpaths.h"

#include <algorithm>

#include "pliant/boundary/fault.h"

namespace pliant::svg {

void Subpaths::read(const Outline& outline) {
  std::size_t next = 0;
  for (const Step step : outline.steps) {
    add(step, outline.points.data() + next);
    next += static_cast<std::size_t>(point_count(step));
    if (pieces_.size() + static_cast<std::size_t>(counts_.pieces) > max_pieces)
      throw InputError("", "the curves need more than " + std::to_string(max_pieces) +
                               " pieces; a greater --tolerance, or --degree 3, takes fewer");
  }
  finish(false);
  counts_.fit_error = std::max(counts_.fit_error, fit_.error());
}

void Subpaths::finish(bool is_closed) {
  std::vector<Piece> done;
  std::swap(done, pieces_);
  if (!done.empty()) finish_(std::move(done), start_, at_, is_closed);
}

void Subpaths::add(Step step, const Point* p) {
  const std::size_t before = pieces_.size();
  switch (step) {
    case Step::move:
      finish(false);
      start_ = at_ = p[0];
      break;
    case Step::close:
      finish(true);
      at_ = start_;
      break;
    case Step::line: {
      Piece line;
      line.points[0] = at_;
      line.points[1] = at_ = p[0];
      pieces_.push_back(line);
      break;
    }
    case Step::quadratic:
      fit_.add_quadratic(at_, p[0], p[1], pieces_);
      at_ = p[1];
      break;
    case Step::cubic:
      fit_.add_cubic({at_, p[0], p[1], p[2]}, pieces_);
      at_ = p[2];
      break;
    case Step::arc:
      fit_.add_arc(at_, p[0], p[1], p[2], p[3].x, p[3].y, p[4], pieces_);
      at_ = p[4];
      break;
  }
  if (pieces_.size() <= before || !pieces_[before].fitted) return;
  ++counts_.curves;
  counts_.arcs += step == Step::arc ? 1 : 0;
}

}  // namespace pliant::svg
