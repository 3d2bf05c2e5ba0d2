// lib/pliant/improve/smoothing/unmended.h: elements that smoothing leaves invalid or too curved, and why.
#pragma once
#include <string>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Why an element stays too curved, or invalid.
enum class Unmended {
  smooth_corner,     ///< two edges on curves meet where det J <= 0, whatever moves
  needs_split,       ///< splitting its edge on a curve helps
  needs_refinement,  ///< it would, but the mesh's least shape or scaled Jacobian would fall
  turned_over,       ///< its straight triangle is not counter-clockwise: a vertex is in a wrong place
  no_better_place,   ///< nothing that was allowed makes it better
};
/// What a smoother was allowed to do; what it was not may help.
struct SmoothMeans {
  bool vertices = false, flips = false, split = false;
};
/// The reason in a few words, with what may help beyond what was allowed.
std::string describe(Unmended reason, const SmoothMeans& means);

struct UnmendedElement {
  TriangleId element;
  Point place;  ///< its centre
  Unmended reason;
};
/// The element with its reason as far as the element alone tells it: never by what a split would do.
UnmendedElement explain_unmended(const Mesh& mesh, TriangleId t);

}  // namespace pliant
