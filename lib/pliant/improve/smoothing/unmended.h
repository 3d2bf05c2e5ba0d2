// lib/pliant/improve/smoothing/unmended.h: elements that smoothing leaves invalid or too curved, and why.
#pragma once
#include <string>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Why an element stays too curved, or invalid.
enum class Unmended {
  smooth_corner,     ///< two edges on curves meet in it so that det J <= 0 there, whatever else moves
  needs_split,       ///< splitting its edge on a curve helps
  needs_refinement,  ///< that would help it, but the least shape or scaled Jacobian of the mesh would fall
  turned_over,       ///< its logical triangle is not counter-clockwise: a vertex is in a wrong place
  no_better_place,   ///< nothing that was allowed makes the element better
};
/// What a smoother was allowed to do. What it was not allowed to do may help.
struct SmoothMeans {
  bool vertices = false, flips = false, split = false;
};
/// The reason in a few words, and which option that was not allowed may help.
std::string describe(Unmended reason, const SmoothMeans& means);

struct UnmendedElement {
  TriangleId element;
  Point place;  ///< its centre
  Unmended reason;
};
/// The element with its reason, as far as the element alone shows it: needs_split and needs_refinement are never
/// returned, since they depend on what a split would do.
UnmendedElement explain_unmended(const Mesh& mesh, TriangleId t);

}  // namespace pliant
