// lib/pliant/improve/coarsening/removal_chain.h: removes one vertex, and others that refine's goals then ask to go; or
// nothing.
#pragma once
#include <vector>

#include "pliant/improve/coarsening/removal_forecast.h"
#include "pliant/improve/legalize.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

/// The least shape that removals may leave where there was a better one: 0.25 where fewer elements are asked for by a
/// bound on size, else, if that is more, the least shape of a straight triangle that `refine` leaves alone: the one
/// with two of the least angles.
double accepted_shape(const QualityGoals& goals);

/// One transaction after another on the same mesh.
class RemovalChain {
 public:
  struct Limits {
    QualityGoals goals;
    CurveTolerance curves;
    RefitOptions refit;
    double accepted_shape = 0;
    bool uses_forecast = true;
  };
  /// `slated`: by point slot, what may go. References are kept.
  RemovalChain(Mesh& mesh, const Limits& limits, const std::vector<bool>& slated);

  /// Removes v, and then others that are slated as long as elements are left that refine would attack, and had not
  /// before. Refused, with the mesh as it was, where that does not end well, or where it would lower the least shape of
  /// the elements that it touches: below what is accepted, or below half of what it was.
  RemovalRefusal remove(PointId v, bool is_on_curve);

  /// What decided the last refusal: as long as none of these vertices' stars changes, nor what of them is slated, it
  /// would be refused again.
  const std::vector<PointId>& decided_by() const { return decided_by_; }
  // After a removal that was not refused:
  const std::vector<PointId>& removed() const { return chained_; }
  const std::vector<TriangleId>& around() const { return around_; }  ///< what has changed; some are dead
  /// Vertices on curves whose own removal would now be another one.
  const std::vector<PointId>& along_curves() const { return along_curves_; }
  double error() const { return error_; }
  double integral_change() const { return integral_change_; }

 private:
  using Corners = std::array<PointId, 3>;

  CurveRemoval remove_one(PointId v, bool is_on_curve);
  RemovalRefusal foresee(PointId v);
  void note_corners(std::span<const TriangleId> triangles);
  void look_around();
  void look_inside();
  void add_curve_neighbors(PointId v);
  Culprit most_urgent(const char*& reason) const;
  bool is_misshapen() const;
  Corners corners_of(TriangleId t) const;
  double shape_of(TriangleId t) const;

  Mesh& mesh_;
  const Limits& limits_;
  const std::vector<bool>& slated_;
  RemovalForecast forecast_;
  std::vector<PointId> chained_, link_, chain_, along_curves_, decided_by_;
  std::vector<TriangleId> around_, changed_;
  std::vector<Corners> attacked_;  // before
  double worst_before_ = 1, error_ = 0, integral_change_ = 0;
  std::vector<HalfEdgeId> stack_;
  Star star_;
  LegalizeCounts counts_;
};

}  // namespace pliant
