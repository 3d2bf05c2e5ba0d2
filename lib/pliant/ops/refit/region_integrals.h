// lib/pliant/ops/refit/region_integrals.h: integrals of fields over some elements, taken before and after a change.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The integral of every component of every field over some elements: one over all of them, and one over those of each
/// face. Memory is reused from call to call.
class RegionIntegrals {
 public:
  void take(const Mesh& mesh, std::span<const TriangleId> elements);
  /// The largest change of an integral from these to `now`, relative to the integral of the absolute control values.
  /// Requires    integrals over elements of the same faces
  double change_to(const RegionIntegrals& now) const;
  /// Changes the control values of the elements, as little as possible, so that the integrals over the whole mesh
  /// become what they were when these were taken; `now` are the integrals over the elements as they are.
  void restore(Mesh& mesh, std::span<const TriangleId> elements, const RegionIntegrals& now) const;

 private:
  std::size_t place(int column, FaceId f, bool by_face) const;
  double sum_of(int column, FaceId f, bool by_face) const;
  std::vector<FaceId> faces_;
  // For each column: over all elements, then over those of each face. The integral, and the sum of its absolute terms.
  std::vector<double> sums_, sizes_;
};

}  // namespace pliant
