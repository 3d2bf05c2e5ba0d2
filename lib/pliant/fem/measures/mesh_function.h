// lib/pliant/fem/measures/mesh_function.h: what is measured on a mesh: a component of a field, or an expression.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "pliant/fem/coefficient.h"

namespace pliant {

/// A function on the elements of a mesh, evaluated in one element after the other.
class MeshFunction {
 public:
  /// A component of a field; a field by face has the values of the element's own face.
  MeshFunction(const Mesh& mesh, int field, int component);
  MeshFunction(const Mesh& mesh, Coefficient coefficient);

  bool is_field() const { return !coefficient_; }
  /// Turns to the element t.
  void set(TriangleId t);
  /// The value at xi, where `basis` are the mesh's basis functions there.   Throws InputError where it is not finite
  double at(const Barycentric& xi, std::span<const double> basis) const;
  double at(const Barycentric& xi) const;
  /// The control values in the element.   Requires    is_field()
  std::span<const double> control_values() const { return values_; }

 private:
  const Mesh* mesh_;
  int field_ = none, component_ = 0;
  std::optional<Coefficient> coefficient_;
  TriangleId triangle_ = none;
  std::vector<double> values_;
};

}  // namespace pliant
