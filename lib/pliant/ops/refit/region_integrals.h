// lib/pliant/ops/refit/region_integrals.h: integrals of the fields over elements whose region is about to change.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The integral of every component of every field over some elements; of a field by face, one for each face.
/// Memory is reused from call to call.
class RegionIntegrals {
 public:
  void take(const Mesh& mesh, std::span<const TriangleId> elements);
  /// Largest difference of two, of the same faces, relative to the integrals of the fields' absolute control values.
  double change_to(const RegionIntegrals& now) const;
  /// Changes the control values of the elements, least change, so that the integrals over the mesh become what they
  /// were: more by what is missing in these elements. `now`: taken of the same elements.
  void restore(Mesh& mesh, std::span<const TriangleId> elements, const RegionIntegrals& now) const;

 private:
  std::size_t place(int column, FaceId f, bool by_face) const;
  double sum_of(int column, FaceId f, bool by_face) const;
  std::vector<FaceId> faces_;
  std::vector<double> sums_, sizes_;  // of each column, of all faces and then of each
};

}  // namespace pliant
