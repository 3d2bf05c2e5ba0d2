// lib/pliant/mesh/edge_uses.cpp: buckets by the lower vertex, each sorted by the higher one.
#include "pliant/mesh/edge_uses.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// The vertices that a half-edge joins, the lower one first.
struct Ends {
  PointId low, high;
};
Ends ends_of(const MeshData& data, std::size_t n, HalfEdgeId h) {
  const PointId* corners = &data.triangles[static_cast<std::size_t>(triangle_of(h)) * n];
  const PointId from = corners[edge_of(h)], to = corners[edge_of(next(h))];
  return from < to ? Ends{from, to} : Ends{to, from};
}

/// Buckets hold some three entries each, for which insertion is fastest.
void sort_bucket(std::uint64_t* first, std::uint64_t* last) {
  if (last - first > 24) return std::sort(first, last);
  for (std::uint64_t* k = first; k < last; ++k) {
    const std::uint64_t key = *k;
    std::uint64_t* hole = k;
    for (; hole > first && hole[-1] > key; --hole) *hole = hole[-1];
    *hole = key;
  }
}

}  // namespace

EdgeUses edge_uses(const MeshData& data) {
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  std::vector<std::int32_t> bucket(data.points.size() + 1);  // first the ends of the buckets, then their starts
  for (const HalfEdgeId h : data.half_edges()) ++bucket[static_cast<std::size_t>(ends_of(data, n, h).low)];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<std::uint64_t> keys(3 * data.triangle_faces.size());  // higher vertex, half-edge
  for (const HalfEdgeId h : data.half_edges()) {
    const auto [low, high] = ends_of(data, n, h);
    const auto place = static_cast<std::size_t>(--bucket[static_cast<std::size_t>(low)]);
    keys[place] = static_cast<std::uint64_t>(high) << 32 | index(h);
  }
  EdgeUses uses;
  uses.half_edges.reserve(keys.size());
  uses.starts.reserve(keys.size() / 2 + 1);
  uses.first_edge.resize(bucket.size());
  for (std::size_t v = 0; v < bucket.size(); ++v) {
    uses.first_edge[v] = static_cast<std::int32_t>(uses.starts.size());
    if (v + 1 == bucket.size()) break;
    const auto first = static_cast<std::size_t>(bucket[v]), last = static_cast<std::size_t>(bucket[v + 1]);
    sort_bucket(keys.data() + first, keys.data() + last);
    for (std::size_t k = first; k < last; ++k) {
      if (k == first || keys[k] >> 32 != keys[k - 1] >> 32) uses.starts.push_back(static_cast<std::int32_t>(k));
      uses.half_edges.push_back(static_cast<HalfEdgeId>(keys[k] & 0xffffffffU));
    }
  }
  uses.starts.push_back(static_cast<std::int32_t>(keys.size()));
  return uses;
}

std::span<const HalfEdgeId> EdgeUses::between(const MeshData& data, PointId a, PointId b) const {
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  const PointId low = std::min(a, b), high = std::max(a, b);
  std::int32_t first = first_edge[static_cast<std::size_t>(low)];
  const std::int32_t last = first_edge[static_cast<std::size_t>(low) + 1];
  const auto high_of = [&](std::int32_t e) {
    return ends_of(data, n, half_edges[static_cast<std::size_t>(starts[static_cast<std::size_t>(e)])]).high;
  };
  for (std::int32_t width = last - first; width > 0;) {
    const std::int32_t half = width / 2;
    if (high_of(first + half) < high) {
      first += half + 1;
      width -= half + 1;
    } else {
      width = half;
    }
  }
  return first < last && high_of(first) == high ? of(static_cast<std::size_t>(first)) : std::span<const HalfEdgeId>{};
}

}  // namespace pliant
