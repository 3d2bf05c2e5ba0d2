// lib/pliant/evolve/steadiness.h: how fast a velocity that the mesh carries changes at fixed places.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Compares a velocity field with what it was before a step, at the places where the vertices were then.
class Steadiness {
 public:
  /// Remembers the field.
  /// Requires    a field of two components that is not by face
  Steadiness(const Mesh& mesh, int field);

  /// The greatest change of the velocity since then, over the greatest speed at a vertex, per unit of time; 0 where
  /// nothing moves. Places that the mesh has left do not count.
  /// Requires    a later time than then
  /// Complexity  O(mesh)
  double rate(const Mesh& mesh, int field) const;

 private:
  double time_;
  std::vector<Point> places_;  // in the units of the document
  std::vector<Vector> values_;
};

}  // namespace pliant
