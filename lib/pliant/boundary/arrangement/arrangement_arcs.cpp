// lib/pliant/boundary/arrangement/arrangement_arcs.cpp: curves cut at all their intersections.
#include "pliant/boundary/arrangement/arrangement_arcs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/curve_intersections.h"
#include "pliant/boundary/curve_points.h"

namespace pliant {
namespace {

constexpr double least_piece = 4;  // in tolerances: curves are not cut into shorter pieces to make them monotone

/// Sets of points that are near each other. A set is named by its point with the least index.
class Clusters {
 public:
  explicit Clusters(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    int& p = parent_[static_cast<std::size_t>(i)];
    while (p != parent_[static_cast<std::size_t>(p)]) p = parent_[static_cast<std::size_t>(p)];
    return p;
  }
  void join(int i, int j) {
    i = find(i);
    j = find(j);
    parent_[static_cast<std::size_t>(std::max(i, j))] = std::min(i, j);
  }

  /// Joins all points whose coordinates differ by at most `radius`.
  void join_near(std::span<const Point> points, double radius) {
    std::unordered_map<std::uint64_t, std::vector<int>> cells;
    const auto cell = [&](const Point& p, int i, int j) {
      const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p.x / radius)) + i);
      const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p.y / radius)) + j);
      return (x * 0x9e3779b97f4a7c15u) ^ (y * 0xc2b2ae3d27d4eb4fu + (x >> 29));
    };
    for (std::size_t n = 0; n < points.size(); ++n) {
      const int here = static_cast<int>(n);
      const Point& p = points[n];
      bool is_known = false;  // an equal point is in a cell already, and a second one would find nothing more
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
          const auto found = cells.find(cell(p, i, j));
          if (found == cells.end()) continue;
          for (const int other : found->second) {
            const Point& q = points[static_cast<std::size_t>(other)];
            if (std::fabs(p.x - q.x) > radius || std::fabs(p.y - q.y) > radius) continue;
            join(here, other);
            is_known = is_known || p == q;
          }
        }
      if (!is_known) cells[cell(p, 0, 0)].push_back(here);
    }
  }

 private:
  std::vector<int> parent_;
};

/// A part of one span, soon monotone, that is to be cut further.
struct Piece {
  int curve;
  double t0, t1;
  int from, to;  // its ends in Cutter::places_, then nodes
  std::size_t first_point;
  int degree;
};

/// A point of a piece that is to become a node.
struct Cut {
  int piece;
  double s;
  int point;  // its index in Cutter::places_, then the node
};

class Cutter {
 public:
  Cutter(std::span<const SidedCurve> curves, std::span<const Point> vertices, const ArrangeOptions& options)
      : curves_(curves), options_(options) {
    set_scale(vertices);
    for (const Point& v : vertices) places_.push_back(scaled(v));
  }

  ArcNetwork cut() {
    add_spans();
    add_monotone_cuts();
    snap_ends();
    // First pieces are cut only where ends of others lie on them. These then meet in nodes, and curves that meet in a
    // node are compared with more care than others.
    find_cuts(find_end_meetings);
    make_nodes();
    make_arcs();
    cut_again();
    find_cuts(find_meetings);
    make_nodes();
    make_arcs();
    return std::move(result_);
  }

  ArcTolerances tolerances() const { return {touch_, std::max(sliver_, 2 * touch_), tip_}; }

 private:
  void set_scale(std::span<const Point> vertices) {
    Box box;
    double reach = 0;
    const auto take = [&](const Point& p) {
      box.extend(p);
      reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
    };
    for (const Point& p : vertices) take(p);
    for (const SidedCurve& curve : curves_)
      for (const Point& p : curve.spline->points()) take(p);
    const double size = box.size();
    result_.exponent = size > 0 ? std::ilogb(size) : 0;
    const double scaled_size = size > 0 ? std::ldexp(size, -result_.exponent) : 1;
    // Far from the origin coordinates may be coarser than a tolerance that depends on the size alone.
    const double grain = 64 * 0x1p-53 * std::ldexp(reach, -result_.exponent);
    touch_ = std::max(options_.tolerance * scaled_size, grain);
    sliver_ = std::max(options_.sliver * scaled_size, grain);
    tip_ = options_.tip * scaled_size;
  }
  Point scaled(const Point& p) const {
    return {std::ldexp(p.x, -result_.exponent), std::ldexp(p.y, -result_.exponent)};
  }
  std::span<Point> polygon(const Piece& piece) {
    return std::span<Point>(points_).subspan(piece.first_point, static_cast<std::size_t>(piece.degree) + 1);
  }
  Box box(const Piece& piece) {
    Box all;
    for (const Point& p : polygon(piece)) all.extend(p);
    return all;
  }
  int add_place(const Point& p) {
    places_.push_back(p);
    return static_cast<int>(places_.size()) - 1;
  }

