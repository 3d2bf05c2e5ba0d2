// lib/pliant/ops/trial_patch.h: the control points of a few elements, moved on a copy before any is in the mesh.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

enum class SmoothGoal { untangle, improve };

/// A copy of the nets of some elements on which smoothers try places out: nothing of it is in the mesh, and no field is
/// fitted, until `apply`. Memory is reused from one patch to the next.
class TrialPatch {
 public:
  void capture(const Mesh& mesh, std::span<const TriangleId> elements);

  std::size_t count() const { return elements_.size(); }
  TriangleId element(std::size_t e) const { return elements_[e]; }
  /// The net of the e-th element, as moved.
  std::span<const Point> net(std::size_t e) const { return {nets_.data() + e * size_, size_}; }
  bool has(std::size_t e, PointId p) const;
  const Point& point(PointId p) const;
  void move(PointId p, const Point& to);

  using Nets = std::vector<Point>;
  const Nets& nets() const { return nets_; }
  void set_nets(const Nets& nets) { nets_ = nets; }
  void reset() { nets_ = old_; }

  /// Places these points one after the other by optimal placement over the elements of the patch that have them. True
  /// if any moved.
  bool place(std::span<const PointId> points, SmoothGoal goal, PlacementMeasure measure = PlacementMeasure::element);
  /// Scales the displacement of an edge's inner control points from straight by `keep`, and blends the inner points of
  /// the elements on its sides from their edges.
  void straighten(const Mesh& mesh, HalfEdgeId h, double keep);
  /// Blends the inner points of an element from its edges: each edge's displacement fades towards the opposite corner.
  void blend(const Mesh& mesh, TriangleId t);
  /// Moves vertex v of the elements by `shift`, and the other control points with it: in proportion to their
  /// barycentric coordinate of v, so that straight elements stay straight.
  void drag(PointId v, const Vector& shift);

  /// Moves the mesh's points to where they are here, and refits their fields over the elements (paper §5.2.4). On
  /// tangled elements, where the old function has several values in a place, one of them is taken, the signed integral
  /// is kept where limited values can have it, and values are limited also where options.projection is `conservative`.
  /// With `must_be_valid` refuses, the mesh unchanged, unless all elements are certified valid.
  Outcome apply(Mesh& mesh, const RefitOptions& options, bool must_be_valid) const;

 private:
  int degree_ = 0;
  std::size_t size_ = 0;  // of a net
  std::vector<TriangleId> elements_;
  std::vector<PointId> ids_;  // of all nets, one after the other
  Nets nets_, old_;
  std::vector<PlacementElement> around_;
};

}  // namespace pliant
