// lib/pliant/improve/coarsening/independent_set.cpp: which vertices coarsening keeps (Talmor; Miller et al.; §5.3.3).
#include "pliant/improve/coarsening/independent_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double rim = 1.6;           // the next vertices are looked for within so many radii of a chosen one
constexpr double along_curve = 0.97;  // length of the edges that are chosen on curves, in wanted lengths, at factor 1
constexpr double margin = 1e-9;       // relative: what squares tell, roots and quotients tell too
constexpr double in_plane = 0.8;      // least distance of two chosen inner vertices, in wanted lengths, at factor 1

/// All numbers of vertices are those of the graph.
class Chooser {
 public:
  Chooser(const VertexGraph& graph, const std::vector<VertexRole>& roles, const std::vector<double>& spacing,
          double factor)
      : graph_(graph), factor_(factor), visited_(index(graph.count()), none) {
    nodes_.reserve(index(graph.count()));
    std::size_t most = 0;
    for (int k = 0; k < graph.count(); ++k) {
      Node node;
      node.place = graph.place(k);
      node.spacing = spacing[index(k)];
      node.role = roles[index(graph.vertex(k))];
      nodes_.push_back(node);
      most = std::max(most, graph.around(k).size());
    }
    near_.resize(most + 1);
  }

  std::vector<bool> run(const std::vector<CurveChain>& chains, const std::vector<PointId>& preferred, int slots) {
    for (const CurveChain& chain : chains) choose_along(chain);
    for (int k = 0; k < graph_.count(); ++k)
      if (nodes_[index(k)].role == VertexRole::kept || nodes_[index(k)].is_chosen) choose(k);
    for (const PointId v : preferred)
      if (const int k = graph_.number(v); k != none && is_candidate(k)) choose(k);
    advance();
    for (int k = 0; k < graph_.count(); ++k) {  // vertices that no front has reached
      if (!is_candidate(k)) continue;
      choose(k);
      advance();
    }
    std::vector<bool> chosen(index(slots), false);
    for (int k = 0; k < graph_.count(); ++k) chosen[index(graph_.vertex(k))] = nodes_[index(k)].is_chosen;
    return chosen;
  }

 private:
  /// What the choice reads and notes of a vertex, together in memory since the choice goes through the mesh in no
  /// order.
  struct Node {
    Point place;
    double spacing = 0;
    float queued = std::numeric_limits<float>::infinity();  ///< no more than the least ratio at which it is queued
    VertexRole role = VertexRole::inner;
    bool is_chosen = false, is_shut_out = false;
  };

  bool is_candidate(int k) const {
    const Node& node = nodes_[index(k)];
    return node.role == VertexRole::inner && !node.is_chosen && !node.is_shut_out;
  }
  Node& node_of(PointId v) { return nodes_[index(graph_.number(v))]; }

  /// Chooses vertices along a curve, in even steps of wanted lengths between the vertices that are kept.
  void choose_along(const CurveChain& chain) {
    const auto count = chain.vertices.size();
    if (count < 3) return;
    std::size_t first = 0;
    while (first < count && node_of(chain.vertices[first]).role != VertexRole::kept) ++first;
    if (first == count) first = 0;
    node_of(chain.vertices[first]).is_chosen = true;
    const std::size_t last = chain.closed ? first + count : count - 1;
    std::size_t from = first;
    std::vector<double> run{0};  // from `from`, in wanted lengths
    for (std::size_t k = first + 1; k <= last; ++k) {
      const Node &v = node_of(chain.vertices[k % count]), &u = node_of(chain.vertices[(k - 1) % count]);
      run.push_back(run.back() + 2 * quick_distance(u.place, v.place) / (u.spacing + v.spacing));
      if (v.role != VertexRole::kept && k != last) continue;
      const double all = run.back();
      const int least = chain.closed && from == first && k == last ? 3 : 1;
      const int steps = std::max(least, static_cast<int>(std::lround(all / (along_curve * factor_))));
      for (int s = 1; s < steps; ++s) {
        const double place = all * s / steps;
        auto near = static_cast<std::size_t>(std::lower_bound(run.begin(), run.end(), place) - run.begin());
        if (near > 0 && place - run[near - 1] < run[near] - place) --near;
        node_of(chain.vertices[(from + near) % count]).is_chosen = true;
      }
      from = k;
      run.assign(1, 0);
    }
  }

