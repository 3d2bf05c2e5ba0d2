// lib/pliant/boundary/arrangement/arrangement_curves.cpp: kept arcs become B-splines again.
#include "pliant/boundary/arrangement/arrangement_curves.h"

#include <algorithm>
#include <cmath>

#include "pliant/boundary/arrangement/arrangement_input.h"
#include "pliant/boundary/curve_points.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double most_hook = 8;          // in tolerances: the longest end that is cut off because it turns back
constexpr double sharpest_joint = 0.01;  // radians between two arcs at a node; a sharper joint needs a vertex

/// Knots and control points of a stretch of a B-spline, not clamped.
struct OpenStretch {
  int degree;
  std::vector<double> knots;
  std::vector<Point> points;

  int last_at_most(double t) const {
    return static_cast<int>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin()) - 1;
  }
  int copies(double t) const {
    const auto [low, high] = std::equal_range(knots.begin(), knots.end(), t);
    return static_cast<int>(high - low);
  }
  /// Inserts t up to multiplicity `degree`.
  void break_at(double t) {
    for (int s = copies(t); s < degree; ++s) {
      const int k = last_at_most(t);
      std::vector<Point> changed;
      for (int i = k - degree + 1; i <= k - s; ++i) {
        const double alpha = (t - knots[index(i)]) / (knots[index(i + degree)] - knots[index(i)]);
        changed.push_back((1 - alpha) * points[index(i - 1)] + alpha * points[index(i)]);
      }
      const auto first = points.begin() + (k - degree + 1);
      const auto after = std::copy(changed.begin(), changed.end() - 1, first);
      points.insert(after, changed.back());
      knots.insert(knots.begin() + k + 1, t);
    }
  }
};

/// Chains the kept arcs of each curve.
class Chains {
 public:
  Chains(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArrangementGraph& graph,
         const ArcTolerances& tolerances)
      : network_(network),
        curves_(curves),
        graph_(graph),
        tip_(std::ldexp(tolerances.tip, network.exponent)),
        most_hook_(most_hook * std::ldexp(tolerances.touch, network.exponent)),
        degree_(network.nodes.size(), 0) {
    for (const GraphEdge& edge : graph.edges) {
      if (!edge.is_kept()) continue;
      ++degree_[index(network.arcs[index(edge.arc)].from)];
      ++degree_[index(network.arcs[index(edge.arc)].to)];
    }
  }

  std::vector<KeptCurve> all() {
    std::vector<KeptCurve> result;
    const std::size_t arcs = network_.arcs.size();
    for (std::size_t first = 0, last; first < arcs; first = last) {
      for (last = first; last < arcs && network_.arcs[last].curve == network_.arcs[first].curve;) ++last;
      append_of_curve(static_cast<int>(first), static_cast<int>(last), result);
    }
    return result;
  }

 private:
  const Arc& arc(int i) const { return network_.arcs[index(i)]; }
  /// The edge of arc i if the arc is kept, otherwise null.
  const GraphEdge* kept(int i) const {
    const int e = graph_.edge_of[index(i)];
    if (e < 0 || !graph_.edges[index(e)].is_kept()) return nullptr;
    return &graph_.edges[index(e)];
  }

  bool goes_on(int i, int j) const {
    const GraphEdge *a = kept(i), *b = kept(j);
    return a && b && arc(i).to == arc(j).from && degree_[index(arc(i).to)] == 2 && a->left == b->left &&
           a->right == b->right && !turns_back(arc(i), arc(j));
  }

  bool turns_back(const Arc& a, const Arc& b) const {
    const auto p = network_.polygon(a), q = network_.polygon(b);
    const double near = 1e-3;  // a parameter beyond which neither a vanishing derivative nor the snap matters
    const Vector back = bezier_point(p, 1 - near) - p.back(), on = bezier_point(q, near) - q.front();
    return dot(back, on) > 0 && std::fabs(cross(back, on)) < sharpest_joint * dot(back, on);
  }

  /// The arcs first .. last - 1 are those of one curve.
  void append_of_curve(int first, int last, std::vector<KeptCurve>& result) const {
    const bool closed = curves_[index(arc(first).curve)].spline->closed();
    const int count = last - first;
    const auto at = [&](int i) { return first + (i - first) % count; };
    const auto joined = [&](int i) { return (closed || i + 1 < last) && goes_on(at(i), at(i + 1)); };
    int begin = first;  // a closed curve is walked from an arc that is not joined to the one before it
    if (closed) {
      while (begin < last && joined(begin)) ++begin;
      if (begin == last) return result.push_back(whole(first));
      ++begin;
    }
    for (int i = begin; i < begin + count;) {
      int end = i;
      while (end + 1 < begin + count && joined(end)) ++end;
      if (kept(at(i))) result.push_back(stretch(i, end, first, count));
      i = end + 1;
    }
  }

