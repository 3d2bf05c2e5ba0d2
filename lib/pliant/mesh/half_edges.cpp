// lib/pliant/mesh/half_edges.cpp: twins found by inner control points in sound meshes, by vertices in all others.
#include "pliant/mesh/half_edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// What a point is used for. The use of a point inside an edge is the half-edge of the first triangle met there; once
/// the second triangle has been met, the use is `paired` of the second half-edge, so that a third one is noticed
/// without a look at the twins.
constexpr std::int32_t unused = -1, corner = -2, inside_triangle = -3;
constexpr std::int32_t paired(HalfEdgeId h) { return -4 - as_int(h); }
constexpr HalfEdgeId half_edge_of(std::int32_t use) {
  if (use >= 0) return HalfEdgeId{use};
  return use <= paired(HalfEdgeId{0}) ? HalfEdgeId{paired(HalfEdgeId{use})} : none;
}

/// True if two of the ids are equal. Most vertices have three neighbours with higher numbers, so few ids are usual, and
/// are compared pair by pair.
bool has_duplicates(std::span<PointId> ids) {
  if (ids.size() > 12) {
    std::ranges::sort(ids);
    return std::ranges::adjacent_find(ids) != ids.end();
  }
  for (std::size_t i = 1; i < ids.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (ids[i] == ids[j]) return true;
  return false;
}

}  // namespace

HalfEdges::HalfEdges(const MeshData& data) : HalfEdges(data, data.degree == 1) {}
HalfEdges HalfEdges::by_vertices(const MeshData& data) { return HalfEdges(data, true); }

HalfEdges::HalfEdges(const MeshData& data, bool by_vertices)
    : data_(&data), n_(index(net_size(data.degree))), triangles_(static_cast<TriangleId>(data.triangle_faces.size())) {
  is_sound_ = !by_vertices && pair_by_inner_points() && is_each_star_simple() && is_each_edge_the_only_one();
  if (!is_sound_) pair_by_vertices();
}

/// Asks for memory before pair_by_inner_points reads it, since the reads are scattered: the uses of inner points for a
/// triangle far ahead, and for one nearer what the half-edges in those uses lead to.
void HalfEdges::fetch_for([[maybe_unused]] TriangleId t) const {
#ifdef __GNUC__
  constexpr TriangleId far = 32, near = 16;
  const int inner = data_->degree - 1;
  const auto use_in = [&](TriangleId u, int e) {
    return &use_[index(data_->triangles[index(u) * n_ + 3 + index(e * inner)])];
  };
  for (int e = 0; t + far < triangles_ && e < 3; ++e) __builtin_prefetch(use_in(t + far, e), 1);
  for (int e = 0; t + near < triangles_ && e < 3; ++e) {
    const std::int32_t use = *use_in(t + near, e);
    if (use < 0) continue;
    const HalfEdgeId g{use};
    __builtin_prefetch(&data_->triangles[index(triangle_of(g)) * n_]);
    __builtin_prefetch(&twins_[index(g)], 1);
    __builtin_prefetch(&data_->triangle_faces[index(triangle_of(g))]);
  }
#endif
}

/// Pairs twins by their inner control points, which only the two of them have. False as soon as M1 is broken.
bool HalfEdges::pair_by_inner_points() {
  const NetLayout& layout = NetLayout::of(data_->degree);
  const int inner = data_->degree - 1;
  twins_.assign(3 * index(triangles_), none);
  use_.assign(data_->points.size(), unused);
  borders_.assign(3 * index(triangles_), false);
  for (TriangleId t = 0; t < triangles_; ++t) {
    fetch_for(t);
    const PointId* const net = &data_->triangles[index(t) * n_];
    for (int e = 0; e < 3; ++e) {
      const PointId from = net[e], to = net[e == 2 ? 0 : e + 1];
      std::int32_t& of_corner = use_[index(from)];
      if (from == to || (of_corner != unused && of_corner != corner)) return false;
      of_corner = corner;
      const HalfEdgeId h = half_edge(t, e);
      const PointId* const points = net + 3 + e * inner;
      const std::int32_t use = use_[index(points[0])];
      for (int k = 0; k < inner; ++k) {
        if (use_[index(points[k])] != use) return false;
        use_[index(points[k])] = use == unused ? as_int(h) : paired(h);
      }
      if (use == unused) continue;
      if (use < 0) return false;
      const HalfEdgeId g{use};
      const PointId* const others = &data_->triangles[index(triangle_of(g)) * n_] + 3 + edge_of(g) * inner;
      if (origin(g) != to || target(g) != from) return false;
      for (int k = 0; k < inner; ++k)
        if (others[inner - 1 - k] != points[k]) return false;
      twins_[index(g)] = h;
      twins_[index(h)] = g;
      if (data_->triangle_faces[index(triangle_of(g))] != data_->triangle_faces[index(t)])
        borders_[index(g)] = borders_[index(h)] = true;
    }
    for (int k = layout.first_interior(); k < layout.size(); ++k) {
      std::int32_t& of_point = use_[index(net[k])];
      if (of_point != unused) return false;
      of_point = inside_triangle;
    }
  }
  for (const HalfEdgeId h : data_->half_edges())
    if (twins_[index(h)] == none) borders_[index(h)] = true;
  vertices_ = std::ranges::count(use_, corner);
  return std::ranges::find(use_, unused) == use_.end();
}

