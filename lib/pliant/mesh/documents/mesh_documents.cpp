// lib/pliant/mesh/documents/mesh_documents.cpp: a mesh from its document and back: numbers, adjacency, constrained
// edges, fields.
#include <algorithm>

#include "pliant/geometry/index.h"
#include "pliant/mesh/documents/span_edges.h"
#include "pliant/mesh/half_edges.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/renumber.h"

namespace pliant {
namespace {

/// The constrained edges as a document has them; number[p] is the number of point p there.
std::vector<ConstrainedEdge> list_constrained_edges(const Mesh& mesh, const std::vector<PointId>& number) {
  std::vector<ConstrainedEdge> edges;
  const int p = mesh.degree();
  for (const SpanEdge& span : span_edges(mesh)) {
    ConstrainedEdge& edge = edges.emplace_back();
    edge.curve = span.curve;
    edge.span = span.number;
    edge.points.reserve(index(p + 1));
    for (int k = 0; k <= p; ++k)
      edge.points.push_back(number[index(mesh.edge_point(span.half_edge, span.is_forward ? k : p - k))]);
  }
  return edges;
}

}  // namespace

Mesh::Mesh(MeshData data) : Mesh(data, HalfEdges(data)) {}

Mesh::Mesh(MeshData& data, const HalfEdges& half_edges)
    : time(data.time),
      criteria(std::move(data.criteria)),
      extra(std::move(data.extra)),
      degree_(data.degree),
      net_size_(pliant::net_size(data.degree)),
      layout_(&NetLayout::of(data.degree)),
      lone_vertices_(find_lone_vertices(data)) {
  boundary_ = std::move(data.boundary);
  note_lone_points();
  twins_ = half_edges.twins();
  constrain(data.constrained_edges, half_edges);
  points_ = std::move(data.points);
  nets_ = std::move(data.triangles);
  faces_ = std::move(data.triangle_faces);
  triangle_count_ = static_cast<int>(faces_.size());
  find_vertex_half_edges();
  find_pinches();
  for (Field& field : data.fields) set_field(std::move(field));
  measure();
  stale_.numbering = false;
  stale_.numbers = true;
}

void Mesh::note_lone_points() {
  lone_points_.clear();
  for (const LoneVertex& each : lone_vertices_)
    if (each.point != none) lone_points_.push_back(each.point);
  std::sort(lone_points_.begin(), lone_points_.end());
}

void Mesh::measure() {
  measured_box_ = box();
  size_ = measured_box_.size();
  tolerance_ = measured_box_.tolerance();
  stale_.numbers = stale_.numbers || stale_.measures;
  stale_.measures = false;
}

void Mesh::set_field(Field field) {
  assert(recording_ == 0);
  stale_.numbers = true;
  if (field.by_face && !has_by_face_) {
    has_by_face_ = true;
    place_count_ = static_cast<std::int32_t>(field.places.size());
    for (std::size_t k = 0; k < field.places.size(); ++k)
      places_.emplace(place_key(field.places[k][0], field.places[k][1]), static_cast<std::int32_t>(k));
  }
  field.places.clear();
  const auto same =
      std::find_if(fields_.begin(), fields_.end(), [&field](const Field& old) { return old.name == field.name; });
  if (same == fields_.end())
    fields_.push_back(std::move(field));
  else
    *same = std::move(field);
  width_ = 2;
  for (const Field& each : fields_) width_ += each.components;
}

void Mesh::constrain(const std::vector<ConstrainedEdge>& edges, const HalfEdges& half_edges) {
  constraints_.assign(twins_.size(), none);
  std::vector<std::vector<double>> breaks(boundary_.curves.size());
  for (const ConstrainedEdge& edge : edges) {
    std::vector<double>& starts = breaks[index(edge.curve)];
    if (starts.empty()) starts = spline(edge.curve).breaks();
    const ConstraintId c = add_constraint(edge.curve, starts[index(edge.span)], edge.points.front());
    for (const HalfEdgeId h : half_edges.along(edge.points))
      if (h != none) constraints_[index(h)] = c;
  }
}

/// Chooses the first half-edge that leaves each vertex.
void Mesh::find_vertex_half_edges() {
  vertex_half_edges_.assign(points_.size(), none);
  for (TriangleId t = triangle_slots(); t-- > 0;)
    for (int e = 3; e-- > 0;) vertex_half_edges_[index(corner(t, e))] = half_edge(t, e);
}

/// Each component of an open star begins with a half-edge that has no twin. Two of them at one vertex: it is pinched.
void Mesh::find_pinches() {
  std::vector<std::pair<PointId, HalfEdgeId>> open;
  for (const HalfEdgeId h : half_edges())
    if (twins_[index(h)] == none) open.emplace_back(origin(h), h);
  std::sort(open.begin(), open.end());
  pinches_.clear();
  for (std::size_t first = 0, last = 0; first < open.size(); first = last) {
    while (last < open.size() && open[last].first == open[first].first) ++last;
    if (last - first < 2) continue;
    std::vector<HalfEdgeId>& known = pinches_[open[first].first];
    for (std::size_t k = first; k < last; ++k) known.push_back(open[k].second);
  }
}

std::vector<Mesh::Place> Mesh::list_places(const std::vector<PointId>& number) const {
  std::vector<Place> places;
  places.reserve(places_.size());
  for (const auto& [key, slot] : places_)
    places.push_back({{number[index(static_cast<PointId>(key >> 32))], static_cast<FaceId>(key & 0xffffffffu)}, slot});
  std::sort(places.begin(), places.end());
  return places;
}

MeshData Mesh::to_data() const {
  MeshData data;
  data.degree = degree_;
  data.time = time;
  data.criteria = criteria;
  data.extra = extra;
  data.boundary = boundary_;

  std::vector<PointId> number(points_.size(), none);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (vertex_half_edges_[p] == free_slot) continue;
    number[p] = static_cast<PointId>(data.points.size());
    data.points.push_back(points_[p]);
  }
  data.triangles.reserve(index(triangle_count_) * index(net_size_));
  data.triangle_faces.reserve(index(triangle_count_));
  for (TriangleId t = 0; t < triangle_slots(); ++t) {
    if (!is_alive(t)) continue;
    for (const PointId p : net(t)) data.triangles.push_back(number[index(p)]);
    data.triangle_faces.push_back(face(t));
  }

  data.constrained_edges = list_constrained_edges(*this, number);

  const std::vector<Place> places = list_places(number);
  for (const Field& field : fields_) {
    Field out;
    out.name = field.name;
    out.components = field.components;
    out.by_face = field.by_face;
    out.extra = field.extra;
    const auto copy = [&](std::size_t slot) {
      for (std::size_t c = 0; c < index(field.components); ++c)
        out.values.push_back(field.values[slot * index(field.components) + c]);
    };
    if (field.by_face) {
      for (const auto& [at, slot] : places) {
        out.places.push_back(at);
        copy(index(slot));
      }
    } else {
      for (std::size_t p = 0; p < points_.size(); ++p)
        if (number[p] != none) copy(p);
    }
    data.fields.push_back(std::move(out));
  }
  return data;
}

void Mesh::renumber() {
  assert(recording_ == 0);
  MeshData data = to_data();
  renumber_along_hilbert(data);
  *this = Mesh(std::move(data));
}

}  // namespace pliant
