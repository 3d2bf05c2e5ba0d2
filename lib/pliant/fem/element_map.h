// lib/pliant/fem/element_map.h: the map of one element at the points of a rule that is fine enough for it.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/element_table.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// How integrands vary over an element, beyond its own map.
enum class Integrand {
  constant,  ///< coefficients are constant on the element
  varying    ///< they are functions of the place
};

/// The map chi of an element at the points of a quadrature rule. One object serves one element after the other.
///
/// Mass, convection and divergence with constant coefficients are polynomials of degree 4p - 2 at most, for which the
/// rule is exact; stiffness is rational, and its rule is raised where det J varies much (with
/// 4p - 2 points the error of an element matrix is below 1e-6 where min J > 0.7 max J). An element that is affine to
/// the last bits needs 2p (the mass) with constant coefficients.
class ElementMap {
 public:
  explicit ElementMap(int degree) : degree_(degree), net_(static_cast<std::size_t>(net_size(degree))) {}

  /// Maps element t with the control points of `points`, which are indexed by PointId: the mesh's own, or those of
  /// another time.
  /// Requires    an element that is valid
  void set(const Mesh& mesh, std::span<const Point> points, TriangleId t, Integrand integrand);
  /// The same with a rule that is given.
  void set(const Mesh& mesh, std::span<const Point> points, TriangleId t, const ElementTable& table);

  const ElementTable& table() const { return *table_; }
  int points() const { return table_->points; }
  bool is_affine() const { return affine_; }
  /// weight * det J at a point of the rule.
  double measure(int q) const {
    return table_->weights[static_cast<std::size_t>(q)] * det_[static_cast<std::size_t>(q)];
  }
  double det(int q) const { return det_[static_cast<std::size_t>(q)]; }
  Vector along_2(int q) const { return along_2_[static_cast<std::size_t>(q)]; }
  Vector along_3(int q) const { return along_3_[static_cast<std::size_t>(q)]; }
  Point place(int q) const;
  std::span<const Point> net() const { return net_; }

 private:
  void gather(const Mesh& mesh, std::span<const Point> points, TriangleId t);
  void map();

  int degree_;
  bool affine_ = false;
  const ElementTable* table_ = nullptr;
  std::vector<Point> net_;
  std::vector<double> det_, jacobian_;
  std::vector<Vector> along_2_, along_3_;
};

}  // namespace pliant
