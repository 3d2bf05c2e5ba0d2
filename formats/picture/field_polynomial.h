// formats/picture/field_polynomial.h: a field on each element as one polynomial, for bounds and curves of equal values.
#pragma once
#include <span>
#include <vector>

#include "formats/picture/coloring.h"

namespace pliant {

/// A component of a field, or the squared length of several, as polynomials in Bernstein form. They are divided by a
/// power of two (its square), so that no coefficient of a component is above 1 and squares are in the range of doubles.
class FieldPolynomial {
 public:
  /// Keeps references to both.   Requires    values.is_field()
  FieldPolynomial(const MeshData& mesh, const ElementValues& values);

  int degree() const { return squared_ ? 2 * mesh_.degree : mesh_.degree; }
  /// The coefficients on an element, in the order of NetLayout.
  const std::vector<double>& on_element(TriangleId t);
  /// The coefficients on edge e of an element, from the end with the lower index: the same bits from either side,
  /// unless the field differs by face.
  std::vector<double> on_edge(TriangleId t, int e);
  /// Between a value of the field and that of the polynomial: NaN for a length below 0.
  double from_field(double value) const;
  double to_field(double value) const;
  bool depends_on_face() const { return values_.depends_on_face(); }

 private:
  void load(TriangleId t);
  double row(std::size_t point, std::size_t component) const;

  const MeshData& mesh_;
  const ElementValues& values_;
  bool squared_;
  std::size_t first_, components_, width_;
  double scale_ = 1;
  std::vector<double> rows_, result_;
};

/// The least and the greatest value that the function takes, over all elements but those of `without` (in ascending
/// order): of a metric as they are, of a field to 1e-7 of their difference.
ValueRange exact_range(const MeshData& mesh, const ElementValues& values, std::span<const TriangleId> without);

}  // namespace pliant
