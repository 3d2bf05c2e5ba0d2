// lib/pliant/mesh/mesh.cpp: the one mesh: shared control points by index, adjacency, constrained edges, fields.
#include "pliant/mesh/mesh.h"

#include <algorithm>
#include <bit>

#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh_log.h"

namespace pliant {

Box Mesh::box() const {
  Point low = Box().low, high = Box().high;  // Box::extend without a branch
  const bool is_any_free = !free_points_.empty();
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (is_any_free && vertex_half_edges_[p] == free_slot) continue;
    low = {std::min(low.x, points_[p].x), std::min(low.y, points_[p].y)};
    high = {std::max(high.x, points_[p].x), std::max(high.y, points_[p].y)};
  }
  return {low, high};
}

// -- control values

std::ptrdiff_t Mesh::value_index(int field, PointId p, FaceId f) const {
  const Field& data = fields_[index(field)];
  if (!data.by_face) return static_cast<std::ptrdiff_t>(p) * data.components;
  const auto found = places_.find(place_key(p, f));
  return found == places_.end() ? none : static_cast<std::ptrdiff_t>(found->second) * data.components;
}

void Mesh::gather_row(PointId p, FaceId f, std::span<double> row) const {
  row[0] = points_[index(p)].x;
  row[1] = points_[index(p)].y;
  std::size_t column = 2;
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const std::ptrdiff_t first = value_index(static_cast<int>(k), p, f);
    for (int c = 0; c < fields_[k].components; ++c)
      row[column++] = first < 0 ? 0.0 : fields_[k].values[index(first + c)];
  }
}

void Mesh::gather(TriangleId t, std::span<double> rows) const {
  const std::size_t width = index(width_);
  const auto ids = net(t);
  for (std::size_t n = 0; n < ids.size(); ++n) gather_row(ids[n], face(t), rows.subspan(n * width, width));
}

void Mesh::gather_points(TriangleId t, std::span<Point> points) const {
  const auto ids = net(t);
  for (std::size_t n = 0; n < ids.size(); ++n) points[n] = points_[index(ids[n])];
}

void Mesh::gather_edge_points(HalfEdgeId h, std::span<Point> points) const {
  for (int k = 0; k <= degree_; ++k) points[index(k)] = point(edge_point(h, k));
}

// -- recorded changes

template <class Id>
void Mesh::put_id(Log what, std::vector<Id>& array, std::size_t i, std::type_identity_t<Id> value) {
  if (array[i] == value) return;
  log(what, i, static_cast<std::uint64_t>(static_cast<std::int64_t>(array[i])));
  array[i] = value;
  stale_.numbering = true;
}

void Mesh::put_value(std::size_t field, std::size_t i, double value) {
  double& old = fields_[field].values[i];
  log(static_cast<Log>(static_cast<std::uint32_t>(Log::value) + static_cast<std::uint32_t>(field)), i,
      std::bit_cast<std::uint64_t>(old));
  old = value;
  stale_.numbers = true;
}

void Mesh::set_point(PointId p, const Point& position) {
  Point& old = points_[index(p)];
  log(Log::point_x, index(p), std::bit_cast<std::uint64_t>(old.x));
  log(Log::point_y, index(p), std::bit_cast<std::uint64_t>(old.y));
  old = position;
  stale_.measures = true;
}

void Mesh::insert_place(std::uint64_t key, std::int32_t place) {
  if (spare_nodes_.nodes.empty()) {
    places_.emplace(key, place);
    return;
  }
  Places::node_type node = std::move(spare_nodes_.nodes.back());
  spare_nodes_.nodes.pop_back();
  node.key() = key;
  node.mapped() = place;
  places_.insert(std::move(node));
}

std::int32_t Mesh::make_place(PointId p, FaceId f) {
  std::int32_t place;
  if (!free_places_.empty()) {
    place = free_places_.back();
    free_places_.pop_back();
    log(Log::pop_place, 0, static_cast<std::uint64_t>(place));
  } else {
    place = place_count_++;
    for (Field& field : fields_)
      if (field.by_face) field.values.resize(index(place_count_) * index(field.components));
    log(Log::grow_places, 0, 0);
  }
  insert_place(place_key(p, f), place);
  log(Log::insert_place, 0, place_key(p, f));
  stale_.numbering = true;
  return place;
}

