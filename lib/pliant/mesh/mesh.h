// lib/pliant/mesh/mesh.h: the one mesh: shared control points by index, adjacency, constrained edges, fields.
#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check/lone_vertices.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

class HalfEdges;

/// A curved mesh that satisfies M1, M2, M4, M5 and M6 (formats/mesh.md) between operations.
///
/// Triangles and points live in *slots*; an operation may free slots (`is_alive`) and reuse them. `compact` renumbers
/// in order, drops the free slots and derives the adjacency anew, exactly as a reader of the written document would.
/// Every pass ends with it, so passes in one process give the same bytes as a pipe of processes.
///
/// A change inside a Transaction is recorded and can be undone bit for bit.
class Mesh {
 public:
  Mesh() = default;
  /// Requires check_structure(data) to be empty. Complexity O(data).
  explicit Mesh(MeshData data);
  /// The document of this mesh; slots are renumbered in order. Complexity O(mesh).
  MeshData to_data() const;
  /// Drops the free slots (see above); size() and tolerance() are measured anew. Does nothing where nothing has
  /// changed. Complexity O(mesh).
  void compact();
  /// True if no slot is free and the numbering is that of the document, so that `compact` renumbers nothing.
  bool is_compact() const { return !stale_.numbering; }
  /// Has nothing but `time`, `criteria` and `extra` changed since `settle`? Changes that were rolled back are none.
  bool is_settled() const { return !stale_.numbering && !stale_.measures && !stale_.numbers; }
  /// Notes that the mesh is what a reader of its document gets, for `reread`.   Requires    that nothing has changed
  /// since it was made or compacted
  void settle() { stale_.numbers = false; }
  /// Compacts, and numbers triangles and points so that neighbours are near (see renumber_along_hilbert).
  /// Complexity O(mesh * log).
  void renumber();

  // -- sizes
  int degree() const { return degree_; }
  int net_size() const { return net_size_; }
  TriangleId triangle_slots() const { return static_cast<TriangleId>(faces_.size()); }
  PointId point_slots() const { return static_cast<PointId>(points_.size()); }
  int triangle_count() const { return triangle_count_; }
  bool is_alive(TriangleId t) const { return faces_[index(t)] >= 0; }

  // -- topology
  /// All slots of half-edges, also those of free triangles.
  HalfEdgeRange half_edges() const { return HalfEdgeRange(triangle_slots()); }
  std::span<const PointId> net(TriangleId t) const {
    return {nets_.data() + index(t) * index(net_size_), index(net_size_)};
  }
  PointId corner(TriangleId t, int c) const { return nets_[index(t) * index(net_size_) + index(c)]; }
  PointId origin(HalfEdgeId h) const { return corner(triangle_of(h), edge_of(h)); }
  PointId target(HalfEdgeId h) const { return origin(next(h)); }
  PointId apex(HalfEdgeId h) const { return origin(previous(h)); }
  /// The k-th control point (0..degree) along the half-edge.
  PointId edge_point(HalfEdgeId h, int k) const {
    return net(triangle_of(h))[index(layout_->edge_index(edge_of(h), k))];
  }
  HalfEdgeId twin(HalfEdgeId h) const { return twins_[index(h)]; }
  ConstraintId constraint(HalfEdgeId h) const { return constraints_[index(h)]; }
  bool is_constrained(HalfEdgeId h) const { return constraints_[index(h)] != none; }
  FaceId face(TriangleId t) const { return faces_[index(t)]; }
  /// One half-edge that leaves vertex v. What other points have is no half-edge, and not always none: ask is_vertex.
  HalfEdgeId vertex_half_edge(PointId v) const { return vertex_half_edges_[index(v)]; }
  bool is_vertex(PointId v) const { return vertex_half_edges_[index(v)] > none; }
  /// Half-edges at a *pinched* vertex, one whose star has several components (half-disks). At least one half-edge of
  /// each component leaves v; others may have come to lead from elsewhere, or be dead. Empty for every other vertex.
  std::span<const HalfEdgeId> pinched_half_edges(PointId v) const {
    if (pinches_.empty()) return {};
    const auto found = pinches_.find(v);
    return found == pinches_.end() ? std::span<const HalfEdgeId>() : std::span<const HalfEdgeId>(found->second);
  }
  bool is_pinched(PointId v) const { return !pinched_half_edges(v).empty(); }
  bool is_point_alive(PointId p) const { return vertex_half_edges_[index(p)] != free_slot; }
  const NetLayout& layout() const { return *layout_; }

  /// The mesh vertices where the boundary complex has a vertex in which no curve ends. No operation removes or moves
  /// one; motion moves the complex's vertex with it.
  std::span<const LoneVertex> lone_vertices() const { return lone_vertices_; }
  bool is_lone_vertex(PointId v) const {
    return !lone_points_.empty() && std::binary_search(lone_points_.begin(), lone_points_.end(), v);
  }