  KeptCurve whole(int i) const {
    return {arc(i).curve, *curves_[index(arc(i).curve)].spline, no_vertex, no_vertex, kept(i)->left, kept(i)->right};
  }

  KeptCurve stretch(int i, int end, int first, int count) const {
    const Arc& a = arc(first + (i - first) % count);
    const Arc& b = arc(first + (end - first) % count);
    const GraphEdge* edge = kept(first + (i - first) % count);
    const BSpline& spline = *curves_[index(a.curve)].spline;
    const bool over_seam = (i - first) / count != (end - first) / count;
    const double t0 = a.t0;
    double t1 = b.t1;
    if (over_seam) t1 = spline.last_parameter() + (t1 - spline.first_parameter());
    const bool is_whole = !spline.closed() && t0 == spline.first_parameter() && t1 == spline.last_parameter();
    KeptCurve result{a.curve, is_whole ? spline : part_of_curve(spline, t0, t1), a.from, b.to, edge->left, edge->right};
    const Point from = unscaled(a.from), to = unscaled(b.to);
    if (from == result.spline.points().front() && to == result.spline.points().back()) return result;
    set_ends(result.spline, from, to);
    cut_hooks(result.spline, from, to);
    return result;
  }

  static void set_ends(BSpline& spline, const Point& from, const Point& to) {
    spline.set_point(0, from);
    spline.set_point(static_cast<int>(spline.points().size()) - 1, to);
  }

  /// Cuts off what turns back at the ends, where the snap has moved an end to behind the points next to it.
  void cut_hooks(BSpline& spline, const Point& from, const Point& to) const {
    std::vector<BSpline> parts = split_at_stops(spline, tip_);
    const auto is_short = [&](const BSpline& part) {
      Box box;
      for (const Point& p : part.points()) box.extend(p);
      return box.size() <= most_hook_;
    };
    while (parts.size() > 1 && is_short(parts.back())) parts.pop_back();
    while (parts.size() > 1 && is_short(parts.front())) parts.erase(parts.begin());
    if (parts.size() != 1) return;  // the curve turns back elsewhere, too, and stays as it is
    spline = std::move(parts.front());
    set_ends(spline, from, to);
  }

  Point unscaled(int node) const {
    const Point& p = network_.nodes[index(node)];
    return {std::ldexp(p.x, network_.exponent), std::ldexp(p.y, network_.exponent)};
  }

  const ArcNetwork& network_;
  std::span<const SidedCurve> curves_;
  const ArrangementGraph& graph_;
  double tip_, most_hook_;
  std::vector<int> degree_;  // how many kept edges end at each node
};

}  // namespace

std::vector<KeptCurve> chain_arcs(const ArcNetwork& network, std::span<const SidedCurve> curves,
                                  const ArrangementGraph& graph, const ArcTolerances& tolerances) {
  return Chains(network, curves, graph, tolerances).all();
}

BSpline part_of_curve(const BSpline& spline, double t0, double t1) {
  const int p = spline.degree(), m = static_cast<int>(spline.points().size());
  const auto& stored = spline.knots();
  int from = static_cast<int>(std::upper_bound(stored.begin(), stored.end(), t0) - stored.begin()) - 1;
  if (spline.closed()) from = std::min(from, m - 1);
  int to = from + 1;
  while (spline.knot(to) < t1) ++to;
  OpenStretch stretch{p, {}, {}};
  for (int i = from - p; i <= to + p; ++i) stretch.knots.push_back(spline.knot(i));
  for (int i = from - p; i < to; ++i) stretch.points.push_back(spline.points()[index((i % m + m) % m)]);
  stretch.break_at(t0);
  stretch.break_at(t1);
  const int a = stretch.last_at_most(t0);  // the last copy of t0, and the first of t1
  const int b =
      static_cast<int>(std::lower_bound(stretch.knots.begin(), stretch.knots.end(), t1) - stretch.knots.begin());
  std::vector<double> knots{t0};
  knots.insert(knots.end(), stretch.knots.begin() + (a - p + 1), stretch.knots.begin() + (b + p));
  knots.push_back(t1);
  return BSpline(p, false, std::move(knots), {stretch.points.begin() + (a - p), stretch.points.begin() + b});
}

}  // namespace pliant
