// lib/pliant/improve/coarsening/vertex_graph.h: the neighbours of each vertex in one array, for passes that look at all
// of them.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Which vertices edges join, as the mesh was when the graph was made.
class VertexGraph {
 public:
  explicit VertexGraph(const Mesh& mesh) : starts_(static_cast<std::size_t>(mesh.point_slots()) + 1, 0) {
    const auto visit = [&mesh](const auto& edge) {
      for (const HalfEdgeId h : mesh.half_edges()) {
        if (!mesh.is_alive(triangle_of(h))) continue;
        edge(mesh.origin(h), mesh.target(h));
        if (mesh.twin(h) == none) edge(mesh.target(h), mesh.origin(h));
      }
    };
    visit([this](PointId v, PointId) { ++starts_[static_cast<std::size_t>(v) + 1]; });
    for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    neighbors_.resize(static_cast<std::size_t>(starts_.back()));
    std::vector<std::int32_t> next(starts_.begin(), starts_.end() - 1);
    visit([&](PointId v, PointId w) { neighbors_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = w; });
  }

  std::span<const PointId> around(PointId v) const {
    const auto first = static_cast<std::size_t>(starts_[static_cast<std::size_t>(v)]);
    const auto last = static_cast<std::size_t>(starts_[static_cast<std::size_t>(v) + 1]);
    return {neighbors_.data() + first, last - first};
  }

 private:
  std::vector<std::int32_t> starts_;
  std::vector<PointId> neighbors_;
};

/// The distance of two points. It takes a fraction of the time of std::hypot: a square root where nothing overflows or
/// underflows.
inline double quick_distance(const Point& a, const Point& b) {
  const double squared = squared_length(b - a);
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : distance(a, b);
}

}  // namespace pliant