/// True if one disk or half-disk of triangles lies around each vertex, by Euler's formula. Count each vertex once for
/// every disk or half-disk around it; for the surface that the triangles make, then,
///   count - edges + triangles = 2 (components - genus) - loops.
/// The genus is at least 0, so the count is at most 2 components - loops + edges - triangles. If that bound is the
/// number of vertices, each vertex counts once (and the genus is 0). So the loops of the outer boundary have to be
/// walked along, but no star around its vertex.
bool HalfEdges::is_each_star_simple() const {
  std::vector<TriangleId> parent(index(triangles_));  // a forest whose trees are the components
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](TriangleId t) {
    while (parent[index(t)] != t) t = parent[index(t)] = parent[index(parent[index(t)])];
    return t;
  };
  std::int64_t components = triangles_, twice_edges = 0, loops = 0;
  std::vector<bool> is_passed(3 * index(triangles_));
  for (const HalfEdgeId h : data_->half_edges()) {
    const HalfEdgeId g = twins_[index(h)];
    twice_edges += g == none ? 2 : 1;
    if (g > h) {
      const TriangleId a = root(triangle_of(h)), b = root(triangle_of(g));
      components -= a != b ? 1 : 0;
      parent[index(std::max(a, b))] = std::min(a, b);
    }
    if (g != none || is_passed[index(h)]) continue;
    ++loops;
    for (HalfEdgeId b = h; !is_passed[index(b)];) {
      is_passed[index(b)] = true;
      for (b = next(b); twins_[index(b)] != none;) b = next(twins_[index(b)]);
    }
  }
  return 2 * components - loops + twice_edges / 2 - triangles_ == vertices_;
}

/// True if no two edges have the same two ends. Edges are sorted into buckets by their lower end.
bool HalfEdges::is_each_edge_the_only_one() const {
  const auto ends = [this](HalfEdgeId h) { return std::minmax({origin(h), target(h)}); };
  const auto is_counted = [this](HalfEdgeId h) { return twin(h) == none || h < twin(h); };
  std::vector<std::uint32_t> bucket(data_->points.size() + 1);
  std::uint32_t edges = 0;
  for (const HalfEdgeId h : data_->half_edges()) {
    if (!is_counted(h)) continue;
    ++edges;
    ++bucket[index(ends(h).first)];
  }
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<PointId> higher(edges);
  for (const HalfEdgeId h : data_->half_edges())
    if (is_counted(h)) higher[index(--bucket[index(ends(h).first)])] = ends(h).second;
  for (std::size_t v = 0; v + 1 < bucket.size(); ++v)
    if (has_duplicates(std::span(higher).subspan(bucket[v], bucket[v + 1] - bucket[v]))) return false;
  return true;
}

void HalfEdges::pair_by_vertices() {
  use_.clear();
  twins_.assign(3 * index(triangles_), none);
  for (std::size_t e = 0; e < uses().count(); ++e) {
    const std::span<const HalfEdgeId> all = uses().of(e);
    const HalfEdgeId h = all[0];
    if (origin(h) == target(h)) continue;
    const auto back = std::ranges::find_if(all, [&](HalfEdgeId g) { return origin(g) != origin(h); });
    if (back == all.end()) continue;
    for (const HalfEdgeId g : all) twins_[index(g)] = origin(g) == origin(h) ? *back : h;
  }
  borders_.assign(3 * index(triangles_), true);
  for (const HalfEdgeId h : data_->half_edges())
    if (twin(h) != none)
      borders_[index(h)] =
          data_->triangle_faces[index(triangle_of(h))] != data_->triangle_faces[index(triangle_of(twin(h)))];
}

const EdgeUses& HalfEdges::uses() const {
  if (!uses_) uses_ = edge_uses(*data_);
  return *uses_;
}

std::array<HalfEdgeId, 2> HalfEdges::along(std::span<const PointId> edge) const {
  std::array<HalfEdgeId, 2> found{none, none};
  const auto see = [&](HalfEdgeId h) {
    const bool forward = origin(h) == edge.front() && target(h) == edge.back();
    const bool backward = origin(h) == edge.back() && target(h) == edge.front();
    if (forward && found[0] == none) found[0] = h;
    if (backward && found[1] == none) found[1] = h;
  };
  if (is_sound_) {
    const HalfEdgeId h = half_edge_of(use_[index(edge[1])]);
    if (h != none) see(h);
    if (h != none && twin(h) != none) see(twin(h));
    if (found[0] != none || found[1] != none) return found;
  }
  for (const HalfEdgeId h : uses().between(*data_, edge.front(), edge.back())) see(h);
  return found;
}

}  // namespace pliant