void Mesh::drop_place(PointId p, FaceId f) {
  const auto found = places_.find(place_key(p, f));
  if (found == places_.end()) return;
  log(Log::erase_place, static_cast<std::size_t>(found->second), found->first);
  free_places_.push_back(found->second);
  log(Log::push_place, 0, 0);
  erase_place(found);
  stale_.numbering = true;
}

void Mesh::put_fields(PointId p, FaceId f, std::span<const double> row) {
  std::size_t column = 2;
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    std::ptrdiff_t first = value_index(static_cast<int>(k), p, f);
    if (first < 0) first = static_cast<std::ptrdiff_t>(make_place(p, f)) * fields_[k].components;
    for (int c = 0; c < fields_[k].components; ++c) put_value(k, index(first + c), row[column++]);
  }
}

void Mesh::put_component(int field, int component, PointId p, FaceId f, double value) {
  std::ptrdiff_t first = value_index(field, p, f);
  if (first < 0) first = static_cast<std::ptrdiff_t>(make_place(p, f)) * fields_[index(field)].components;
  put_value(index(field), index(first + component), value);
}

void Mesh::put_row(PointId p, FaceId f, std::span<const double> row) {
  set_point(p, {row[0], row[1]});
  put_fields(p, f, row);
}

PointId Mesh::add_point() {
  stale_.numbering = true;
  if (!free_points_.empty()) {
    const PointId p = free_points_.back();
    free_points_.pop_back();
    log(Log::pop_point, 0, static_cast<std::uint64_t>(p));
    put_id(Log::vertex_half_edge, vertex_half_edges_, index(p), none);
    return p;
  }
  points_.emplace_back();
  vertex_half_edges_.push_back(none);
  for (Field& field : fields_)
    if (!field.by_face) field.values.resize(field.values.size() + index(field.components));
  log(Log::grow_points, 0, 0);
  return static_cast<PointId>(points_.size()) - 1;
}

void Mesh::free_point(PointId p) {
  if (has_by_face_)
    for (FaceId f = 0; f < static_cast<FaceId>(boundary_.faces.size()); ++f) drop_place(p, f);
  put_id(Log::vertex_half_edge, vertex_half_edges_, index(p), free_slot);
  free_points_.push_back(p);
  log(Log::push_point, 0, 0);
}

TriangleId Mesh::add_triangle(FaceId f) {
  TriangleId t;
  if (!free_triangles_.empty()) {
    t = free_triangles_.back();
    free_triangles_.pop_back();
    log(Log::pop_triangle, 0, static_cast<std::uint64_t>(t));
  } else {
    t = triangle_slots();
    faces_.push_back(none);
    nets_.resize(nets_.size() + index(net_size_), none);
    twins_.resize(twins_.size() + 3, none);
    constraints_.resize(constraints_.size() + 3, none);
    log(Log::grow_triangles, 0, 0);
  }
  put_id(Log::face, faces_, index(t), f);
  for (int e = 0; e < 3; ++e) {
    put_id(Log::twin, twins_, index(half_edge(t, e)), none);
    put_id(Log::constraint, constraints_, index(half_edge(t, e)), none);
  }
  ++triangle_count_;
  return t;
}

void Mesh::free_triangle(TriangleId t) {
  put_id(Log::face, faces_, index(t), none);
  free_triangles_.push_back(t);
  log(Log::push_triangle, 0, 0);
  --triangle_count_;
}

void Mesh::set_net_point(TriangleId t, int k, PointId p) {
  put_id(Log::net, nets_, index(t) * index(net_size_) + index(k), p);
}

void Mesh::link(HalfEdgeId h, HalfEdgeId g) {
  if (h != none) put_id(Log::twin, twins_, index(h), g);
  if (g != none) put_id(Log::twin, twins_, index(g), h);
}

