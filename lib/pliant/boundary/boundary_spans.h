// lib/pliant/boundary/boundary_spans.h: the Bézier spans of all curves, and the nodes that join them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/geometry/describe.h"

namespace pliant {

/// One knot span of one curve. Nodes are numbered: first the boundary's vertices, then every curve's inner breaks.
struct BoundarySpan {
  int curve;
  int index;      ///< of the span on its curve
  double t0, t1;  ///< its knots
  int from, to;   ///< nodes; two spans have a common end exactly if they have a common node
  std::size_t first_point;
  int degree;
};

/// All spans of a boundary complex with their Bézier polygons.
class BoundarySpans {
 public:
  /// Requires check_boundary(boundary) to be empty.   Complexity O(control points * degree^2)
  explicit BoundarySpans(const BoundaryComplex& boundary);

  const std::vector<BoundarySpan>& spans() const { return spans_; }
  const BoundarySpan& operator[](std::size_t i) const { return spans_[i]; }
  std::size_t size() const { return spans_.size(); }
  const std::vector<Point>& nodes() const { return nodes_; }
  /// degree + 1 control points, in the curve's direction; the ends equal the nodes bit for bit.
  std::span<const Point> polygon(std::size_t i) const {
    return {points_.data() + spans_[i].first_point, static_cast<std::size_t>(spans_[i].degree) + 1};
  }
  Box box(std::size_t i) const;

 private:
  std::vector<BoundarySpan> spans_;
  std::vector<Point> points_;
  std::vector<Point> nodes_;
};

/// "curve 'wall' (2)": the name, or only the number where it has none.
std::string describe_curve(const BoundaryComplex& boundary, int curve);
/// What the point of a node is: "vertex 3 (0, 1)", or "curve 'wall' (2) at parameter 0.5, (0.25, 1)".
std::string describe_node(const BoundaryComplex& boundary, const BoundarySpans& spans, int node);

}  // namespace pliant
