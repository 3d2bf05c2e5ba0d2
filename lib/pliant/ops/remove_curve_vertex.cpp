// Knot removal with its whole footprint: curve, moved vertices, elements on both sides, fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "pliant/geometry/turning_angle.h"
#include "pliant/ops/curve_passage.h"
#include "pliant/ops/refit.h"
#include "pliant/ops/region_integrals.h"
#include "pliant/ops/remove_point.h"
#include "pliant/ops/restore_area.h"

namespace pliant {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void add_once(std::vector<TriangleId>& list, TriangleId t) {
  if (std::find(list.begin(), list.end(), t) == list.end()) list.push_back(t);
}

bool is_tolerable(const Curve& curve, double error, const CurveTolerance& tolerance) {
  return curve.removal_error + error <= tolerance.total && error <= tolerance.step;
}

/// Removes a break from a curve of the mesh, without moving the mesh's points; how far the curve moves at most. Keeps
/// the area if so wanted, unless the curve moves too far even without. In a transaction of the caller.
std::optional<double> remove_break(Mesh& mesh, CurveId c, double knot, const CurveTolerance& tolerance) {
  const Curve& curve = mesh.boundary().curves[at(c)];
  std::optional<RemovalStretch> before;
  if (tolerance.keep_area) before.emplace(mesh, c, knot);
  std::optional<double> error = mesh.remove_break(c, knot);
  if (error && before && is_tolerable(curve, *error, tolerance)) error = before->restore_area(mesh);
  return error;
}

/// The removal of a knot as far as the curve alone decides it.
struct KnotRemoval {
  Refusal refusal = Refusal::done;
  double error = 0;
  Passage passage;
  PointId from = 0, to = 0;  ///< the ends of the edge that is left
  double start = 0;          ///< where it starts
};

/// Removes the knot from the curve of the mesh, in a transaction of the caller, who rolls it back where the removal is
/// refused.   `is_changed`: the curve has lost knots before in this way, which the mesh has not followed
KnotRemoval try_removal(Mesh& mesh, PointId v, const Star& star, const CurveTolerance& tolerance,
                        bool is_changed = false) {
  KnotRemoval plan;
  plan.passage = passage_at(mesh, v, star);
  const auto refused = [&plan](Refusal refusal) {
    plan.refusal = refusal;
    return plan;
  };
  const CurveId c = plan.passage.curve;
  if (c == none) return refused(Refusal::corner);  // or pinched, or on no curve
  const Curve& curve = mesh.boundary().curves[at(c)];
  const BSpline& spline = curve.spline;
  const ConstraintId kept = mesh.constraint(plan.passage.before), dropped = mesh.constraint(plan.passage.after);
  const double knot = mesh.constraint_start(dropped);
  if (spline.closed() ? spline.span_count(4) <= 3 : knot <= spline.first_parameter())
    return refused(Refusal::not_removable);
  plan.start = is_changed ? spline.span_before(knot) : mesh.constraint_start(kept);
  // The first of a knot's copies costs no more than all of them, and it tells without a change.
  const std::optional<double> least = spline.removal_error(knot);
  if (!least) return refused(Refusal::not_removable);
  plan.error = *least;
  if (!is_tolerable(curve, plan.error, tolerance)) return refused(Refusal::exceeds_tolerance);
  const std::optional<double> error = remove_break(mesh, c, knot, tolerance);
  if (!error) return refused(Refusal::not_removable);
  plan.error = *error;
  if (!is_tolerable(curve, plan.error, tolerance)) return refused(Refusal::exceeds_tolerance);
  std::array<Point, max_degree + 1> merged_polygon;
  const std::span<Point> long_span{merged_polygon.data(), at(mesh.degree() + 1)};
  spline.extract(plan.start, long_span);
  if (turning_angle(long_span) > tolerance.max_turning) return refused(Refusal::too_curved);
  plan.from = mesh.constraint_first(kept);
  plan.to = mesh.origin(plan.passage.after) == v ? mesh.target(plan.passage.after) : mesh.origin(plan.passage.after);
  if (!is_changed &&
      (find_half_edge(mesh, plan.from, plan.to) != none || find_half_edge(mesh, plan.to, plan.from) != none))
    return refused(Refusal::edge_exists);
  return plan;
}

}  // namespace

