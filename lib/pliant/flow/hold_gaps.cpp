// lib/pliant/flow/hold_gaps.cpp: places that come too near along the line between them, and the points that move them.
#include "pliant/flow/hold_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/gap_pieces.h"

namespace pliant {
namespace {

constexpr int most_rounds = 20;        // so often the displacements are corrected
constexpr double close_enough = 0.01;  // an approach is too much if it is by more than this part of the least gap
constexpr double opening = 0.1;        // a gap that is too thin opens by this part of the least gap in a step
constexpr int coarse_places = 8;       // per span, where the search for the nearest place begins
constexpr int most_rings = 40;         // elements farther from a held boundary keep their motion

struct Span {
  int curve;
  double from, to;  // parameters on the curve
  GapPiece piece;
  int first_place = 0;  // of the places on it
  Box box, motion;      // of its control points, and of their displacements
};

Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box.extend(p);
  return box;
}
Box grown(Box box, double by) {
  box.low -= {by, by};
  box.high += {by, by};
  return box;
}
/// The distance between two boxes.
double distance_between(const Box& a, const Box& b) {
  const Vector apart{std::max({0.0, a.low.x - b.high.x, b.low.x - a.high.x}),
                     std::max({0.0, a.low.y - b.high.y, b.low.y - a.high.y})};
  return std::sqrt(squared_length(apart));
}
/// The greatest length of a difference of two vectors from these boxes.
double greatest_difference(const Box& a, const Box& b) {
  const Vector most{std::max(a.high.x - b.low.x, b.high.x - a.low.x), std::max(a.high.y - b.low.y, b.high.y - a.low.y)};
  return std::sqrt(squared_length(most));
}

/// A place on a curve, and the nearest one on curves that it may not meet.
struct Place {
  int curve;
  double t, u;  // parameters on the curve and on its span
  Point at;     // known once a span is near
  double gap = HUGE_VAL;
  int other = -1;  // the curve, the parameter and the point over there
  double other_t = 0;
  Point foot;
};
/// A place that approaches the one across the gap.
struct Held {
  Place place;
  Vector normal;  // towards the other place
  double share;   // of the approach that is the place's own
};

class GapHolder {
 public:
  GapHolder(const BoundaryComplex& boundary, BoundaryDisplacements& displacements, double least)
      : boundary_(boundary), displacements_(displacements), least_(least) {}

  int run() {
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      vectors_.push_back(boundary_.curves[c].spline);
      if (!vectors_.back().interpolate(displacements_.at_greville[c])) return 0;
    }
    collect_spans();
    find_nearest();
    if (std::ranges::none_of(places_, [](const Place& p) { return p.other >= 0; })) return 0;
    for (const Curve& each : boundary_.curves) stations_.push_back(stations_of(each.spline));
    collect_held();
    int touched = 0;
    for (int round = 0; round < most_rounds; ++round) {
      const int corrected = correct();
      if (corrected == 0) break;
      touched = std::max(touched, corrected);
    }
    return touched;
  }

 private:
  const Curve& curve(int c) const { return boundary_.curves[static_cast<std::size_t>(c)]; }
  const BSpline& vectors(int c) const { return vectors_[static_cast<std::size_t>(c)]; }

