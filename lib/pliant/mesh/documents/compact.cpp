// lib/pliant/mesh/documents/compact.cpp: drops the free slots of a mesh in place, and numbers it as a reader of its
// document would.
#include <algorithm>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/mesh/documents/span_edges.h"
#include "pliant/mesh/mesh.h"

namespace pliant {
namespace {

/// New numbers for the slots that `is_alive` takes: 0, 1, 2 and so on, none for the others.
template <class IsAlive>
std::vector<std::int32_t> number_in_order(std::size_t slots, const IsAlive& is_alive) {
  std::vector<std::int32_t> numbers(slots, none);
  std::int32_t next = 0;
  for (std::size_t k = 0; k < slots; ++k)
    if (is_alive(k)) numbers[k] = next++;
  return numbers;
}

/// Moves the `width` values of each slot to its new number, which is none or at most the old one; drops the others.
template <class T>
void move_to(std::vector<T>& values, std::size_t width, const std::vector<std::int32_t>& numbers) {
  std::size_t end = 0;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] == none) continue;
    if (end != k * width)
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(k * width), width,
                  values.begin() + static_cast<std::ptrdiff_t>(end));
    end += width;
  }
  values.resize(end);
}

}  // namespace

void Mesh::compact() {
  assert(recording_ == 0);
  if (stale_.numbering)
    renumber_in_order();
  else if (stale_.measures)
    measure();
}

/// The result is that of Mesh(to_data()), bit for bit, at a fraction of the time: what stays is not copied, and twins
/// are renumbered instead of being found. M2 leaves no choice of them.
void Mesh::renumber_in_order() {
  const std::vector<SpanEdge> spans = span_edges(*this);
  const auto points =
      number_in_order(points_.size(), [this](std::size_t p) { return vertex_half_edges_[p] != free_slot; });
  const auto triangles = number_in_order(faces_.size(), [this](std::size_t t) { return faces_[t] >= 0; });
  const auto moved = [&triangles](HalfEdgeId h) { return half_edge(triangles[index(triangle_of(h))], edge_of(h)); };
  move_to(points_, 1, points);
  for (Field& field : fields_)
    if (!field.by_face) move_to(field.values, index(field.components), points);
  if (has_by_face_) sort_places(points);
  move_to(faces_, 1, triangles);
  move_to(nets_, index(net_size_), triangles);
  move_to(twins_, 3, triangles);
  for (PointId& p : nets_) p = points[index(p)];
  for (HalfEdgeId& h : twins_)
    if (h != none) h = moved(h);
  free_points_.clear();
  free_triangles_.clear();
  triangle_count_ = triangle_slots();

  constraints_.assign(twins_.size(), none);
  constraint_curves_.clear();
  constraint_firsts_.clear();
  constraint_starts_.clear();
  free_constraints_.clear();
  for (const SpanEdge& span : spans) {
    const HalfEdgeId h = moved(span.half_edge);
    const ConstraintId c = add_constraint(span.curve, span.start, span.is_forward ? origin(h) : target(h));
    constraints_[index(h)] = c;
    if (twin(h) != none) constraints_[index(twin(h))] = c;
  }
  find_vertex_half_edges();
  find_pinches();
  changed_pinches_.clear();
  lone_vertices_ = find_lone_vertices(boundary_, degree_, points_, nets_);
  note_lone_points();
  measure();
  stale_.numbering = false;
  stale_.numbers = true;
}

/// Numbers the places of fields by face in the order of points and faces, and drops the free ones.
void Mesh::sort_places(const std::vector<PointId>& number) {
  const std::vector<Place> places = list_places(number);
  places_.clear();
  for (std::size_t k = 0; k < places.size(); ++k)
    places_.emplace(place_key(places[k].at[0], places[k].at[1]), static_cast<std::int32_t>(k));
  place_count_ = static_cast<std::int32_t>(places.size());
  free_places_.clear();
  spare_nodes_.nodes.clear();
  for (Field& field : fields_) {
    if (!field.by_face) continue;
    const std::size_t width = index(field.components);
    std::vector<double> sorted(places.size() * width);
    for (std::size_t k = 0; k < places.size(); ++k)
      std::copy_n(field.values.begin() + static_cast<std::ptrdiff_t>(index(places[k].slot) * width), width,
                  sorted.begin() + static_cast<std::ptrdiff_t>(k * width));
    field.values = std::move(sorted);
  }
}

}  // namespace pliant