  // -- constrained edges: the constraint of a half-edge names the curve, the parameter at which the edge's span starts,
  // and the vertex there
  CurveId constraint_curve(ConstraintId c) const { return constraint_curves_[index(c)]; }
  double constraint_start(ConstraintId c) const { return constraint_starts_[index(c)]; }
  PointId constraint_first(ConstraintId c) const { return constraint_firsts_[index(c)]; }
  /// True if the half-edge runs in the curve's direction.
  bool runs_forward(HalfEdgeId h) const { return origin(h) == constraint_first(constraint(h)); }
  const BoundaryComplex& boundary() const { return boundary_; }
  const BSpline& spline(CurveId c) const { return boundary_.curves[index(c)].spline; }

  // -- control values: a row is x, y, then every component of every field
  const Point& point(PointId p) const { return points_[index(p)]; }
  /// Those of all slots.
  std::span<const Point> points() const { return points_; }
  int width() const { return width_; }
  const std::vector<Field>& fields() const { return fields_; }
  /// The rows of a triangle's net: net_size x width.
  void gather(TriangleId t, std::span<double> rows) const;
  void gather_points(TriangleId t, std::span<Point> points) const;
  void gather_edge_points(HalfEdgeId h, std::span<Point> points) const;
  /// The row of one control point as seen from a face (fields by face differ between faces).
  void gather_row(PointId p, FaceId f, std::span<double> row) const;
  /// Index of the first component in `fields()[field].values`; none where a field by face has no value there.
  std::ptrdiff_t value_index(int field, PointId p, FaceId f) const;

  // -- the rest of the document
  double time = 0;
  Criteria criteria;
  ExtraMembers extra;
  Box box() const;  ///< of all control points
  /// box() when the mesh was made or last compacted.
  const Box& measured_box() const { return measured_box_; }
  /// The diagonal of box() when the mesh was made or last compacted: tolerances are relative to it.
  double size() const { return size_; }
  /// Places closer than this are the same up to rounding (Box::tolerance of the same box).
  double tolerance() const { return tolerance_; }

  // -- changes; recorded inside a Transaction
  void set_point(PointId p, const Point& position);
  /// Position and fields of one control point, as seen from face f. A place that fields by face do not have is made.
  void put_row(PointId p, FaceId f, std::span<const double> row);
  /// Only the fields (columns 2..) of the row.
  void put_fields(PointId p, FaceId f, std::span<const double> row);
  /// One component of one field at one control point (`f` matters for fields by face only).
  void put_component(int field, int component, PointId p, FaceId f, double value);
  PointId add_point();
  void free_point(PointId p);
  /// A triangle of face f with an unset net and no neighbours.
  TriangleId add_triangle(FaceId f);
  void free_triangle(TriangleId t);
  void set_net_point(TriangleId t, int k, PointId p);
  void link(HalfEdgeId h, HalfEdgeId g);  ///< makes them twins; either may be none
  void set_constraint(HalfEdgeId h, ConstraintId c);
  ConstraintId add_constraint(CurveId curve, double start, PointId first);
  void set_constraint_record(ConstraintId c, CurveId curve, double start, PointId first);
  void free_constraint(ConstraintId c);
  void set_vertex_half_edge(PointId v, HalfEdgeId h);
  /// Inserts a knot into a curve, or removes a break, as BSpline does; the log keeps only the entries that change.
  void insert_knot(CurveId c, double t);
  std::optional<double> remove_break(CurveId c, double t);
  void set_curve_point(CurveId c, int i, const Point& place);
  void set_removal_error(CurveId c, double error);
  /// Drops the place (p, f) of fields by face, if there is one: face f is no longer around p.
  void drop_place(PointId p, FaceId f);

  /// Replaces the field of the same name, or adds one. Not recorded: for tools and passes, outside operations.
  /// Requires    sizes that fit, and by face the places of the mesh
  void set_field(Field field);
  /// Moves all control points, curves or vertices of the boundary complex (motion); not recorded.
  void set_points(std::vector<Point> points);
  void set_boundary_motion(CurveId c, BSpline spline);
  void set_boundary_vertex(int v, const Point& p);

