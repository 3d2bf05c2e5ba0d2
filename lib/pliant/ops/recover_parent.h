#pragma once  // lib/pliant/ops/recover_parent.h: the element of which others are a de Casteljau subdivision
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// One piece: its rows and where its corners lie in the parent.
struct PieceOfParent {
  std::span<const double> rows;
  Barycentric a, b, c;
};

/// Completes the rows of `parent` that are not `known` so that every piece is the parent's sub-net there; false where
/// no parent fits within `tolerance` (length; for field columns times their largest value over `size`).
/// Complexity  O(pieces * net_size²) arithmetic
bool recover_parent(int degree, int width, std::span<const PieceOfParent> pieces, std::span<const char> known,
                    std::span<double> parent, double tolerance, double size);

}  // namespace pliant
