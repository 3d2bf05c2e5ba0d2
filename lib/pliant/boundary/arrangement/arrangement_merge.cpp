// lib/pliant/boundary/arrangement/arrangement_merge.cpp: merges arcs, then chains of edges, whose samples are near.
#include "pliant/boundary/arrangement/arrangement_merge.h"

#include <algorithm>
#include <array>
#include <map>

#include "pliant/boundary/curve_points.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

double polygon_length(std::span<const Point> polygon) {
  double sum = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) sum += distance(polygon[i - 1], polygon[i]);
  return sum;
}

class ArcMerger {
 public:
  ArcMerger(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArcTolerances& tolerances,
            ArrangementGraph& graph)
      : network_(network), curves_(curves), tolerances_(tolerances), graph_(graph) {}

  /// Joins arcs with the same ends that run together.
  void merge_arcs() {
    const std::vector<Arc>& arcs = network_.arcs;
    graph_.edge_of.assign(arcs.size(), -1);
    std::vector<int> order;
    for (std::size_t i = 0; i < arcs.size(); ++i)
      if (arcs[i].from != arcs[i].to) order.push_back(static_cast<int>(i));
    const auto ends = [&](int i) {
      const Arc& a = arcs[index(i)];
      return std::array{std::min(a.from, a.to), std::max(a.from, a.to)};
    };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return ends(i) != ends(j) ? ends(i) < ends(j) : i < j; });
    std::vector<int> kept(arcs.size(), -1);
    for (std::size_t first = 0, last; first < order.size(); first = last) {
      for (last = first; last < order.size() && ends(order[last]) == ends(order[first]);) ++last;
      std::vector<int> apart;
      for (std::size_t k = first; k < last; ++k) {
        const auto same =
            std::find_if(apart.begin(), apart.end(), [&](int other) { return run_together(other, order[k]); });
        kept[index(order[k])] = same == apart.end() ? order[k] : *same;
        if (same == apart.end()) apart.push_back(order[k]);
      }
    }
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (kept[i] < 0) continue;
      const bool is_new = kept[i] == static_cast<int>(i);
      if (is_new) {
        graph_.edge_of[i] = static_cast<int>(graph_.edges.size());
        graph_.edges.push_back({static_cast<int>(i), {}});
      }
      GraphEdge& edge = graph_.edges[index(graph_.edge_of[index(kept[i])])];
      const SidedCurve& curve = curves_[index(arcs[i].curve)];
      add_winding(edge.jump, curve.jump, arcs[i].from == arcs[index(edge.arc)].from ? 1 : -1);
      add_line(edge, curve.line);
    }
    drop_empty();
  }

  /// Joins chains of edges that run beside each other, between nodes that do not have exactly two edges.
  void merge_paths() {
    std::vector<std::array<int, 2>> ends(network_.nodes.size(), {-1, -1});  // the half-edges that leave a node with two
    std::vector<int> degree(network_.nodes.size(), 0);
    const int halves = 2 * static_cast<int>(graph_.edges.size());
    for (int half = 0; half < halves; ++half) {
      int& d = degree[index(origin(half))];
      if (d < 2) ends[index(origin(half))][index(d)] = half;
      ++d;
    }
    std::map<std::array<int, 2>, std::vector<Path>> between;
    for (int start = 0; start < halves; ++start) {
      if (degree[index(origin(start))] == 2) continue;
      Path path{start};
      while (degree[index(origin(twin(path.back())))] == 2) {
        const auto& both = ends[index(origin(twin(path.back())))];
        path.push_back(both[0] == twin(path.back()) ? both[1] : both[0]);
      }
      const int from = origin(start), to = origin(twin(path.back()));
      if (from < to) between[{from, to}].push_back(std::move(path));
    }
    for (auto& [nodes, paths] : between)
      for (std::size_t j = 1; j < paths.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
          if (!paths[i].empty() && !paths[j].empty() && merge(paths[i], paths[j])) break;
    drop_empty();
  }

 private:
  /// The half-edges of a chain.
  using Path = std::vector<int>;

  // Half-edge 2e runs along edge e, 2e + 1 against it.
  const Arc& arc(int half) const { return network_.arcs[index(graph_.edges[index(half / 2)].arc)]; }
  int origin(int half) const { return half % 2 == 0 ? arc(half).from : arc(half).to; }
  static int twin(int half) { return half ^ 1; }

  static void add_line(GraphEdge& edge, int line) {
    if (line >= 0 && std::find(edge.lines.begin(), edge.lines.end(), line) == edge.lines.end())
      edge.lines.push_back(line);
  }

  /// Drops the edges that are no lines and have no jump: both sides have the same winding numbers, so these edges
  /// separate nothing.
  void drop_empty() {
    std::vector<GraphEdge> edges;
    for (GraphEdge& edge : graph_.edges) {
      const bool is_empty = edge.jump.empty() && edge.lines.empty();
      graph_.edge_of[index(edge.arc)] = is_empty ? -1 : static_cast<int>(edges.size());
      if (!is_empty) edges.push_back(std::move(edge));
    }
    graph_.edges = std::move(edges);
  }

  /// Whether two arcs with the same ends are nowhere farther apart than a sliver.
  bool run_together(int first, int second) {
    const auto a = network_.polygon(network_.arcs[index(first)]), b = network_.polygon(network_.arcs[index(second)]);
    const int samples = static_cast<int>(a.size() + b.size()) + 1;
    double most = 0;
    for (int i = 0; i < samples; ++i) {
      const double s = (i + 0.5) / samples;
      most = std::max(
          {most, nearest_on_curve(b, bezier_point(a, s)).distance, nearest_on_curve(a, bezier_point(b, s)).distance});
      if (most > tolerances_.sliver) return false;
    }
    // Arcs that are no farther apart than this may have been moved apart by the snap of their ends.
    if (most > 8 * tolerances_.touch) count_sliver(most * polygon_length(a));
    return true;
  }

  void count_sliver(double area) {
    ++graph_.slivers;
    graph_.sliver_area += area;
  }

  std::vector<int> lines_of(const Path& path) const {
    GraphEdge all{};
    for (const int half : path)
      for (const int line : graph_.edges[index(half / 2)].lines) add_line(all, line);
    return std::move(all.lines);
  }

  /// Merges a chain into another that it runs beside; false if it does not.
  bool merge(const Path& kept, Path& other) {
    if (kept.size() + other.size() <= 2 || !runs_beside(kept, other) || !runs_beside(other, kept)) return false;
    const Winding jump = graph_.edges[index(other[0] / 2)].jump;
    const int sign = other[0] % 2 == 0 ? 1 : -1;
    const std::vector<int> lines = lines_of(other);
    for (const int half : kept) {
      GraphEdge& edge = graph_.edges[index(half / 2)];
      add_winding(edge.jump, jump, half % 2 == 0 ? sign : -sign);
      for (const int line : lines) add_line(edge, line);
    }
    for (const int half : other) {
      graph_.edges[index(half / 2)].jump.clear();
      graph_.edges[index(half / 2)].lines.clear();
    }
    double length = 0;
    for (const int half : other) length += polygon_length(network_.polygon(arc(half)));
    count_sliver(length * tolerances_.sliver);
    other.clear();
    return true;
  }

  /// Whether every sample of a chain is no farther from the other chain than a sliver.
  bool runs_beside(const Path& path, const Path& other) const {
    std::vector<Box> boxes(other.size());
    for (std::size_t i = 0; i < other.size(); ++i) {
      for (const Point& p : network_.polygon(arc(other[i]))) boxes[i].extend(p);
      boxes[i].low -= Vector{tolerances_.sliver, tolerances_.sliver};
      boxes[i].high += Vector{tolerances_.sliver, tolerances_.sliver};
    }
    for (const int half : path) {
      const auto polygon = network_.polygon(arc(half));
      const int samples = 2 * static_cast<int>(polygon.size()) + 1;
      for (int s = 0; s < samples; ++s) {
        const Point p = bezier_point(polygon, (s + 0.5) / samples);
        bool near = false;
        for (std::size_t i = 0; i < other.size() && !near; ++i)
          near = boxes[i].contains(p) &&
                 nearest_on_curve(network_.polygon(arc(other[i])), p).distance <= tolerances_.sliver;
        if (!near) return false;
      }
    }
    return true;
  }

  const ArcNetwork& network_;
  std::span<const SidedCurve> curves_;
  const ArcTolerances& tolerances_;
  ArrangementGraph& graph_;
};

}  // namespace

void merge_arcs(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArcTolerances& tolerances,
                ArrangementGraph& graph) {
  ArcMerger merger(network, curves, tolerances, graph);
  merger.merge_arcs();
  merger.merge_paths();
}

}  // namespace pliant
