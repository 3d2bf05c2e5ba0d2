// lib/pliant/mesh/documents/mesh_documents.cpp: a mesh from its document and back: numbers, adjacency, constrained
// edges, fields.
#include <algorithm>

#include "pliant/geometry/index.h"
#include "pliant/mesh/half_edges.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/renumber.h"

namespace pliant {
namespace {

/// The constrained edges as a document has them, sorted by curve and span; number[p] is the number of point p there.
std::vector<ConstrainedEdge> list_constrained_edges(const Mesh& mesh, const std::vector<PointId>& number) {
  std::vector<ConstrainedEdge> edges;
  std::vector<std::vector<double>> breaks(mesh.boundary().curves.size());
  const int p = mesh.degree();
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (!mesh.is_constrained(h)) continue;
      const bool forward = mesh.runs_forward(h);
      if (!forward && mesh.twin(h) != none) continue;  // its twin is listed
      const ConstraintId c = mesh.constraint(h);
      ConstrainedEdge edge;
      edge.curve = mesh.constraint_curve(c);
      std::vector<double>& starts = breaks[static_cast<std::size_t>(edge.curve)];
      if (starts.empty()) starts = mesh.spline(edge.curve).breaks();
      const double start = mesh.constraint_start(c);
      edge.span = static_cast<int>(std::lower_bound(starts.begin(), starts.end(), start) - starts.begin());
      for (int k = 0; k <= p; ++k)
        edge.points.push_back(number[static_cast<std::size_t>(mesh.edge_point(h, forward ? k : p - k))]);
      edges.push_back(std::move(edge));
    }
  }
  std::sort(edges.begin(), edges.end(), [](const ConstrainedEdge& a, const ConstrainedEdge& b) {
    return std::pair{a.curve, a.span} < std::pair{b.curve, b.span};
  });
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
  for (const LoneVertex& each : lone_vertices_)
    if (each.point != none) lone_points_.push_back(each.point);
  std::sort(lone_points_.begin(), lone_points_.end());
  connect(data, half_edges);
  points_ = std::move(data.points);
  nets_ = std::move(data.triangles);
  faces_ = std::move(data.triangle_faces);
  triangle_count_ = static_cast<int>(faces_.size());
  for (Field& field : data.fields) set_field(std::move(field));
  measure();
  stale_.numbering = false;
  stale_.numbers = true;
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

void Mesh::connect(const MeshData& data, const HalfEdges& half_edges) {
  twins_ = half_edges.twins();
  constraints_.assign(twins_.size(), none);
  vertex_half_edges_.assign(data.points.size(), none);
  for (std::size_t t = data.triangle_faces.size(); t-- > 0;)
    for (int e = 3; e-- > 0;)
      vertex_half_edges_[index(data.triangles[t * index(net_size_) + index(e)])] =
          half_edge(static_cast<TriangleId>(t), e);

  // Each component of an open star begins with a half-edge that has no twin. Two of them at one vertex: it is pinched.
  std::vector<char> is_open(data.points.size(), 0);
  std::vector<PointId> pinched;
  for (const HalfEdgeId h : data.half_edges()) {
    if (twins_[index(h)] != none) continue;
    const PointId v = data.triangles[index(triangle_of(h)) * index(net_size_) + index(edge_of(h))];
    if (is_open[index(v)] == 1) pinched.push_back(v);
    if (is_open[index(v)] < 2) ++is_open[index(v)];
  }
  for (const PointId v : pinched) pinches_[v];
  for (const HalfEdgeId h : data.half_edges()) {
    if (pinched.empty()) break;
    if (twins_[index(h)] != none) continue;
    const auto found = pinches_.find(data.triangles[index(triangle_of(h)) * index(net_size_) + index(edge_of(h))]);
    if (found != pinches_.end()) found->second.push_back(h);
  }

  std::vector<std::vector<double>> breaks(boundary_.curves.size());
  for (const ConstrainedEdge& edge : data.constrained_edges) {
    std::vector<double>& starts = breaks[index(edge.curve)];
    if (starts.empty()) starts = spline(edge.curve).breaks();
    const ConstraintId c = add_constraint(edge.curve, starts[index(edge.span)], edge.points.front());
    for (const HalfEdgeId h : half_edges.along(edge.points))
      if (h != none) constraints_[index(h)] = c;
  }
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

  std::vector<std::pair<std::array<std::int32_t, 2>, std::int32_t>> places;
  for (const auto& [key, place] : places_)
    places.push_back({{number[index(static_cast<PointId>(key >> 32))], static_cast<FaceId>(key & 0xffffffffu)}, place});
  std::sort(places.begin(), places.end());
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
      for (const auto& [place, slot] : places) {
        out.places.push_back(place);
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

void Mesh::compact() {
  assert(recording_ == 0);
  if (stale_.numbering)
    *this = Mesh(to_data());
  else if (stale_.measures)
    measure();
}

void Mesh::renumber() {
  assert(recording_ == 0);
  MeshData data = to_data();
  renumber_along_hilbert(data);
  *this = Mesh(std::move(data));
}

}  // namespace pliant