  /// Chooses a vertex and shuts out the inner vertices in its sphere. Those a little further out are queued to be
  /// chosen next.
  void choose(int chosen) {
    Node& center = nodes_[index(chosen)];
    center.is_chosen = true;
    visited_[index(chosen)] = chosen;
    front_.assign(1, chosen);
    for (std::size_t k = 0; k < front_.size(); ++k) {
      const std::size_t found = find_unvisited(front_[k], chosen);
      for (std::size_t i = 0; i < found; ++i) {
        const int near = near_[i];
        Node& node = nodes_[index(near)];
        const double reach = in_plane * factor_ * (center.spacing + node.spacing) / 2;
        // Where the squares tell on which side of a bound the ratio is, no root is taken.
        const double squared = squared_length(node.place - center.place), unit = reach * reach;
        const bool is_telling = squared > 1e-280 && unit > 1e-280 && squared < 1e280;
        if (is_telling && squared > rim * rim * (1 + margin) * unit) continue;
        if (is_telling && squared < (1 - margin) * unit) {
          front_.push_back(near);
          node.is_shut_out = true;
          continue;
        }
        const double ratio = quick_distance(center.place, node.place) / reach;
        if (!(ratio < rim)) continue;
        front_.push_back(near);
        if (ratio < 1)
          node.is_shut_out = true;
        else if (is_candidate(near))
          enqueue(near, ratio);
      }
    }
  }

  /// Collects in near_ the neighbours of k that were not visited for this chosen vertex yet, without a branch for each:
  /// which of them were is anyone's guess. Returns how many there are.
  std::size_t find_unvisited(int k, int chosen) {
    std::size_t found = 0;
    for (const int near : graph_.around(k)) {
      int& visited = visited_[index(near)];
      near_[found] = near;
      found += visited != chosen ? 1 : 0;
      visited = chosen;
    }
    return found;
  }

  /// Queues a candidate, unless it is queued already at a ratio that surely is no greater: then that one decides.
  void enqueue(int k, double ratio) {
    Node& node = nodes_[index(k)];
    const auto rounded = static_cast<float>(ratio);
    if (node.queued < rounded) return;
    node.queued = rounded;
    queue_.push(ratio, k);
  }

  void advance() {
    while (const std::optional<int> k = queue_.pop())
      if (is_candidate(*k)) choose(*k);
  }

  /// A priority queue of vertices by ratios between 1 and `rim`, and then by numbers, in heaps for narrow ranges of
  /// ratios: these stay small.
  class Queue {
   public:
    void push(double ratio, int k) {
      const auto range = static_cast<std::size_t>(std::clamp((ratio - 1) * per_unit, 0.0, ranges - 1.0));
      heaps_[range].emplace_back(ratio, k);
      std::push_heap(heaps_[range].begin(), heaps_[range].end(), std::greater<>());
      first_ = std::min(first_, range);
    }
    std::optional<int> pop() {
      while (first_ < ranges && heaps_[first_].empty()) ++first_;
      if (first_ == ranges) return std::nullopt;
      std::vector<Item>& heap = heaps_[first_];
      const int k = heap.front().second;
      std::pop_heap(heap.begin(), heap.end(), std::greater<>());
      heap.pop_back();
      return k;
    }

   private:
    using Item = std::pair<double, int>;
    static constexpr std::size_t ranges = 512;
    static constexpr double per_unit = ranges / (rim - 1);
    std::array<std::vector<Item>, ranges> heaps_;
    std::size_t first_ = ranges;
  };

  const VertexGraph& graph_;
  double factor_;
  std::vector<Node> nodes_;
  std::vector<int> visited_;  // the last chosen vertex for which it was visited
  std::vector<int> front_, near_;
  Queue queue_;
};

}  // namespace

std::vector<bool> independent_set(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                  const std::vector<VertexRole>& roles, const std::vector<double>& spacing,
                                  const std::vector<PointId>& preferred, double factor) {
  return Chooser(graph, roles, spacing, factor).run(chains, preferred, mesh.point_slots());
}

}  // namespace pliant
