// lib/pliant/ops/removal/remove_curve_vertex.cpp: removes a vertex from a curve, and makes elements and fields follow.
#include <algorithm>
#include <array>
#include <optional>

#include "pliant/geometry/index.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit/region_integrals.h"
#include "pliant/ops/removal/knot_removal.h"
#include "pliant/ops/remove_point.h"

namespace pliant {
namespace {

void add_once(std::vector<TriangleId>& list, TriangleId t) {
  if (std::find(list.begin(), list.end(), t) == list.end()) list.push_back(t);
}

bool contains(const std::vector<PointId>& list, PointId p) {
  return std::find(list.begin(), list.end(), p) != list.end();
}

/// The removal of one vertex, in steps that use what earlier steps found. An object's memory is reused from removal to
/// removal.
class CurveVertexRemoval {
 public:
  CurveRemoval run(Mesh& mesh, PointId v, const CurveTolerance& tolerance, const RefitOptions& options);

 private:
  using Polygon = std::array<Point, max_degree + 1>;

  /// Takes all steps that change the mesh. Requires an open transaction, which the caller rolls back if a step refuses.
  Outcome change(const CurveTolerance& tolerance);
  /// Flips ears until each side of the curve has two triangles at the vertex. False if no ear can be flipped.
  bool reduce_sides();
  /// Removes the knot from the curve, and notes where the curve's control points will be in the mesh.
  void remove_knot(const CurveTolerance& tolerance);
  Polygon extract(double start) const;
  void note_shift(PointId vertex, const Point& place);
  /// Finds the elements that will change. False if a vertex that moves belongs to something other than the curve.
  bool collect_elements();
  /// Copies what these elements hold.
  void capture_elements();
  /// Finds the parents of the two elements on each side, if the curve stays where it is and they are subdivisions.
  void recover_parents();
  void merge_topology();
  /// Lists the points that may move, and the new places of those off the curve: the corners of their element move, and
  /// each keeps its displacement from the straight triangle.
  void plan_moves();
  void move_points();
  /// Places the points inside the merged elements. True if all elements are valid then.
  bool place_inner_points();
  bool refit_fields();
  /// Changes one component at the points that moved by what its best linear function changes between the two places.
  void follow_moves(int field, int component, int column);
  /// Restores the integrals over the region, which has changed, or reports their change: as options_.region_change
  /// says.
  void settle_integrals(CurveRemoval& removal);

  Mesh* mesh_ = nullptr;
  PointId vertex_ = none;
  RefitOptions options_;

  KnotRemoval plan_;  // what the removal does to the curve
  /// The edge before the knot, which becomes the merged ("long") edge, and the edge after the knot.
  ConstraintId kept_ = none, dropped_ = none;
  double knot_ = 0;
  bool region_kept_ = false;  // the curve stays where it is, so integrals over the merging elements can be kept
  bool restored_ = false;     // the merged elements are the parents that were found

