// lib/pliant/ops/removal/knot_removal.cpp: removes a knot from a curve as a trial, and checks the curve's bounds.
#include "pliant/ops/removal/knot_removal.h"

#include <algorithm>
#include <array>

#include "pliant/geometry/index.h"
#include "pliant/geometry/spline/turning_angle.h"
#include "pliant/ops/removal/removal_stretch.h"

namespace pliant {
namespace {

bool is_tolerable(const Mesh& mesh, const Curve& curve, double error, const CurveTolerance& tolerance) {
  if (error <= mesh.tolerance()) return true;  // exact but for rounding
  return curve.removal_error + error <= tolerance.total && error <= tolerance.step;
}

}  // namespace

std::optional<double> remove_break(Mesh& mesh, CurveId c, double knot, const CurveTolerance& tolerance) {
  const Curve& curve = mesh.boundary().curves[index(c)];
  std::optional<RemovalStretch> before;
  if (tolerance.keep_area) before.emplace(mesh, c, knot);
  std::optional<double> error = mesh.remove_break(c, knot);
  if (error && before && is_tolerable(mesh, curve, *error, tolerance)) error = before->restore_area(mesh);
  return error;
}

KnotRemoval try_removal(Mesh& mesh, PointId v, const Star& star, const CurveTolerance& tolerance, bool is_changed) {
  KnotRemoval plan;
  plan.passage = passage_at(mesh, v, star);
  const auto refused = [&plan](Outcome outcome) {
    plan.outcome = outcome;
    return plan;
  };
  const CurveId c = plan.passage.curve;
  if (c == none) return refused(Outcome::corner);  // or pinched, or on no curve
  const Curve& curve = mesh.boundary().curves[index(c)];
  const BSpline& spline = curve.spline;
  const ConstraintId kept = mesh.constraint(plan.passage.before), dropped = mesh.constraint(plan.passage.after);
  const double knot = mesh.constraint_start(dropped);
  if (spline.closed() ? spline.span_count(4) <= 3 : knot <= spline.first_parameter())
    return refused(Outcome::not_removable);
  plan.start = is_changed ? spline.span_before(knot) : mesh.constraint_start(kept);
  // A knot may have several copies. The error of removing one is no larger than that of all, and is known without a
  // change of the curve.
  const std::optional<double> least = spline.removal_error(knot);
  if (!least) return refused(Outcome::not_removable);
  plan.error = *least;
  if (!is_tolerable(mesh, curve, plan.error, tolerance)) return refused(Outcome::exceeds_tolerance);
  const std::optional<double> error = remove_break(mesh, c, knot, tolerance);
  if (!error) return refused(Outcome::not_removable);
  plan.error = *error;
  if (!is_tolerable(mesh, curve, plan.error, tolerance)) return refused(Outcome::exceeds_tolerance);
  std::array<Point, max_degree + 1> merged_polygon;
  const std::span<Point> long_span{merged_polygon.data(), index(mesh.degree() + 1)};
  spline.extract(plan.start, long_span);
  if (turning_angle(long_span) > tolerance.max_turning) return refused(Outcome::too_curved);
  if (tolerance.accuracy < HUGE_VAL && spline.resolution_error(plan.start) > tolerance.accuracy)
    return refused(Outcome::too_curved);
  plan.from = mesh.constraint_first(kept);
  plan.to = mesh.origin(plan.passage.after) == v ? mesh.target(plan.passage.after) : mesh.origin(plan.passage.after);
  if (!is_changed &&
      (find_half_edge(mesh, plan.from, plan.to) != none || find_half_edge(mesh, plan.to, plan.from) != none))
    return refused(Outcome::edge_exists);
  return plan;
}

CurveRemoval foresee_curve_removal(Mesh& mesh, PointId v, const CurveTolerance& tolerance, ForeseenCurves& foreseen) {
  thread_local Star star;
  find_star(mesh, v, star);
  const CurveId c = passage_at(mesh, v, star).curve;
  Transaction transaction(mesh);
  const KnotRemoval plan = try_removal(mesh, v, star, tolerance, foreseen.find(c) != nullptr);
  if (plan.outcome != Outcome::done) return {plan.outcome, plan.error};
  mesh.set_removal_error(c, mesh.boundary().curves[index(c)].removal_error + plan.error);
  transaction.commit();
  ForeseenCurves::Changed* changed = foreseen.find(c);
  if (changed == nullptr) changed = &foreseen.curves.emplace_back(ForeseenCurves::Changed{c, 0});

  // Note where the vertices nearby would be. Vertices of removals foreseen before have no knot any more.
  const BSpline& spline = mesh.spline(c);
  thread_local Footprint footprint;
  find_footprint(mesh, plan.passage, footprint, changed->removals++);
  footprint.half_edges.insert(footprint.half_edges.end(), {plan.passage.before, plan.passage.after});
  std::array<Point, max_degree + 1> bezier;
  for (const HalfEdgeId h : footprint.half_edges) {
    const ConstraintId constraint = mesh.constraint(h);
    const double knot = mesh.constraint_start(constraint);
    const PointId w = mesh.constraint_first(constraint);
    if (spline.multiplicity(knot) == 0 || (!spline.closed() && knot <= spline.first_parameter())) continue;
    spline.extract(knot, {bezier.data(), index(mesh.degree() + 1)});
    const auto known =
        std::find_if(foreseen.moved.begin(), foreseen.moved.end(), [w](const auto& each) { return each.first == w; });
    if (known != foreseen.moved.end()) {
      known->second = bezier[0];
    } else if (bezier[0] != mesh.point(w)) {
      foreseen.moved.emplace_back(w, bezier[0]);
      find_star(mesh, w, star);
      // A vertex that belongs to something other than this curve cannot move.
      if (passage_at(mesh, w, star).curve == none) return {Outcome::corner, plan.error};
    }
  }
  return {Outcome::done, plan.error};
}

}  // namespace pliant