CurveRemoval foresee_curve_removal(Mesh& mesh, PointId v, const CurveTolerance& tolerance, ForeseenCurves& foreseen) {
  thread_local Star star;
  find_star(mesh, v, star);
  const CurveId c = passage_at(mesh, v, star).curve;
  Transaction transaction(mesh);
  const KnotRemoval plan = try_removal(mesh, v, star, tolerance, foreseen.find(c) != nullptr);
  if (plan.refusal != Refusal::done) return {plan.refusal, plan.error};
  mesh.set_removal_error(c, mesh.boundary().curves[at(c)].removal_error + plan.error);
  transaction.commit();
  ForeseenCurves::Changed* changed = foreseen.find(c);
  if (changed == nullptr) changed = &foreseen.curves.emplace_back(ForeseenCurves::Changed{c, 0});

  // Where the vertices near by will be. Those that have gone before have no knot any more.
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
    spline.extract(knot, {bezier.data(), at(mesh.degree() + 1)});
    const auto known =
        std::find_if(foreseen.moved.begin(), foreseen.moved.end(), [w](const auto& each) { return each.first == w; });
    if (known != foreseen.moved.end()) {
      known->second = bezier[0];
    } else if (bezier[0] != mesh.point(w)) {
      foreseen.moved.emplace_back(w, bezier[0]);
      find_star(mesh, w, star);
      if (passage_at(mesh, w, star).curve == none) return {Refusal::corner, plan.error};  // something holds on to it
    }
  }
  return {Refusal::done, plan.error};
}