 private:
  friend class Transaction;
  static constexpr HalfEdgeId free_slot{-2};  // less than none
  enum class Log : std::uint32_t;
  struct LogEntry {
    Log what;
    std::uint32_t index;
    std::uint64_t bits;
  };
  static std::uint64_t place_key(PointId p, FaceId f) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(p)) << 32) | static_cast<std::uint32_t>(f);
  }
  Mesh(MeshData& data, const HalfEdges& half_edges);
  void measure();
  void constrain(const std::vector<ConstrainedEdge>& edges, const HalfEdges& half_edges);
  void find_vertex_half_edges();
  void find_pinches();
  void note_lone_points();
  void renumber_in_order();
  /// A place of fields by face: (point, face), and its slot.
  struct Place {
    std::array<std::int32_t, 2> at;
    std::int32_t slot;
    friend bool operator<(const Place& a, const Place& b) { return a.at < b.at; }
  };
  /// All places, sorted; number[p] is the number that point p shall have.
  std::vector<Place> list_places(const std::vector<PointId>& number) const;
  void sort_places(const std::vector<PointId>& number);
  void log(Log what, std::size_t index, std::uint64_t bits) {
    if (recording_ > 0) log_.push_back({what, static_cast<std::uint32_t>(index), bits});
  }
  template <class Id>
  void put_id(Log what, std::vector<Id>& array, std::size_t i, std::type_identity_t<Id> value);
  void put_value(std::size_t field, std::size_t i, double value);
  /// Calls `change` with the curve and the list in which it notes its edits, null where nothing is recorded.
  template <class Change>
  void edit_curve(CurveId c, const Change& change);
  void undo(std::size_t mark);
  std::int32_t make_place(PointId p, FaceId f);
  bool leaves(HalfEdgeId h, PointId v) const { return is_alive(triangle_of(h)) && origin(h) == v; }
  void note_pinched(PointId v, HalfEdgeId h);
  void forget_stale_pinches();

  int degree_ = 2;
  int net_size_ = 6;
  int width_ = 2;
  double size_ = 0, tolerance_ = 0;
  Box measured_box_;
  int triangle_count_ = 0;
  const NetLayout* layout_ = &NetLayout::of(2);
  std::vector<Point> points_;
  std::vector<PointId> nets_;
  std::vector<FaceId> faces_;  // none: a free slot
  std::vector<HalfEdgeId> twins_;
  std::vector<ConstraintId> constraints_;
  std::vector<HalfEdgeId> vertex_half_edges_;  // free_slot where the point is free
  std::vector<CurveId> constraint_curves_;     // none: a free slot
  std::vector<PointId> constraint_firsts_;
  std::vector<double> constraint_starts_;
  std::vector<Field> fields_;
  // Half-edges at pinched vertices. Operations add those they make. None is taken out as long as a transaction may be
  // undone, so some may have come to lead from elsewhere; but at least one of each component leaves the vertex.
  std::unordered_map<PointId, std::vector<HalfEdgeId>> pinches_;
  std::vector<PointId> changed_pinches_;
  using Places = std::unordered_map<std::uint64_t, std::int32_t>;  // (point, face) -> slot in fields by face
  /// Map nodes of dropped places, kept so that new places need no allocation; a copy of the mesh starts with none.
  struct SpareNodes {
    SpareNodes() = default;
    SpareNodes(const SpareNodes&) {}
    SpareNodes(SpareNodes&&) = default;
    SpareNodes& operator=(const SpareNodes&) { return *this; }
    SpareNodes& operator=(SpareNodes&&) = default;
    std::vector<Places::node_type> nodes;
  };
  void insert_place(std::uint64_t key, std::int32_t place);
  void erase_place(Places::const_iterator found) { spare_nodes_.nodes.push_back(places_.extract(found)); }
  Places places_;
  SpareNodes spare_nodes_;
  std::vector<std::int32_t> free_places_;
  std::int32_t place_count_ = 0;
  bool has_by_face_ = false;
  BoundaryComplex boundary_;
  std::vector<LoneVertex> lone_vertices_;
  std::vector<PointId> lone_points_;  // the points of lone_vertices_, ascending
  std::vector<std::int32_t> free_triangles_, free_points_, free_constraints_;
  std::vector<LogEntry> log_;
  BSpline::Edits curve_edits_;  // in the order of their entries in the log
  int recording_ = 0;           // how many transactions are open
  /// What has changed, so that `compact` and `reread` do only what there is to do. A transaction that is rolled back
  /// restores it.
  struct Stale {
    bool numbering = false;  // more than positions and values has changed: compact must derive the mesh anew
    bool measures = false;   // a control point has moved since size() was measured
    bool numbers = false;    // some number is not what it was when `settle` was called
  };
  Stale stale_;
};

/// All changes of a mesh between construction and `commit`; without commit, or after `roll_back`, the mesh is bit for
/// bit as it was. Transactions nest: an inner one may be rolled back alone.
class Transaction {
 public:
  explicit Transaction(Mesh& mesh) : mesh_(mesh), mark_(mesh.log_.size()), stale_(mesh.stale_) { ++mesh_.recording_; }
  ~Transaction() {
    if (open_) roll_back();
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();
  void roll_back();

 private:
  Mesh& mesh_;
  std::size_t mark_;
  Mesh::Stale stale_;  // as it was before
  bool open_ = true;
};

}  // namespace pliant
