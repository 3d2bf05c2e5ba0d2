// lib/pliant/fem/coefficient.h: coefficients of an equation, as functions of place, time and the mesh's fields.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "pliant/geometry/point.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Where a coefficient is asked for its value.
struct CoefficientPoint {
  const Mesh& mesh;  ///< its fields are those that the coefficient may use; its control points may be of another time
  TriangleId triangle;
  Barycentric xi;
  Point place;  ///< in the document's units, also where the mesh is in another (normalize_unit)
  double time;
};

/// A number or a function. A value that is not finite, or out of the range that its use allows, is refused by whoever
/// asked for it, with place, time and `name`.
class Coefficient {
 public:
  using Function = std::function<double(const CoefficientPoint&)>;

  explicit Coefficient(double value) : constant_(value) {}
  /// `name` is what messages call it: where it stands in the problem (a JSON pointer), a colon, and its text.
  Coefficient(Function function, std::string name) : function_(std::move(function)), name_(std::move(name)) {}
  Coefficient(double value, std::string name) : constant_(value), name_(std::move(name)) {}

  double operator()(const CoefficientPoint& at) const { return constant_ ? *constant_ : function_(at); }
  const std::optional<double>& constant() const { return constant_; }
  const std::string& name() const { return name_; }

 private:
  std::optional<double> constant_;
  Function function_;
  std::string name_;
};

/// What a coefficient is at a place.   Throws InputError where it is not finite
double evaluate_at(const Coefficient& coefficient, const CoefficientPoint& at);

/// Throws the InputError that says where and when a coefficient has a value that is not `what` it must be.
[[noreturn]] void refuse_value(const Coefficient& coefficient, double value, const Point& place, double time,
                               const char* what);

}  // namespace pliant