  Star star_, other_star_;
  std::vector<Fan> fans_;  // one for each side
  Passage passage_;        // the passage once the ears are gone
  Footprint footprint_;
  Polygon merged_;  // control points of the long edge
  /// New places of the points inside the footprint's edges.
  std::vector<std::pair<PointId, Point>> curve_places_;
  std::vector<TriangleId> before_, after_;  // all elements that change, and those of them that are left
  Patch patch_, merging_;                   // copies of all elements that change, and of those at the vertex
  RegionIntegrals integrals_before_, integrals_after_;
  std::array<ParentRecovery, 2> parents_;
  EdgePoints edge_;  // the long edge, in the curve's direction
  std::vector<HalfEdgeId> starts_;
  std::vector<TriangleId> merged_triangles_;
  std::vector<PointId> on_curve_, shifted_, inner_, free_;
  /// New places of the points off the curve whose elements have moved vertices.
  std::vector<std::pair<PointId, Point>> moves_;
  /// Points whose values may change, each with a face, and where they were.
  std::vector<std::pair<PointId, FaceId>> refitted_;
  std::vector<Point> old_places_;
  /// Best linear functions of one component: one for all faces together (face none), or one for each face.
  std::vector<std::pair<FaceId, Patch::Linear>> fits_;
};

CurveRemoval CurveVertexRemoval::run(Mesh& mesh, PointId v, const CurveTolerance& tolerance,
                                     const RefitOptions& options) {
  mesh_ = &mesh;
  vertex_ = v;
  options_ = options;
  find_star(mesh, v, star_);
  // First as a trial, which is rolled back: the flips of ears need the curve as it is.
  Transaction trial(mesh);
  plan_ = try_removal(mesh, v, star_, tolerance);
  if (plan_.outcome != Outcome::done) return {plan_.outcome, plan_.error};
  trial.roll_back();
  kept_ = mesh.constraint(plan_.passage.before);
  dropped_ = mesh.constraint(plan_.passage.after);
  knot_ = mesh.constraint_start(dropped_);
  region_kept_ = plan_.error <= mesh.tolerance();

  Transaction transaction(mesh);
  const Outcome outcome = change(tolerance);
  CurveRemoval removal{outcome, plan_.error};
  if (outcome != Outcome::done) return removal;
  if (!region_kept_ && mesh.width() > 2) settle_integrals(removal);
  transaction.commit();
  return removal;
}

Outcome CurveVertexRemoval::change(const CurveTolerance& tolerance) {
  if (!reduce_sides()) return Outcome::not_removable;
  find_star(*mesh_, vertex_, star_);
  passage_ = passage_at(*mesh_, vertex_, star_);
  find_footprint(*mesh_, passage_, footprint_);
  remove_knot(tolerance);
  if (!collect_elements()) return Outcome::corner;
  capture_elements();
  recover_parents();
  merge_topology();
  plan_moves();
  move_points();
  if (!place_inner_points()) return Outcome::would_invert;
  return mesh_->width() == 2 || refit_fields() ? Outcome::done : Outcome::loses_integral;
}

bool CurveVertexRemoval::reduce_sides() {
  // A fan starts at the outgoing half-edge that has the curve on its right.
  fans_.clear();
  for (const HalfEdgeId h : star_.outgoing)
    if (mesh_->is_constrained(h)) {
      fans_.emplace_back();
      find_fan(*mesh_, star_, h, fans_.back());
    }
  return std::all_of(fans_.begin(), fans_.end(),
                     [this](Fan& fan) { return reduce_fan(*mesh_, vertex_, fan, false, 2, options_); });
}

CurveVertexRemoval::Polygon CurveVertexRemoval::extract(double start) const {
  Polygon polygon{};
  mesh_->spline(plan_.passage.curve).extract(start, {polygon.data(), index(mesh_->degree() + 1)});
  return polygon;
}

void CurveVertexRemoval::note_shift(PointId vertex, const Point& place) {
  if (contains(footprint_.moved, vertex)) return;
  footprint_.moved.push_back(vertex);
  footprint_.shifts.push_back(place - mesh_->point(vertex));
}

void CurveVertexRemoval::remove_knot(const CurveTolerance& tolerance) {
  const int p = mesh_->degree();
  const CurveId curve = plan_.passage.curve;
  remove_break(*mesh_, curve, knot_, tolerance);  // as in the trial
  mesh_->set_removal_error(curve, mesh_->boundary().curves[index(curve)].removal_error + plan_.error);
  merged_ = extract(plan_.start);
  note_shift(plan_.from, merged_[0]);
  note_shift(plan_.to, merged_[index(p)]);
  curve_places_.clear();
  for (std::size_t k = 0; k < footprint_.edges.size(); ++k) {
    const HalfEdgeId h = footprint_.half_edges[k];
    const bool forward = mesh_->runs_forward(h);
    const Polygon polygon = extract(mesh_->constraint_start(footprint_.edges[k]));
    for (int i = 0; i <= p; ++i) {
      const PointId q = mesh_->edge_point(h, forward ? i : p - i);
      if (i == 0 || i == p)
        note_shift(q, polygon[index(i)]);
      else
        curve_places_.emplace_back(q, polygon[index(i)]);
    }
  }
}

bool CurveVertexRemoval::collect_elements() {
  before_.clear();
  for (const HalfEdgeId h : star_.outgoing) add_once(before_, triangle_of(h));
  for (std::size_t k = 0; k < footprint_.moved.size(); ++k) {
    find_star(*mesh_, footprint_.moved[k], other_star_);
    if (footprint_.shifts[k] != Vector{} && passage_at(*mesh_, footprint_.moved[k], other_star_).curve == none)
      return false;
    for (const HalfEdgeId h : other_star_.outgoing) add_once(before_, triangle_of(h));
  }
  for (const HalfEdgeId h : footprint_.half_edges)
    for (const HalfEdgeId g : {h, mesh_->twin(h)})
      if (g != none) add_once(before_, triangle_of(g));
  return true;
}

void CurveVertexRemoval::capture_elements() {
  patch_.capture(*mesh_, before_);
  if (region_kept_)
    merging_.capture(*mesh_, {before_.data(), star_.outgoing.size()});
  else
    integrals_before_.take(*mesh_, before_);
}

void CurveVertexRemoval::recover_parents() {
  // The parents' long edges get the curve's own control points. Each side finds the long edge for itself, since fields
  // by face differ there; what both sides share comes out the same.
  const int p = mesh_->degree();
  restored_ = region_kept_;
  for (std::size_t k = 0; k < fans_.size() && restored_; ++k) {
    Polygon long_edge = merged_;
    if (fans_[k][0] == plan_.from) std::reverse(long_edge.begin(), long_edge.begin() + p + 1);
    restored_ = recover_merged(*mesh_, vertex_, fans_[k], parents_[k], {long_edge.data(), index(p + 1)});
  }
}

void CurveVertexRemoval::merge_topology() {
  const EdgePoints old_before = side_of(*mesh_, passage_.before).points;
  const EdgePoints old_after = side_of(*mesh_, passage_.after).points;
  edge_ = new_edge(plan_.from, plan_.to, {old_before.ids.data() + 1, index(mesh_->degree() - 1)}, mesh_->degree());
  starts_.clear();
  for (const Fan& fan : fans_) starts_.push_back(find_half_edge(*mesh_, vertex_, fan[0]));
  merged_triangles_.clear();
  for (std::size_t k = 0; k < fans_.size(); ++k)  // the long edge of a fan runs from its last vertex to its first
    merged_triangles_.push_back(merge_fan(*mesh_, starts_[k], fans_[k][2] == plan_.from ? edge_ : edge_.reversed()));
  const HalfEdgeId one = half_edge(merged_triangles_[0], 2);
  mesh_->link(one, merged_triangles_.size() == 2 ? half_edge(merged_triangles_[1], 2) : none);
  for (const TriangleId t : merged_triangles_) mesh_->set_constraint(half_edge(t, 2), kept_);
  mesh_->free_constraint(dropped_);
  free_edge_points(*mesh_, old_after);
  mesh_->free_point(vertex_);
  after_.clear();
  for (const TriangleId t : before_)
    if (mesh_->is_alive(t)) after_.push_back(t);
}

void CurveVertexRemoval::plan_moves() {
  const int p = mesh_->degree();
  shifted_.clear();
  refitted_.clear();
  moves_.clear();
  on_curve_.assign(edge_.ids.begin(), edge_.ids.begin() + p + 1);
  for (const auto& [q, place] : curve_places_) on_curve_.push_back(q);
  for (const TriangleId t : after_) {
    const auto net = mesh_->net(t);
    const std::array<Vector, 3> shift{footprint_.shift_of(net[0]), footprint_.shift_of(net[1]),
                                      footprint_.shift_of(net[2])};
    const bool is_merged = std::find(merged_triangles_.begin(), merged_triangles_.end(), t) != merged_triangles_.end();
    for (int k = 0; k < mesh_->net_size(); ++k) {
      const PointId q = net[index(k)];
      if (k >= mesh_->layout().first_interior() && is_merged) continue;
      refitted_.emplace_back(q, mesh_->face(t));
      if (k < 3 || contains(on_curve_, q) || contains(shifted_, q)) continue;
      shifted_.push_back(q);
      const auto& [i, j, l] = mesh_->layout().exponents(k);
      moves_.emplace_back(q, mesh_->point(q) + (1.0 / p) * (i * shift[0] + j * shift[1] + l * shift[2]));
    }
  }
  std::sort(refitted_.begin(), refitted_.end());
  refitted_.erase(std::unique(refitted_.begin(), refitted_.end()), refitted_.end());
  old_places_.clear();
  for (const auto& [q, f] : refitted_) old_places_.push_back(mesh_->point(q));
}

void CurveVertexRemoval::move_points() {
  const int p = mesh_->degree();
  for (std::size_t k = 0; k < footprint_.moved.size(); ++k)
    mesh_->set_point(footprint_.moved[k], mesh_->point(footprint_.moved[k]) + footprint_.shifts[k]);
  mesh_->set_point(plan_.from, merged_[0]);
  mesh_->set_point(plan_.to, merged_[index(p)]);
  for (const auto& [q, place] : curve_places_) mesh_->set_point(q, place);
  for (const auto& [q, place] : moves_) mesh_->set_point(q, place);
  for (int k = 1; k < p; ++k) mesh_->set_point(edge_[k], merged_[index(k)]);
}

bool CurveVertexRemoval::place_inner_points() {
  inner_.clear();
  for (const TriangleId t : merged_triangles_) {
    const InnerPoints ids = inner_points(*mesh_, t);
    inner_.insert(inner_.end(), ids.begin(), ids.begin() + interior_size(mesh_->degree()));
  }
  if (restored_) {
    for (std::size_t k = 0; k < fans_.size(); ++k)
      for (int i = mesh_->layout().first_interior(); i < mesh_->net_size(); ++i)
        mesh_->set_point(mesh_->net(merged_triangles_[k])[index(i)], parents_[k].point(i));
  } else if (!patch_.fit_geometry(*mesh_, merged_triangles_, inner_)) {
    return false;
  }
  return all_valid(*mesh_, after_);
}

bool CurveVertexRemoval::refit_fields() {
  const int p = mesh_->degree();
  int column = 2;
  for (std::size_t f = 0; f < mesh_->fields().size(); ++f)
    for (int c = 0; c < mesh_->fields()[f].components; ++c) follow_moves(static_cast<int>(f), c, column++);
  if (restored_) {
    for (std::size_t k = 0; k < fans_.size(); ++k) {
      const TriangleId t = merged_triangles_[k];
      for (int i = 3 + 2 * (p - 1); i < mesh_->net_size(); ++i)  // the long edge's points, then the inner ones
        mesh_->put_fields(mesh_->net(t)[index(i)], mesh_->face(t), parents_[k].row(i));
    }
    return true;
  }
  free_.assign(edge_.ids.begin() + 1, edge_.ids.begin() + p);
  free_.insert(free_.end(), inner_.begin(), inner_.end());
  return (region_kept_ ? merging_ : patch_).fit_fields(*mesh_, merged_triangles_, free_, options_, region_kept_);
}

void CurveVertexRemoval::follow_moves(int field, int component, int column) {
  const bool by_face = mesh_->fields()[index(field)].by_face;
  fits_.clear();
  for (std::size_t k = 0; k < refitted_.size(); ++k) {
    const auto& [q, face] = refitted_[k];
    if (mesh_->point(q) == old_places_[k]) continue;
    if (!by_face && k > 0 && refitted_[k - 1].first == q) continue;  // once a point
    const std::ptrdiff_t first = mesh_->value_index(field, q, face);
    if (first < 0) continue;
    const FaceId of_face = by_face ? face : none;
    auto fit = std::find_if(fits_.begin(), fits_.end(), [&](const auto& each) { return each.first == of_face; });
    if (fit == fits_.end()) fit = fits_.insert(fits_.end(), {of_face, patch_.linear_of(column, of_face)});
    const Patch::Linear& linear = fit->second;
    const double old = mesh_->fields()[index(field)].values[static_cast<std::size_t>(first + component)];
    const double change = patch_.evaluate(linear, mesh_->point(q)) - patch_.evaluate(linear, old_places_[k]);
    mesh_->put_component(field, component, q, face, old + change);
  }
}

void CurveVertexRemoval::settle_integrals(CurveRemoval& removal) {
  integrals_after_.take(*mesh_, after_);
  if (options_.region_change == RegionChange::conserve)
    integrals_before_.restore(*mesh_, after_, integrals_after_);
  else
    removal.integral_change = integrals_before_.change_to(integrals_after_);
}

}  // namespace

CurveRemoval remove_curve_vertex(Mesh& mesh, PointId v, const CurveTolerance& tolerance, const RefitOptions& options) {
  thread_local CurveVertexRemoval removal;
  return removal.run(mesh, v, tolerance, options);
}

}  // namespace pliant