  void add_spans() {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const BSpline& spline = *curves_[c].spline;
      const std::vector<double> breaks = spline.breaks();
      const std::size_t count = breaks.size() - 1;
      int first = -1, last = -1;
      for (std::size_t s = 0; s < count; ++s) {
        Piece piece{static_cast<int>(c), breaks[s], breaks[s + 1], 0, 0, points_.size(), spline.degree()};
        points_.resize(points_.size() + static_cast<std::size_t>(spline.degree()) + 1);
        spline.extract(piece.t0, polygon(piece));
        for (Point& p : polygon(piece)) p = scaled(p);
        piece.from = s == 0 ? add_place(polygon(piece).front()) : last;
        if (s == 0) first = piece.from;
        piece.to = s + 1 == count && spline.closed() ? first : add_place(polygon(piece).back());
        last = piece.to;
        pieces_.push_back(piece);
      }
    }
  }

  void add_monotone_cuts() {
    std::vector<Piece> monotone;
    std::vector<Point> part;
    for (const Piece& span : pieces_) {
      std::vector<double> cuts = monotone_cuts(polygon(span), least_piece * touch_);
      if (cuts.empty()) {
        monotone.push_back(span);
        continue;
      }
      cuts.push_back(1);
      part.resize(static_cast<std::size_t>(span.degree) + 1);
      double from = 0;
      Piece piece = span;
      for (const double to : cuts) {
        bezier_part(polygon(span), from, to, part);
        piece.t1 = to == 1 ? span.t1 : span.t0 + to * (span.t1 - span.t0);
        piece.to = to == 1 ? span.to : add_place(part.back());
        piece.first_point = points_.size();
        points_.insert(points_.end(), part.begin(), part.end());
        monotone.push_back(piece);
        piece.t0 = piece.t1;
        piece.from = piece.to;
        from = to;
      }
    }
    pieces_ = std::move(monotone);
  }

  /// Ends of pieces that are near each other become the same point.
  void snap_ends() {
    Clusters clusters(places_.size());
    clusters.join_near(places_, touch_);
    for (Piece& piece : pieces_) {
      piece.from = clusters.find(piece.from);
      piece.to = clusters.find(piece.to);
      polygon(piece).front() = places_[static_cast<std::size_t>(piece.from)];
      polygon(piece).back() = places_[static_cast<std::size_t>(piece.to)];
    }
  }

  void find_cuts(decltype(find_meetings)& find) {
    std::vector<Box> boxes;
    std::vector<int> owners;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      Box around = box(piece);
      if (piece.from == piece.to && around.size() <= least_piece * touch_) continue;
      around.low -= Vector{touch_, touch_};
      around.high += Vector{touch_, touch_};
      boxes.push_back(around);
      owners.push_back(static_cast<int>(i));
    }
    visit_overlapping_pairs(boxes, [&](int m, int n) {
      const int i = owners[static_cast<std::size_t>(m)], j = owners[static_cast<std::size_t>(n)];
      const Piece &a = pieces_[static_cast<std::size_t>(i)], &b = pieces_[static_cast<std::size_t>(j)];
      const CommonEnds common{a.from == b.from, a.from == b.to, a.to == b.from, a.to == b.to};
      for (const Meeting& meeting : find(polygon(a), polygon(b), common, touch_)) {
        const Point p = bezier_point(polygon(a), meeting.s), q = bezier_point(polygon(b), meeting.t);
        const int place = add_place(0.5 * (p + q));
        cuts_.push_back({i, meeting.s, place});
        cuts_.push_back({j, meeting.t, place});
      }
      return true;
    });
    // The order of the pairs depends on the search; nodes are to be numbered along the curves.
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
      if (a.piece != b.piece) return a.piece < b.piece;
      if (a.s != b.s) return a.s < b.s;
      return a.point < b.point;
    });
  }

  void make_nodes() {
    Clusters clusters(places_.size());
    clusters.join_near(places_, touch_);
    std::vector<int> node_of(places_.size(), -1);
    const auto node = [&](int place) {
      const auto name = static_cast<std::size_t>(clusters.find(place));
      if (node_of[name] < 0) {
        node_of[name] = static_cast<int>(result_.nodes.size());
        result_.nodes.push_back(places_[name]);
      }
      return node_of[name];
    };
    // The input's own points come first, in their order, then the cuts in the order of the curves.
    const std::size_t own = places_.size() - cuts_.size() / 2;
    for (std::size_t i = 0; i < own; ++i) (void)node(static_cast<int>(i));
    for (Cut& cut : cuts_) cut.point = node(cut.point);
    for (Piece& piece : pieces_) {
      piece.from = node(piece.from);
      piece.to = node(piece.to);
    }
  }

  /// Makes an arc between each two successive cuts. The part between an end and a cut that became the same node is
  /// dropped, because near a tip it may have crossed another piece.
  void make_arcs() {
    std::size_t next = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece piece = pieces_[i];
      std::size_t last = next;
      while (last < cuts_.size() && cuts_[last].piece == static_cast<int>(i)) ++last;
      double s = 0, end = 1;
      for (std::size_t k = last; k > next && cuts_[k - 1].point == piece.to && piece.from != piece.to; --k)
        end = cuts_[k - 1].s;
      int at = piece.from;
      for (; next < last; ++next) {
        const Cut& cut = cuts_[next];
        if (!(s < cut.s && cut.s < end) || cut.point == piece.to) continue;
        if (cut.point != at) add_arc(piece, s, cut.s, at, cut.point);
        s = cut.s;
        at = cut.point;
      }
      add_arc(piece, s, end > s ? end : 1, at, piece.to);
    }
  }

  void add_arc(const Piece& piece, double s0, double s1, int from, int to) {
    const auto at = [&](double s) { return s == 1 ? piece.t1 : piece.t0 + s * (piece.t1 - piece.t0); };
    const Arc arc{piece.curve, at(s0), at(s1), from, to, result_.points.size(), piece.degree};
    result_.points.resize(result_.points.size() + static_cast<std::size_t>(piece.degree) + 1);
    const auto out = std::span<Point>(result_.points).subspan(arc.first_point);
    bezier_part(polygon(piece), s0, s1, out);
    out.front() = result_.nodes[static_cast<std::size_t>(from)];
    out.back() = result_.nodes[static_cast<std::size_t>(to)];
    result_.arcs.push_back(arc);
  }

  /// Turns the arcs back into pieces, to be cut once more.
  void cut_again() {
    pieces_.clear();
    cuts_.clear();
    for (const Arc& arc : result_.arcs)
      pieces_.push_back({arc.curve, arc.t0, arc.t1, arc.from, arc.to, arc.first_point, arc.degree});
    points_ = std::exchange(result_.points, {});
    places_ = std::exchange(result_.nodes, {});
    result_.arcs.clear();
  }

  std::span<const SidedCurve> curves_;
  ArrangeOptions options_;
  double touch_ = 0, sliver_ = 0, tip_ = 0;
  ArcNetwork result_;
  std::vector<Point> places_;
  std::vector<Piece> pieces_;
  std::vector<Point> points_;
  std::vector<Cut> cuts_;
};

}  // namespace

void add_winding(Winding& sum, const Winding& by, int times) {
  if (times == 0) return;
  for (const auto& [face, jump] : by) {
    const auto at = std::lower_bound(sum.begin(), sum.end(), std::pair(face, 0),
                                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (at == sum.end() || at->first != face)
      sum.insert(at, {face, times * jump});
    else if ((at->second += times * jump) == 0)
      sum.erase(at);
  }
}

ArcNetwork cut_curves(std::span<const SidedCurve> curves, std::span<const Point> vertices,
                      const ArrangeOptions& options, ArcTolerances& tolerances) {
  Cutter cutter(curves, vertices, options);
  tolerances = cutter.tolerances();
  return cutter.cut();
}

}  // namespace pliant
