// lib/pliant/flow/certify_motion.h: how far the straight motion of all control points keeps every element valid.
#pragma once
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The fraction of a motion that is proved to keep every element valid, and the element that limits it.
struct MotionCertificate {
  double fraction = 1;
  TriangleId blocking = none;
};

/// The certificate of a motion on straight lines to `points`, one for each slot. An element whose corner is at a cusp
/// of the boundary may have det J = 0 there.
MotionCertificate certify_motion(const Mesh& mesh, std::span<const Point> points);

/// How many elements are not valid.
long count_invalid(const Mesh& mesh);

}  // namespace pliant
