// lib/pliant/fem/space.cpp: unknowns as classes of control points, seen from faces.
#include "pliant/fem/space.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// A control point as seen from a face.
struct Place {
  PointId point;
  FaceId face;
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// Every place of a mesh, and which of them are one because the function is continuous there.
class Places {
 public:
  explicit Places(const Mesh& mesh) {
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
      for (const PointId p : mesh.net(t)) places_.push_back({p, mesh.face(t)});
    std::ranges::sort(places_);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    parent_.resize(places_.size());
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void unite(const Place& a, const Place& b) {
    const std::size_t i = root(find(a)), k = root(find(b));
    parent_[std::max(i, k)] = std::min(i, k);
  }
  /// The number of the class.
  std::int64_t operator()(const Place& place) { return static_cast<std::int64_t>(root(find(place))); }
  std::int64_t count() const { return static_cast<std::int64_t>(places_.size()); }

 private:
  std::size_t find(const Place& place) const {
    return index(std::ranges::lower_bound(places_, place) - places_.begin());
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<Place> places_;
  std::vector<std::size_t> parent_;
};

void unite_across(const Mesh& mesh, std::span<const char> jumps, Places& places) {
  for (const HalfEdgeId h : mesh.half_edges()) {
    const HalfEdgeId twin = mesh.twin(h);
    if (twin == none || as_int(h) > as_int(twin)) continue;
    const FaceId here = mesh.face(triangle_of(h)), there = mesh.face(triangle_of(twin));
    if (here == there) continue;
    assert(mesh.is_constrained(h));  // faces meet on curves only (M5)
    if (jumps[index(mesh.constraint_curve(mesh.constraint(h)))] != 0) continue;
    for (int k = 0; k <= mesh.degree(); ++k)
      places.unite({mesh.edge_point(h, k), here}, {mesh.edge_point(h, k), there});
  }
}

}  // namespace

Space::Space(const Mesh& mesh, int degree) : degree_(degree), net_size_(pliant::net_size(degree)) {
  assert(mesh.is_compact());
  unknowns_.reserve(index(mesh.triangle_slots()) * index(net_size_));
}

/// Numbers the classes, each with a key of its own below `greatest`, as they occur.
void Space::number(std::span<const std::int64_t> keys, std::int64_t greatest) {
  std::vector<int> numbers(index(greatest), -1);
  for (const std::int64_t key : keys) {
    int& number = numbers[index(key)];
    if (number < 0) number = size_++;
    unknowns_.push_back(number);
  }
}

Space Space::continuous(const Mesh& mesh) {
  Space space(mesh, mesh.degree());
  std::vector<int> numbers(index(mesh.point_slots()), -1);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) {
      int& number = numbers[index(p)];
      if (number < 0) number = space.size_++;
      space.unknowns_.push_back(number);
    }
  return space;
}

Space Space::by_face(const Mesh& mesh, int degree, std::span<const char> jumps) {
  assert(degree >= 1 && degree <= mesh.degree());
  assert(jumps.size() == mesh.boundary().curves.size());
  Space space(mesh, degree);
  Places places(mesh);
  unite_across(mesh, jumps, places);
  // An edge of the lower degree has fewer unknowns inside than the edge has control points: each of them takes the key
  // of one of these, in a direction that both triangles see alike. The interior takes the keys of interior points.
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<std::int64_t> keys;
  keys.reserve(space.unknowns_.capacity());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const FaceId face = mesh.face(t);
    for (int c = 0; c < 3; ++c) keys.push_back(places({mesh.corner(t, c), face}));
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      const bool forward = mesh.origin(h) < mesh.target(h);
      for (int k = 1; k < degree; ++k) {
        const int from_first = forward ? k : degree - k;  // along the edge, from its end with the lower number
        keys.push_back(places({mesh.edge_point(h, forward ? from_first : mesh.degree() - from_first), face}));
      }
    }
    for (int i = layout.first_interior(); i < layout.size(); ++i)
      keys.push_back(places({mesh.net(t)[index(mesh.layout().first_interior() + i - layout.first_interior())], face}));
  }
  space.number(keys, places.count());
  return space;
}

}  // namespace pliant
