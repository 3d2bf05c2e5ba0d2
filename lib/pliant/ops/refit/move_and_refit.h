// lib/pliant/ops/refit/move_and_refit.h: a move of control points, with the refit of fields and the checks around it.
#pragma once
#include <span>

#include "pliant/ops/build_triangle.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {

/// Runs `move`, which moves the given points of the mesh, then refits fields at these points over the elements.
///
/// Refuses     elements that are not all valid after the move (would_invert); an integral that limited values cannot
///             keep
template <class Move>
Outcome move_and_refit(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
                       const RefitOptions& options, Move move) {
  const bool was_valid = all_valid(mesh, elements);
  Transaction transaction(mesh);
  thread_local Patch patch;
  patch.capture(mesh, elements);
  move();
  if (!all_valid(mesh, elements)) return Outcome::would_invert;
  if (!patch.fit_fields(mesh, elements, points, options, was_valid)) return Outcome::loses_integral;
  transaction.commit();
  return Outcome::done;
}

}  // namespace pliant
