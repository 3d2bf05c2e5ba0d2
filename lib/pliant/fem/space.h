// lib/pliant/fem/space.h: which unknown belongs to which basis function of which element.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The unknowns of one component of a function that is a polynomial of degree q on each element, in Bernstein form.
/// They are numbered in the order in which the elements of the mesh name them.
class Space {
 public:
  /// Continuous functions of the mesh's own degree: an unknown for each control point.
  static Space continuous(const Mesh& mesh);
  /// Functions of degree q, 1 <= q <= the mesh's, that are continuous in each face and may jump across the curves c
  /// with jumps[c] != 0. A curve with the same face on both sides lets nothing jump. At a vertex a face has one value.
  static Space by_face(const Mesh& mesh, int degree, std::span<const char> jumps);

  int degree() const { return degree_; }
  int size() const { return size_; }
  int element_size() const { return net_size_; }
  /// The unknowns of an element: net_size(degree()) of them, in the order of NetLayout.
  std::span<const int> of(TriangleId t) const {
    return {unknowns_.data() + static_cast<std::size_t>(t) * static_cast<std::size_t>(net_size_),
            static_cast<std::size_t>(net_size_)};
  }
  /// Those of all elements, one after the other.
  const std::vector<int>& unknowns() const { return unknowns_; }

 private:
  Space(const Mesh& mesh, int degree);
  void number(std::span<const std::int64_t> keys, std::int64_t greatest);

  int degree_, net_size_, size_ = 0;
  std::vector<int> unknowns_;
};

}  // namespace pliant
