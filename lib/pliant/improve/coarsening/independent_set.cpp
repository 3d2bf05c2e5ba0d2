// lib/pliant/improve/coarsening/independent_set.cpp: which vertices coarsening keeps (Talmor; Miller et al.; §5.3.3).
#include "pliant/improve/coarsening/independent_set.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double rim = 1.6;           // the next vertices are looked for within so many radii of a chosen one
constexpr double along_curve = 0.97;  // length of the edges that are chosen on curves, in wanted lengths, at factor 1
constexpr double in_plane = 0.8;      // least distance of two chosen inner vertices, in wanted lengths, at factor 1

class Chooser {
 public:
  Chooser(const Mesh& mesh, const VertexGraph& graph, const std::vector<VertexRole>& roles,
          const std::vector<double>& spacing, double factor)
      : mesh_(mesh),
        graph_(graph),
        roles_(roles),
        spacing_(spacing),
        factor_(factor),
        chosen_(roles.size(), false),
        shut_out_(roles.size(), false),
        visited_(roles.size(), none) {}

  std::vector<bool> run(const std::vector<CurveChain>& chains, const std::vector<PointId>& preferred) {
    for (const CurveChain& chain : chains) choose_along(chain);
    for (PointId v = 0; v < mesh_.point_slots(); ++v)
      if (mesh_.is_vertex(v) && (roles_[index(v)] == VertexRole::kept || chosen_[index(v)])) choose(v);
    for (const PointId v : preferred)
      if (is_candidate(v)) choose(v);
    advance();
    for (PointId v = 0; v < mesh_.point_slots(); ++v) {  // vertices that no front has reached
      if (!is_candidate(v)) continue;
      choose(v);
      advance();
    }
    return std::move(chosen_);
  }

 private:
  bool is_candidate(PointId v) const {
    return mesh_.is_vertex(v) && roles_[index(v)] == VertexRole::inner && !chosen_[index(v)] && !shut_out_[index(v)];
  }
  double far(PointId v, PointId w) const { return quick_distance(mesh_.point(v), mesh_.point(w)); }

  /// Chooses vertices along a curve, in even steps of wanted lengths between the vertices that are kept.
  void choose_along(const CurveChain& chain) {
    const auto count = chain.vertices.size();
    if (count < 3) return;
    std::size_t first = 0;
    while (first < count && roles_[index(chain.vertices[first])] != VertexRole::kept) ++first;
    if (first == count) first = 0;
    chosen_[index(chain.vertices[first])] = true;
    const std::size_t last = chain.closed ? first + count : count - 1;
    std::size_t from = first;
    std::vector<double> run{0};  // from `from`, in wanted lengths
    for (std::size_t k = first + 1; k <= last; ++k) {
      const PointId v = chain.vertices[k % count], u = chain.vertices[(k - 1) % count];
      run.push_back(run.back() + 2 * far(u, v) / (spacing_[index(u)] + spacing_[index(v)]));
      if (roles_[index(v)] != VertexRole::kept && k != last) continue;
      const double all = run.back();
      const int least = chain.closed && from == first && k == last ? 3 : 1;
      const int steps = std::max(least, static_cast<int>(std::lround(all / (along_curve * factor_))));
      for (int s = 1; s < steps; ++s) {
        const double place = all * s / steps;
        auto near = static_cast<std::size_t>(std::lower_bound(run.begin(), run.end(), place) - run.begin());
        if (near > 0 && place - run[near - 1] < run[near] - place) --near;
        chosen_[index(chain.vertices[(from + near) % count])] = true;
      }
      from = k;
      run.assign(1, 0);
    }
  }

  /// Chooses v and shuts out the inner vertices in its sphere. Those a little further out are queued to be chosen next.
  void choose(PointId v) {
    chosen_[index(v)] = true;
    front_.assign(1, v);
    visited_[index(v)] = v;
    for (std::size_t k = 0; k < front_.size(); ++k) {
      for (const PointId w : graph_.around(front_[k])) {
        if (visited_[index(w)] == v) continue;
        visited_[index(w)] = v;
        const double ratio = far(v, w) / (in_plane * factor_ * (spacing_[index(v)] + spacing_[index(w)]) / 2);
        if (!(ratio < rim)) continue;
        front_.push_back(w);
        if (ratio < 1)
          shut_out_[index(w)] = true;
        else if (is_candidate(w))
          queue_.push({ratio, w});
      }
    }
  }

  void advance() {
    while (!queue_.empty()) {
      const PointId v = queue_.top().second;
      queue_.pop();
      if (is_candidate(v)) choose(v);
    }
  }

  using Item = std::pair<double, PointId>;
  const Mesh& mesh_;
  const VertexGraph& graph_;
  const std::vector<VertexRole>& roles_;
  const std::vector<double>& spacing_;
  double factor_;
  std::vector<bool> chosen_, shut_out_;
  std::vector<PointId> visited_, front_;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue_;
};

}  // namespace

std::vector<bool> independent_set(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                  const std::vector<VertexRole>& roles, const std::vector<double>& spacing,
                                  const std::vector<PointId>& preferred, double factor) {
  return Chooser(mesh, graph, roles, spacing, factor).run(chains, preferred);
}

}  // namespace pliant