  void collect_spans() {
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const BSpline& spline = boundary_.curves[c].spline;
      const std::vector<double> breaks = spline.breaks();
      std::vector<Point> polygon(static_cast<std::size_t>(spline.degree()) + 1);
      for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
        vectors_[c].extract(breaks[s], polygon);
        const Box motion = box_of(polygon);
        spline.extract(breaks[s], polygon);
        spans_.push_back({static_cast<int>(c), breaks[s], breaks[s + 1], whole_piece(polygon),
                          static_cast<int>(places_.size()), box_of(polygon), motion});
        const int count = places_on(spline);
        for (int k = 0; k < count; ++k) {
          const double u = static_cast<double>(k) / (count - 1);
          places_.push_back(
              {static_cast<int>(c), breaks[s] + u * (breaks[s + 1] - breaks[s]), u, {}, HUGE_VAL, -1, 0, {}});
        }
      }
    }
  }
  static int places_on(const BSpline& spline) { return 2 * spline.degree() + 3; }

  /// Two curves with a common end meet there.
  bool may_not_meet(int c, int d) const {
    if (c == d) return false;
    const Curve &a = curve(c), &b = curve(d);
    if (a.spline.closed() || b.spline.closed()) return true;
    return a.start != b.start && a.start != b.end && a.end != b.start && a.end != b.end;
  }

  void find_nearest() {
    std::vector<Box> swept;  // what the spans may pass, grown by half of the least gap
    for (const Span& span : spans_) {
      swept.push_back(span.box);
      swept.back().extend(span.box.low + span.motion.low);
      swept.back().extend(span.box.high + span.motion.high);
      swept.back() = grown(swept.back(), least_ / 2);
    }
    visit_overlapping_pairs(swept, [&](int i, int j) {
      const Span &a = spans_[static_cast<std::size_t>(i)], &b = spans_[static_cast<std::size_t>(j)];
      const double reach = least_ + greatest_difference(a.motion, b.motion);
      if (distance_between(a.box, b.box) > reach || !may_not_meet(a.curve, b.curve)) return true;
      approach_span(a, b, reach);
      approach_span(b, a, reach);
      return true;
    });
  }

  void approach_span(const Span& from, const Span& to, double reach) {
    const int count = places_on(curve(from.curve).spline);
    for (int k = 0; k < count; ++k) {
      Place& place = places_[static_cast<std::size_t>(from.first_place + k)];
      place.at = evaluate_piece(from.piece, place.u).place;
      if (distance_between(to.box, {place.at, place.at}) > std::min(reach, place.gap)) continue;
      double nearest = HUGE_VAL, v = 0;
      for (int n = 0; n <= coarse_places; ++n) {
        const double at = static_cast<double>(n) / coarse_places;
        const double apart = distance(place.at, evaluate_piece(to.piece, at).place);
        if (apart < nearest) nearest = apart, v = at;
      }
      GapPiece point;
      point.points[0] = place.at;
      const double polished = polish(point, to.piece, 0, v).second;
      if (distance(place.at, evaluate_piece(to.piece, polished).place) < nearest) v = polished;
      const Point foot = evaluate_piece(to.piece, v).place;
      const double apart = distance(place.at, foot);
      if (!(apart < place.gap) || apart > reach) continue;
      place.gap = apart;
      place.other = to.curve;
      place.other_t = v == 1 ? to.to : to.from + v * (to.to - to.from);
      place.foot = foot;
    }
  }

  /// The displacement of a place and of the one across the gap, which come nearer along the normal.
  double approach(const Held& held) const {
    const Place& place = held.place;
    return dot(vectors(place.curve).evaluate(place.t) - vectors(place.other).evaluate(place.other_t), held.normal);
  }

  void collect_held() {
    for (const Place& place : places_) {
      if (place.other < 0 || !(place.gap > 0)) continue;
      const Vector normal = (place.foot - place.at) / place.gap;
      const double own = dot(vectors(place.curve).evaluate(place.t), normal);
      const double others = -dot(vectors(place.other).evaluate(place.other_t), normal);
      if (!(own + others > 0)) continue;
      held_.push_back({place, normal, own <= 0 ? 0 : others <= 0 ? 1 : own / (own + others)});
    }
  }

  /// The Greville abscissae in ascending order with the numbers of their points.
  using Stations = std::vector<std::pair<double, int>>;
  static Stations stations_of(const BSpline& spline) {
    Stations stations;
    for (const double t : spline.greville()) stations.push_back({t, static_cast<int>(stations.size())});
    std::ranges::sort(stations);
    return stations;
  }

  /// One round of corrections. Returns how many places were too near.
  int correct() {
    corrections_.clear();
    for (const std::vector<Vector>& all : displacements_.at_greville) corrections_.emplace_back(all.size());
    vertex_corrections_.assign(displacements_.at_vertex.size(), {});
    int count = 0;
    for (const Held& held : held_) {
      const double gap = held.place.gap;
      const double allowed = gap >= least_ ? gap - least_ : std::max(gap - least_, -opening * least_);
      const double excess = approach(held) - allowed;
      if (!(excess > close_enough * least_)) continue;
      ++count;
      ask(held.place.curve, held.place.t, -held.share * excess * held.normal);
    }
    if (count > 0) apply();
    return count;
  }

  /// Asks both Greville points beside a place for a displacement; each follows the longest that it is asked for.
  void ask(int c, double t, const Vector& by) {
    const Stations& stations = stations_[static_cast<std::size_t>(c)];
    const bool closed = curve(c).spline.closed();
    const auto after = std::ranges::lower_bound(stations, std::pair(t, -1));
    const auto n = static_cast<std::ptrdiff_t>(stations.size());
    const std::ptrdiff_t k = after - stations.begin();
    for (std::ptrdiff_t each : {k - 1, k}) {
      if (closed) each = (each + n) % n;
      if (each < 0 || each >= n) continue;
      const int i = stations[static_cast<std::size_t>(each)].second;
      Vector& correction = corrections_[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)];
      if (squared_length(by) > squared_length(correction)) correction = by;
      if (closed || (i > 0 && i + 1 < n)) continue;
      Vector& at_end = vertex_corrections_[static_cast<std::size_t>(i == 0 ? curve(c).start : curve(c).end)];
      if (squared_length(by) > squared_length(at_end)) at_end = by;
    }
  }

  void apply() {
    for (std::size_t v = 0; v < vertex_corrections_.size(); ++v) displacements_.at_vertex[v] += vertex_corrections_[v];
    for (std::size_t c = 0; c < corrections_.size(); ++c) {
      std::vector<Vector>& values = displacements_.at_greville[c];
      for (std::size_t i = 0; i < values.size(); ++i) values[i] += corrections_[c][i];
      displacements_.join_ends(boundary_.curves[c], c);
      vectors_[c].interpolate(values);
    }
  }

  const BoundaryComplex& boundary_;
  BoundaryDisplacements& displacements_;
  double least_;
  std::vector<Span> spans_;
  std::vector<Place> places_;
  std::vector<Held> held_;
  std::vector<BSpline> vectors_;  // for each curve the spline of its displacement
  std::vector<Stations> stations_;
  std::vector<std::vector<Vector>> corrections_;
  std::vector<Vector> vertex_corrections_;
};

}  // namespace

int hold_gaps(const BoundaryComplex& boundary, BoundaryDisplacements& displacements, double least) {
  return GapHolder(boundary, displacements, least).run();
}

void spread_corrections(const Mesh& mesh, std::span<const char> known, std::span<Vector> corrections) {
  std::vector<Vector> sums(corrections.size());
  std::vector<int> counts(corrections.size());
  for (int ring = 0; ring < most_rings; ++ring) {
    std::ranges::fill(sums, Vector{});
    std::ranges::fill(counts, 0);
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      if (!mesh.is_alive(t)) continue;
      Vector sum{};
      for (const PointId p : mesh.net(t)) sum += corrections[index(p)];
      const int others = mesh.net_size() - 1;
      for (const PointId p : mesh.net(t)) {
        sums[index(p)] += sum - corrections[index(p)];
        counts[index(p)] += others;
      }
    }
    for (std::size_t p = 0; p < corrections.size(); ++p)
      if (!known[p] && counts[p] > 0) corrections[p] = sums[p] / counts[p];
  }
}

}  // namespace pliant
