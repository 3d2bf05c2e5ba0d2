// lib/pliant/improve/smoothing/curve_splits.h: splits edges on curves where that helps the elements beside them
// (private to smooth_curves).
#pragma once
#include <map>
#include <span>
#include <vector>

#include "pliant/improve/smoothing/smoothing_moves.h"
#include "pliant/improve/smoothing/worst_first.h"

namespace pliant {

/// Tries splits of edges on curves, one at a time.
class CurveSplits {
 public:
  enum class Effect {
    useless,             ///< no edge of the element is on a curve, or the worst new element would be as bad
    makes_others_worse,  ///< it would help, but what is guarded (SmoothingMoves::guard) would fall
    helps
  };
  CurveSplits(Mesh& mesh, SmoothingMoves& moves) : mesh_(mesh), moves_(moves) {}

  /// Splits an edge of each of these elements where that helps; elements that have not changed since a split did not
  /// help are left out. Returns the elements that the splits have made or changed.
  std::vector<TriangleId> split(std::span<const TriangleId> elements, const WorstFirst& visits);
  /// What a split of an edge of this element would do; it is undone.
  Effect effect_on(TriangleId t);
  long count() const { return count_; }

 private:
  Effect try_split(TriangleId t, bool keeps);

  Mesh& mesh_;
  SmoothingMoves& moves_;
  std::vector<TriangleId> changed_;
  std::map<TriangleId, long> failed_;  // elements that a split did not help, and when that was
  long count_ = 0;
};

}  // namespace pliant
