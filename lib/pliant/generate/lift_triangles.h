// lib/pliant/generate/lift_triangles.h: Bézier triangles over a planar mesh, certified (paper §6).
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/generate/planar_mesh.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The mesh of degree p over a planar mesh: constrained edges are the curves' spans, all others straight with equally
/// spaced control points; inner control points take up the edges' displacement, fading towards the opposite corner.
/// Elements that are then not valid are untangled by their inner edges' control points, one at a time.
class LiftedMesh {
 public:
  /// Requires spans of degree `degree`.
  LiftedMesh(int degree, const BoundarySpans& spans, const PlanarMesh& planar);

  /// Certifies, untangles; the elements (numbers in the planar mesh) that stay without certificate. No control point
  /// moves by more than `most_bending` times its element's extent.
  std::vector<int> untangle(double most_bending);

  long untangled() const { return untangled_; }
  /// Nodes with a corner of tangent angle 0, in ascending order.
  const std::vector<int>& cusps() const { return cusps_; }
  /// Points, triangles, faces and constrained edges; points that belong to no triangle are left out.
  void write(MeshData& data) const;

 private:
  std::span<const int> net(int t) const;
  bool is_valid(int t) const;
  void number_points();
  void place_points();
  void find_cusps();
  bool untangle_element(int t, double most_bending);
  std::optional<std::array<Vector, max_degree + 1>> bend_beside(int t, int long_edge, bool at_origin) const;
  void bend_interior(int t, int corner, const std::array<Vector, max_degree + 1>& bend);
  bool bend_tip(int t);
  bool bend_along_curves(int t);
  std::optional<Point> valid_place(int t, int k);

  int degree_;
  const BoundarySpans& spans_;
  const PlanarMesh& planar_;
  std::vector<int> nets_;  // net_size indices a triangle
  std::vector<Point> points_;
  std::vector<int> cusp_corner_;  // of each triangle; -1: none
  std::vector<int> cusps_;
  long untangled_ = 0;
};

}  // namespace pliant
