// lib/pliant/ops/trial_patch.h: a copy of a few elements on which moves are tried before the mesh is changed.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

enum class SmoothGoal {
  untangle,  ///< raise the least coefficient of det J
  improve    ///< raise the least shape tau
};

/// A copy of the nets of some elements, on which smoothers try places out. The mesh is not changed, and no field is
/// fitted, before `apply`. Memory is reused from one patch to the next.
class TrialPatch {
 public:
  void capture(const Mesh& mesh, std::span<const TriangleId> elements);

  std::size_t count() const { return elements_.size(); }
  TriangleId element(std::size_t e) const { return elements_[e]; }
  /// The net of the e-th element, with its points where they were moved.
  std::span<const Point> net(std::size_t e) const { return {nets_.data() + e * size_, size_}; }
  bool has(std::size_t e, PointId p) const;
  const Point& point(PointId p) const;
  void move(PointId p, const Point& to);

  using Nets = std::vector<Point>;
  const Nets& nets() const { return nets_; }
  void set_nets(const Nets& nets) { nets_ = nets; }
  void reset() { nets_ = old_; }

  /// Moves these points, one after the other, to their optimal place in the elements of the patch that have them. True
  /// if any moved.
  bool place(std::span<const PointId> points, SmoothGoal goal, PlacementMeasure measure = PlacementMeasure::element);
  /// Scales the distance of the points inside an edge from their straight places by `keep`, and blends the inner points
  /// of those elements on its sides that are in the patch.
  void straighten(const Mesh& mesh, HalfEdgeId h, double keep);
  /// Blends the inner points of an element from its edges: each is displaced from its straight place as the edges are,
  /// and the displacement of an edge fades towards the opposite corner.
  void blend(const Mesh& mesh, TriangleId t);
  /// Moves vertex v by `shift`, and every other control point of its elements by a part of that, its barycentric
  /// coordinate at v, so that straight elements stay straight.
  void drag(PointId v, const Vector& shift);

  /// Moves the points of the mesh to where they are here, and refits their fields over the elements (paper §5.2.4).
  ///
  /// In tangled elements the old function may have several values at a place; one of them is taken. The signed integral
  /// is kept if limited values can keep it. Values are limited there even if options.projection is `conservative`.
  ///
  /// Refuses     if `must_be_valid`, elements that are not all certified valid (would_invert); if they are valid before
  ///             and after, an integral that limited values cannot keep (loses_integral)
  Outcome apply(Mesh& mesh, const RefitOptions& options, bool must_be_valid) const;

 private:
  int degree_ = 0;
  std::size_t size_ = 0;  // control points in one net
  std::vector<TriangleId> elements_;
  std::vector<PointId> ids_;  // the points of all nets, one net after the other
  Nets nets_, old_;
  std::vector<PlacementElement> around_;
};

}  // namespace pliant
