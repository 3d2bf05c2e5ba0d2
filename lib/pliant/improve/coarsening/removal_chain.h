// lib/pliant/improve/coarsening/removal_chain.h: removes a vertex, together with others where refine would attack, or
// nothing.
#pragma once
#include <vector>

#include "pliant/improve/coarsening/removal_forecast.h"
#include "pliant/improve/legalize.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

/// The least shape that a removal may leave where the shapes were better before. It is 0.25 where there is a bound on
/// size. Elsewhere it is, if that is more, the least shape of a straight triangle that `refine` leaves alone, which is
/// the triangle with two least angles.
double accepted_shape(const QualityGoals& goals);

/// Removes vertices from one mesh, each removal with all that follows from it in a transaction of its own.
class RemovalChain {
 public:
  struct Limits {
    QualityGoals goals;
    CurveTolerance curves;
    RefitOptions refit;
    double accepted_shape = 0;
    bool uses_forecast = true;
  };
  /// `slated`: by point slot, true for vertices that may be removed. All references are kept.
  RemovalChain(Mesh& mesh, const Limits& limits, const std::vector<bool>& slated);

  /// Has `use` called once, with the mesh as it was, before the first removal that is not refused. That removal is made
  /// twice, since only then is it known.
  void before_first(std::function<void()> use) { before_first_ = std::move(use); }

  /// Removes v, and then other slated vertices as long as there are elements that refine would attack and would not
  /// have before. Refused, with the mesh as it was, where such elements remain, or where the least shape of the
  /// elements that change would fall below what is accepted, or below half of what it was.
  RemovalRefusal remove(PointId v, bool is_on_curve);

  /// The vertices that decided the last refusal. As long as neither their stars change nor which of them are slated,
  /// the removal would be refused again.
  const std::vector<PointId>& decided_by() const { return decided_by_; }
  // After a removal that was not refused:
  const std::vector<PointId>& removed() const { return chained_; }
  const std::vector<TriangleId>& around() const { return around_; }  ///< the triangles that changed; some are not alive
  /// Vertices on curves whose own removal would now have another outcome.
  const std::vector<PointId>& along_curves() const { return along_curves_; }
  double error() const { return error_; }
  double integral_change() const { return integral_change_; }

 private:
  using Corners = std::array<PointId, 3>;

  CurveRemoval remove_one(PointId v, bool is_on_curve);
  RemovalRefusal foresee(PointId v, bool is_on_curve);
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
  std::function<void()> before_first_;
  std::vector<PointId> chained_, link_, chain_, along_curves_, decided_by_;
  std::vector<TriangleId> around_, changed_;
  std::vector<CurveId> curves_;    // those that lose a vertex
  std::vector<Corners> attacked_;  // the elements that refine would have attacked before
  double worst_before_ = 1, error_ = 0, integral_change_ = 0;
  std::vector<HalfEdgeId> stack_;
  Star star_;
  LegalizeCounts counts_;
};

}  // namespace pliant
