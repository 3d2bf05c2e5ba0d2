// lib/pliant/improve/coarsening/vertex_graph.h: the neighbours of each vertex in one array, for passes that look at all
// of them.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Which vertices edges join, as the mesh was when the graph was made. It numbers the vertices anew, in their order and
/// without the other control points in between, so that arrays over them are dense.
class VertexGraph {
 public:
  explicit VertexGraph(const Mesh& mesh) : numbers_(index(mesh.point_slots()), none) {
    for (PointId v = 0; v < mesh.point_slots(); ++v) {
      if (!mesh.is_vertex(v)) continue;
      numbers_[index(v)] = count();
      vertices_.push_back(v);
      places_.push_back(mesh.point(v));
    }
    const auto visit = [&](const auto& edge) {
      for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
        if (!mesh.is_alive(t)) continue;
        const int corners[3] = {number(mesh.corner(t, 0)), number(mesh.corner(t, 1)), number(mesh.corner(t, 2))};
        for (int e = 0; e < 3; ++e) {
          edge(corners[e], corners[(e + 1) % 3]);
          if (mesh.twin(half_edge(t, e)) == none) edge(corners[(e + 1) % 3], corners[e]);
        }
      }
    };
    starts_.assign(vertices_.size() + 1, 0);
    visit([this](int k, int) { ++starts_[index(k) + 1]; });
    for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    neighbors_.resize(index(starts_.back()));
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    visit([&](int k, int neighbor) { neighbors_[index(next[index(k)]++)] = neighbor; });
  }

  int count() const { return static_cast<int>(vertices_.size()); }
  PointId vertex(int k) const { return vertices_[index(k)]; }
  const Point& place(int k) const { return places_[index(k)]; }
  int number(PointId v) const { return numbers_[index(v)]; }  ///< none for points that are no vertices
  std::span<const int> around(int k) const {
    const std::size_t first = index(starts_[index(k)]);
    return {neighbors_.data() + first, index(starts_[index(k) + 1]) - first};
  }

 private:
  std::vector<PointId> vertices_;
  std::vector<Point> places_;
  std::vector<int> numbers_, starts_, neighbors_;
};

/// The distance of two points. It takes a fraction of the time of std::hypot: a square root where nothing overflows or
/// underflows.
inline double quick_distance(const Point& a, const Point& b) {
  const double squared = squared_length(b - a);
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : distance(a, b);
}

}  // namespace pliant