void Mesh::set_constraint(HalfEdgeId h, ConstraintId c) { put_id(Log::constraint, constraints_, index(h), c); }

ConstraintId Mesh::add_constraint(CurveId curve, double start, PointId first) {
  ConstraintId c;
  if (!free_constraints_.empty()) {
    c = free_constraints_.back();
    free_constraints_.pop_back();
    log(Log::pop_constraint, 0, static_cast<std::uint64_t>(c));
  } else {
    c = static_cast<ConstraintId>(constraint_curves_.size());
    constraint_curves_.push_back(none);
    constraint_firsts_.push_back(none);
    constraint_starts_.push_back(0);
    log(Log::grow_constraints, 0, 0);
  }
  set_constraint_record(c, curve, start, first);
  return c;
}

void Mesh::set_constraint_record(ConstraintId c, CurveId curve, double start, PointId first) {
  put_id(Log::constraint_curve, constraint_curves_, index(c), curve);
  put_id(Log::constraint_first, constraint_firsts_, index(c), first);
  log(Log::constraint_start, index(c), std::bit_cast<std::uint64_t>(constraint_starts_[index(c)]));
  constraint_starts_[index(c)] = start;
  stale_.numbering = true;
}

void Mesh::free_constraint(ConstraintId c) {
  put_id(Log::constraint_curve, constraint_curves_, index(c), none);
  free_constraints_.push_back(c);
  log(Log::push_constraint, 0, 0);
}

void Mesh::set_vertex_half_edge(PointId v, HalfEdgeId h) {
  put_id(Log::vertex_half_edge, vertex_half_edges_, index(v), h);
  if (!pinches_.empty()) note_pinched(v, h);
}

void Mesh::note_pinched(PointId v, HalfEdgeId h) {
  const auto found = pinches_.find(v);
  if (found == pinches_.end()) return;
  std::vector<HalfEdgeId>& known = found->second;
  if (std::find(known.begin(), known.end(), h) != known.end()) return;
  known.push_back(h);
  changed_pinches_.push_back(v);
}

void Mesh::forget_stale_pinches() {
  for (const PointId v : changed_pinches_)
    std::erase_if(pinches_.at(v), [this, v](HalfEdgeId h) { return !leaves(h, v); });
  changed_pinches_.clear();
}

template <class Change>
void Mesh::edit_curve(CurveId c, const Change& change) {
  const std::size_t before = curve_edits_.size();
  stale_.numbers = true;
  change(boundary_.curves[index(c)].spline, recording_ > 0 ? &curve_edits_ : nullptr);
  for (std::size_t k = before; k < curve_edits_.size(); ++k) log(Log::curve_edit, index(c), 0);
}

void Mesh::insert_knot(CurveId c, double t) {
  edit_curve(c, [t](BSpline& spline, BSpline::Edits* edits) { spline.insert_knot(t, edits); });
}

std::optional<double> Mesh::remove_break(CurveId c, double t) {
  std::optional<double> error;
  edit_curve(c, [&](BSpline& spline, BSpline::Edits* edits) { error = spline.remove_break(t, edits); });
  return error;
}

void Mesh::set_curve_point(CurveId c, int i, const Point& place) {
  edit_curve(c, [&](BSpline& spline, BSpline::Edits* edits) { spline.set_point(i, place, edits); });
}

void Mesh::set_removal_error(CurveId c, double error) {
  double& old = boundary_.curves[index(c)].removal_error;
  log(Log::removal_error, index(c), std::bit_cast<std::uint64_t>(old));
  old = error;
  stale_.numbers = true;
}

// -- whole-mesh changes, not recorded

void Mesh::set_points(std::vector<Point> points) {
  assert(recording_ == 0 && points.size() == points_.size());
  points_ = std::move(points);
  stale_.measures = true;
}

void Mesh::set_boundary_motion(CurveId c, BSpline spline) {
  boundary_.curves[index(c)].spline = std::move(spline);
  stale_.numbers = true;
}

void Mesh::set_boundary_vertex(int v, const Point& p) {
  boundary_.vertices[index(v)] = p;
  stale_.numbers = true;
}

}  // namespace pliant