CurveRemoval remove_curve_vertex(Mesh& mesh, PointId v, const CurveTolerance& tolerance, const RefitOptions& options) {
  Star star;
  find_star(mesh, v, star);
  // A trial first: the operations on ears ask for the curve as it is.
  Transaction trial(mesh);
  const KnotRemoval plan = try_removal(mesh, v, star, tolerance);
  if (plan.refusal != Refusal::done) return {plan.refusal, plan.error};
  trial.roll_back();
  const Passage passage = plan.passage;
  const Curve& curve = mesh.boundary().curves[at(passage.curve)];
  const ConstraintId kept = mesh.constraint(passage.before), dropped = mesh.constraint(passage.after);
  const double knot = mesh.constraint_start(dropped), start = plan.start;
  const PointId from = plan.from, to = plan.to;
  const auto refused = [&plan](Refusal refusal) { return CurveRemoval{refusal, plan.error}; };

  Transaction transaction(mesh);
  // Ears first, so that each side has two triangles. A fan starts at the outgoing half-edge that has the curve on its
  // right.
  std::vector<Fan> fans;
  for (const HalfEdgeId h : star.outgoing)
    if (mesh.is_constrained(h)) {
      fans.emplace_back();
      find_fan(mesh, star, h, fans.back());
    }
  for (Fan& fan : fans)
    if (!reduce_fan(mesh, v, fan, false, 2, options)) return refused(Refusal::not_removable);

  const int p = mesh.degree(), width = mesh.width();
  thread_local Footprint footprint;
  find_star(mesh, v, star);
  const Passage now = passage_at(mesh, v, star);
  find_footprint(mesh, now, footprint);

  // New places of the curve's points, before anything moves.
  remove_break(mesh, passage.curve, knot, tolerance);  // as in the trial
  mesh.set_removal_error(passage.curve, curve.removal_error + plan.error);
  const auto extract = [&](double t0) {
    std::array<Point, max_degree + 1> bezier{};
    curve.spline.extract(t0, {bezier.data(), at(p + 1)});
    return bezier;
  };
  const auto note_shift = [&](PointId w, const Point& place) {
    if (std::find(footprint.moved.begin(), footprint.moved.end(), w) != footprint.moved.end()) return;
    footprint.moved.push_back(w);
    footprint.shifts.push_back(place - mesh.point(w));
  };
  const auto merged = extract(start);
  note_shift(from, merged[0]);
  note_shift(to, merged[at(p)]);
  std::vector<std::pair<PointId, Point>> places;
  for (std::size_t k = 0; k < footprint.edges.size(); ++k) {
    const HalfEdgeId h = footprint.half_edges[k];
    const bool forward = mesh.runs_forward(h);
    const auto bezier = extract(mesh.constraint_start(footprint.edges[k]));
    for (int i = 0; i <= p; ++i) {
      const PointId q = mesh.edge_point(h, forward ? i : p - i);
      if (i == 0 || i == p)
        note_shift(q, bezier[at(i)]);
      else
        places.emplace_back(q, bezier[at(i)]);
    }
  }
  std::vector<TriangleId> before;  // all elements that change, as they were
  for (const HalfEdgeId h : star.outgoing) add_once(before, triangle_of(h));
  Star other;
  for (std::size_t k = 0; k < footprint.moved.size(); ++k) {
    find_star(mesh, footprint.moved[k], other);
    // Where something else holds on to the vertex it cannot move.
    if (footprint.shifts[k] != Vector{} && passage_at(mesh, footprint.moved[k], other).curve == none)
      return refused(Refusal::corner);
    for (const HalfEdgeId h : other.outgoing) add_once(before, triangle_of(h));
  }
  for (const HalfEdgeId h : footprint.half_edges)
    for (const HalfEdgeId g : {h, mesh.twin(h)})
      if (g != none) add_once(before, triangle_of(g));
  thread_local Patch patch;
  patch.capture(mesh, before);
  // Where the curve stays where it is, so does the region of the merging elements: integrals are kept there.
  const bool region_kept = plan.error <= mesh.tolerance();
  thread_local Patch merging;
  if (region_kept) merging.capture(mesh, {before.data(), star.outgoing.size()});
  thread_local RegionIntegrals integrals_before, integrals;
  if (!region_kept) integrals_before.take(mesh, before);

  // Where the elements are a subdivision, its parents' rows come back, with the curve's own control points. Each side
  // finds the long edge for itself: fields by face differ there, and what is shared comes out the same.
  thread_local std::array<ParentRecovery, 2> parents;
  bool restored = region_kept;
  for (std::size_t k = 0; k < fans.size() && restored; ++k) {
    std::array<Point, max_degree + 1> long_edge = merged;
    if (fans[k][0] == from) std::reverse(long_edge.begin(), long_edge.begin() + p + 1);
    restored = recover_merged(mesh, v, fans[k], parents[k], {long_edge.data(), at(p + 1)});
  }

  // Topology. The long edge of a fan runs from its last vertex to its first.
  const EdgePoints old_before = side_of(mesh, now.before).points, old_after = side_of(mesh, now.after).points;
  const EdgePoints edge = new_edge(from, to, {old_before.ids.data() + 1, at(p - 1)}, p);
  std::vector<TriangleId> merged_triangles;
  std::vector<HalfEdgeId> starts;
  for (const Fan& fan : fans) starts.push_back(find_half_edge(mesh, v, fan[0]));
  for (std::size_t k = 0; k < fans.size(); ++k)
    merged_triangles.push_back(merge_fan(mesh, starts[k], fans[k][2] == from ? edge : edge.reversed()));
  const HalfEdgeId one = half_edge(merged_triangles[0], 2);
  mesh.link(one, merged_triangles.size() == 2 ? half_edge(merged_triangles[1], 2) : none);
  for (const TriangleId t : merged_triangles) mesh.set_constraint(half_edge(t, 2), kept);
  mesh.free_constraint(dropped);
  free_edge_points(mesh, old_after);
  mesh.free_point(v);

  // Geometry: the curve as extracted; what hangs on moved vertices keeps its displacement.
  std::vector<TriangleId> after;
  for (const TriangleId t : before)
    if (mesh.is_alive(t)) after.push_back(t);
  thread_local std::vector<PointId> shifted;
  thread_local std::vector<std::pair<PointId, FaceId>> refitted;
  shifted.clear();
  refitted.clear();
  std::vector<std::pair<PointId, Point>> linear_moves;
  std::vector<PointId> on_curve(edge.ids.begin(), edge.ids.begin() + p + 1);
  for (const auto& [q, place] : places) on_curve.push_back(q);
  for (const TriangleId t : after) {
    const auto net = mesh.net(t);
    const std::array<Vector, 3> shift{footprint.shift_of(net[0]), footprint.shift_of(net[1]),
                                      footprint.shift_of(net[2])};
    const bool is_merged = std::find(merged_triangles.begin(), merged_triangles.end(), t) != merged_triangles.end();
    for (int k = 0; k < mesh.net_size(); ++k) {
      const PointId q = net[at(k)];
      if (k >= mesh.layout().first_interior() && is_merged) continue;
      refitted.emplace_back(q, mesh.face(t));
      if (k < 3 || std::find(on_curve.begin(), on_curve.end(), q) != on_curve.end()) continue;
      if (std::find(shifted.begin(), shifted.end(), q) != shifted.end()) continue;
      shifted.push_back(q);
      const auto& [i, j, l] = mesh.layout().exponents(k);
      linear_moves.emplace_back(q, mesh.point(q) + (1.0 / p) * (i * shift[0] + j * shift[1] + l * shift[2]));
    }
  }
  std::sort(refitted.begin(), refitted.end());
  refitted.erase(std::unique(refitted.begin(), refitted.end()), refitted.end());
  std::vector<Point> old_places;
  for (const auto& [q, f] : refitted) old_places.push_back(mesh.point(q));
  for (std::size_t k = 0; k < footprint.moved.size(); ++k)
    mesh.set_point(footprint.moved[k], mesh.point(footprint.moved[k]) + footprint.shifts[k]);
  mesh.set_point(from, merged[0]);
  mesh.set_point(to, merged[at(p)]);
  for (const auto& [q, place] : places) mesh.set_point(q, place);
  for (const auto& [q, place] : linear_moves) mesh.set_point(q, place);
  for (int k = 1; k < p; ++k) mesh.set_point(edge[k], merged[at(k)]);

  std::vector<PointId> inner;
  for (const TriangleId t : merged_triangles) {
    const InnerPoints ids = inner_points(mesh, t);
    inner.insert(inner.end(), ids.begin(), ids.begin() + interior_size(p));
  }
  if (restored) {
    for (std::size_t k = 0; k < fans.size(); ++k)
      for (int i = mesh.layout().first_interior(); i < mesh.net_size(); ++i)
        mesh.set_point(mesh.net(merged_triangles[k])[at(i)], parents[k].point(i));
  } else if (!patch.fit_geometry(mesh, merged_triangles, inner)) {
    return refused(Refusal::would_invert);
  }
  if (!all_valid(mesh, after)) return refused(Refusal::would_invert);

  // Fields: linear functions follow the moved points; the merged elements are restored or fitted.
  if (width > 2) {
    std::size_t column = 2;
    std::vector<std::pair<FaceId, Patch::Linear>> fits;  // of one column
    for (std::size_t f = 0; f < mesh.fields().size(); ++f)
      for (int c = 0; c < mesh.fields()[f].components; ++c, ++column) {
        const bool by_face = mesh.fields()[f].by_face;
        fits.clear();
        for (std::size_t k = 0; k < refitted.size(); ++k) {
          const auto& [q, face] = refitted[k];
          if (mesh.point(q) == old_places[k]) continue;
          if (!by_face && k > 0 && refitted[k - 1].first == q) continue;  // once a point
          const std::ptrdiff_t first = mesh.value_index(static_cast<int>(f), q, face);
          if (first < 0) continue;
          const FaceId of_face = by_face ? face : none;
          auto fit = std::find_if(fits.begin(), fits.end(), [&](const auto& each) { return each.first == of_face; });
          if (fit == fits.end())
            fit = fits.insert(fits.end(), {of_face, patch.linear_of(static_cast<int>(column), of_face)});
          const Patch::Linear& linear = fit->second;
          const double old = mesh.fields()[f].values[static_cast<std::size_t>(first + c)];
          const double change = patch.evaluate(linear, mesh.point(q)) - patch.evaluate(linear, old_places[k]);
          mesh.put_component(static_cast<int>(f), c, q, face, old + change);
        }
      }
    if (restored) {
      for (std::size_t k = 0; k < fans.size(); ++k) {
        const TriangleId t = merged_triangles[k];
        for (int i = 3 + 2 * (p - 1); i < mesh.net_size(); ++i)  // the long edge's points, then the inner ones
          mesh.put_fields(mesh.net(t)[at(i)], mesh.face(t), parents[k].row(i));
      }
    } else {
      std::vector<PointId> free(edge.ids.begin() + 1, edge.ids.begin() + p);
      free.insert(free.end(), inner.begin(), inner.end());
      (region_kept ? merging : patch).fit_fields(mesh, merged_triangles, free, options, region_kept);
    }
  }
  CurveRemoval removal{Refusal::done, plan.error};
  if (!region_kept && width > 2) {
    integrals.take(mesh, after);
    if (options.region_change == RegionChange::conserve) {
      integrals_before.restore(mesh, after, integrals);
    } else {
      removal.integral_change = integrals_before.change_to(integrals);
    }
  }
  transaction.commit();
  return removal;
}

}  // namespace pliant
