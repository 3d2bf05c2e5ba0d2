// lib/pliant/fem/edge_map.h: edges on curves, for integrals along them.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/quadrature.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The edges of each curve, one half-edge an edge: that on the curve's left if a face is there, else on its right.
std::vector<std::vector<HalfEdgeId>> curve_edges(const Mesh& mesh);

/// An edge at the points of a Gauss rule. One object serves one edge after the other.
class EdgeMap {
 public:
  explicit EdgeMap(int degree);
  /// Maps the edge with the control points of `points`, which are indexed by PointId.
  void set(const Mesh& mesh, std::span<const Point> points, HalfEdgeId h);

  int points() const { return static_cast<int>(rule_.size()); }
  /// weight * length of the derivative at a point of the rule: they sum to the length of the edge.
  double measure(int q) const { return measures_[static_cast<std::size_t>(q)]; }
  /// The degree + 1 basis functions of the edge there, from the half-edge's origin to its target.
  std::span<const double> values_at(int q) const;
  /// Their derivatives along the edge's parameter, which runs from 0 to 1.
  std::span<const double> derivatives_at(int q) const;
  double weight(int q) const { return rule_[static_cast<std::size_t>(q)].weight; }
  /// The derivative of the place with respect to that parameter.
  Vector along(int q) const { return along_[static_cast<std::size_t>(q)]; }
  Point place(int q) const;
  Barycentric xi(int q) const;  ///< in the half-edge's triangle

 private:
  int degree_, edge_ = 0;
  std::span<const SegmentNode> rule_;
  std::vector<double> values_, derivatives_, measures_;
  std::vector<Vector> along_;
  std::vector<Point> polygon_;
};

}  // namespace pliant
