// lib/pliant/generate/lift_triangles.h: makes Bézier triangles of a planar mesh, and certifies them (paper §6).
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/generate/planar_mesh.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// A mesh of Bézier triangles over a planar mesh. Constrained edges become the spans of the curves. All other edges are
/// straight, with equally spaced control points. The control points inside an element follow the displacement of its
/// edges, less and less towards the opposite corner. Elements that are not valid then are untangled: control points of
/// inner edges and inside elements are moved, mostly one at a time.
class LiftedMesh {
 public:
  /// Requires that the spans have degree `degree`. References are kept.
  LiftedMesh(int degree, const BoundarySpans& spans, const PlanarMesh& planar);

  /// Certifies the elements and untangles those that are not valid. Returns those that stay without certificate, by
  /// their numbers in the planar mesh. A control point that is moved alone moves by at most `most_bending` times the
  /// extent of its element.
  std::vector<int> untangle(double most_bending);

  /// How many elements untangle() has made valid.
  long untangled() const { return untangled_; }
  /// The nodes at which two spans have the same tangent, ascending.
  const std::vector<int>& cusps() const { return cusps_; }
  /// Writes points, triangles, faces and constrained edges. Points that belong to no triangle are left out.
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
  std::vector<int> nets_;  // net_size indices for each triangle
  std::vector<Point> points_;
  std::vector<int> cusp_corner_;  // the corner of each triangle that is a cusp; -1: none
  std::vector<int> cusps_;
  long untangled_ = 0;
};

}  // namespace pliant
