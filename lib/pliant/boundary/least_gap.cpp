// lib/pliant/boundary/least_gap.cpp: pairs of edges by boxes, then places where the joining line is normal to both.
#include "pliant/boundary/least_gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/gap_pieces.h"

namespace pliant {
namespace {

constexpr double distance_error = 1e-5;  // relative error of the least distance
constexpr double finest = 1.0 / 64;      // pieces smaller than this part of `below` are not halved
constexpr double normal_slope = 1e-6;    // a line whose cosine with the tangent is less is normal to it
constexpr double kink_slope = 0.02;      // the same at a joint that juts a little from the side of a body
constexpr double touching = 1e-10;       // curves nearer than this part of `below` touch
constexpr double neck_way = 2;  // the way along the boundary to the other side of a neck, per distance, is more
constexpr double body_way = 4;  // the way along the boundary to the other side of a thin body, per distance
constexpr long most_gap_pairs = 200'000;  // pairs of pieces looked at for one pair of edges
constexpr double quarter = std::numbers::pi / 2;

/// An edge's place on its curve.
struct Station {
  double turn_from, turn_to;      // how much the control polygon has turned up to its ends (radians)
  double length_from, length_to;  // its length up to there
};
struct CurveSum {
  int from, to;  // the vertices at its ends
  double turn, length;
};

/// A piece of an edge in the search.
struct GapPart {
  GapPiece piece;
  int edge;
  double turn_from, turn_to;
};

class GapSearch {
 public:
  GapSearch(std::span<const GapEdge> edges, double below) : edges_(edges), below_(below), best_(below) {
    measure_curves();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      leaving_.push_back({edges[e].from, static_cast<int>(e)});
      leaving_.push_back({edges[e].to, static_cast<int>(e)});
    }
    std::ranges::sort(leaving_);
  }

  std::optional<Gap> run() {
    std::vector<Box> boxes(edges_.size());
    for (std::size_t e = 0; e < boxes.size(); ++e) {
      for (const Point& p : edges_[e].polygon) boxes[e].extend(p);
      boxes[e].low -= {below_ / 2, below_ / 2};
      boxes[e].high += {below_ / 2, below_ / 2};
    }
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      tested_ = 0;
      compare_with_itself(part_of(e));
    }
    visit_overlapping_pairs(boxes, [this](int i, int j) {
      tested_ = 0;
      if (!turns_little(station(i), station(j), i, j)) compare(part_of(i), part_of(j));
      return best_ > 0;
    });
    return found_;
  }

 private:
  const GapEdge& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  const Station& station(int e) const { return stations_[static_cast<std::size_t>(e)]; }
  const CurveSum& curve_of(int e) const {
    return sums_[static_cast<std::size_t>(sum_of_[static_cast<std::size_t>(e)])];
  }
  bool is_same_curve(int e, int f) const {
    return sum_of_[static_cast<std::size_t>(e)] == sum_of_[static_cast<std::size_t>(f)];
  }

  void measure_curves() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const GapEdge& each = edges_[e];
      const bool begins = e == 0 || edges_[e - 1].curve != each.curve;
      if (begins) sums_.push_back({each.from, each.to, 0, 0});
      CurveSum& sum = sums_.back();
      if (!begins) sum.turn += joint(edges_[e - 1], each);
      stations_.push_back(
          {sum.turn, sum.turn + turning(each.polygon), sum.length, sum.length + polygon_length(each.polygon)});
      sum = {sum.from, each.to, stations_.back().turn_to, stations_.back().length_to};
      sum_of_.push_back(static_cast<int>(sums_.size()) - 1);
      const bool ends = e + 1 == edges_.size() || edges_[e + 1].curve != each.curve;
      if (ends && sum.from == sum.to) sum.turn += joint(each, edges_[first_of_curve(e)]);
    }
  }
  std::size_t first_of_curve(std::size_t e) const {
    while (e > 0 && edges_[e - 1].curve == edges_[e].curve) --e;
    return e;
  }
  static double joint(const GapEdge& before, const GapEdge& after) {
    return angle_between(-outward_leg(before.polygon, false), outward_leg(after.polygon, true));
  }

  GapPart part_of(int e) const { return {whole_piece(edge(e).polygon), e, station(e).turn_from, station(e).turn_to}; }
  static std::pair<GapPart, GapPart> halves_of(const GapPart& part) {
    const auto [left, right] = halves(part.piece);
    const double left_turn = part.turn_from + turning(left.polygon());
    const double right_turn = part.turn_to - turning(right.polygon());
    return {{left, part.edge, part.turn_from, left_turn}, {right, part.edge, right_turn, part.turn_to}};
  }

  /// True if the tangents of a way along one curve that contains both pieces are within a quarter turn: then the
  /// distance grows all along it, and no line between them is normal to both.
  template <class Piece>
  bool turns_little(const Piece& a, const Piece& b, int e, int f) const {
    if (!is_same_curve(e, f)) return false;
    const bool in_order = a.turn_from <= b.turn_from;
    const Piece &first = in_order ? a : b, &second = in_order ? b : a;
    if (second.turn_to - first.turn_from < quarter) return true;
    const CurveSum& sum = curve_of(e);
    return e != f && sum.from == sum.to && sum.turn + first.turn_to - second.turn_from < quarter;
  }

  void compare_with_itself(const GapPart& a) {
    if (a.turn_to - a.turn_from < quarter || polygon_length(a.piece.polygon()) < finest * below_ ||
        ++tested_ > most_gap_pairs)
      return;
    const auto [left, right] = halves_of(a);
    compare_with_itself(left);
    compare_with_itself(right);
    compare(left, right);
  }

  void compare(GapPart a, GapPart b) {
    if (++tested_ > most_gap_pairs) return;
    const ChordDistance chords = chord_distance(a.piece, b.piece);
    const double height_a = height_over_chord(a.piece), height_b = height_over_chord(b.piece);
    if (chords.distance - height_a - height_b >= best_ * (found_ ? 1 - distance_error : 1)) return;
    if (turns_little(a, b, a.edge, b.edge)) return;
    if (!reduce_to_end(a, b.piece) || !reduce_to_end(b, a.piece)) return;
    const bool touch = touch_at_ends(a, b);
    if (height_a + height_b <= 0.25 * chords.distance || is_fine(a, b)) try_near(a, b, chords, touch);
    if ((a.piece.degree == 0 && b.piece.degree == 0) || is_fine(a, b)) return;
    const bool split_a = b.piece.degree == 0 || (a.piece.degree > 0 && extent(a) >= extent(b));
    const auto [one, two] = halves_of(split_a ? a : b);
    for (const GapPart* half : {&one, &two}) split_a ? compare(*half, b) : compare(a, *half);
  }

  static double extent(const GapPart& part) {
    Box box;
    for (const Point& p : part.piece.polygon()) box.extend(p);
    return box.size();
  }
  bool is_fine(const GapPart& a, const GapPart& b) const {
    return extent(a) < finest * below_ && extent(b) < finest * below_;
  }

  /// Where the distance grows or falls all along a piece, only its near end counts, and that only at a vertex:
  /// elsewhere the edge goes on, closer still. Returns false if nothing of the piece counts.
  static bool reduce_to_end(GapPart& a, const GapPiece& other) {
    const int slope = slope_of_distance(a.piece, other);
    if (slope == 0) return true;
    const GapPiece end = end_of(a.piece, slope > 0);
    if (end.from != 0 && end.from != 1) return false;
    a.piece = end;
    return true;
  }

  /// True if the pieces have an end in common.
  bool touch_at_ends(const GapPart& a, const GapPart& b) const {
    for (const double s : {a.piece.from, a.piece.to})
      for (const double t : {b.piece.from, b.piece.to})
        if (is_same_place(a.edge, s, b.edge, t)) return true;
    return false;
  }
  bool is_same_place(int e, double s, int f, double t) const {
    if (e == f && s == t) return true;
    const int v = vertex_at(e, s);
    return v >= 0 && v == vertex_at(f, t);
  }
  int vertex_at(int e, double s) const { return s == 0 ? edge(e).from : s == 1 ? edge(e).to : -1; }

  void try_near(const GapPart& a, const GapPart& b, const ChordDistance& chords, bool touch) {
    const auto [u, v] = polish(a.piece, b.piece, chords.u, chords.v);
    const CurvePlace x = evaluate_piece(a.piece, u), y = evaluate_piece(b.piece, v);
    const double apart = distance(x.place, y.place);
    if (!(apart < best_)) return;
    const double s = a.piece.parameter(u), t = b.piece.parameter(v);
    if (apart <= touching * below_ ? touch : !is_gap(a, s, x, b, t, y)) return;
    best_ = apart;
    const bool in_order = a.edge <= b.edge;
    found_ = in_order ? Gap{apart, a.edge, b.edge, s, t, x.place, y.place}
                      : Gap{apart, b.edge, a.edge, t, s, y.place, x.place};
  }

  bool is_gap(const GapPart& a, double s, const CurvePlace& x, const GapPart& b, double t, const CurvePlace& y) const {
    const Vector apart = y.place - x.place;
    const Approach at_a = approach(a.edge, s, apart), at_b = approach(b.edge, t, -apart);
    if (!at_a.is_normal() || !at_b.is_normal()) return false;
    const double way = way_along(a.edge, s, b.edge, t) / length(apart);
    if (way <= neck_way) return false;
    // What is left: does the distance grow to the second order? The curvature counts where the line is normal to the
    // piece; a corner whose ways both lead away does not move.
    const bool moves_a = is_normal(x.first, apart), moves_b = is_normal(y.first, apart);
    const double bend_a = moves_a ? 1 - dot(x.second, apart) / squared_length(x.first) : 1;
    const double bend_b = moves_b ? 1 + dot(y.second, apart) / squared_length(y.first) : 1;
    if (bend_a < -normal_slope || bend_b < -normal_slope) return false;
    if (way > body_way) return true;
    if (!at_a.is_least() || !at_b.is_least()) return false;
    if (!moves_a || !moves_b) return true;
    const double coupling = dot(x.first, y.first) / (length(x.first) * length(y.first));
    return bend_a * bend_b - coupling * coupling >= -normal_slope;
  }

  static bool is_normal(const Vector& tangent, const Vector& line) {
    return squared_length(tangent) > 0 &&
           std::fabs(dot(tangent, line)) <= normal_slope * length(tangent) * length(line);
  }

  /// The least and the greatest cosine between the line to the other place and the ways along the boundary.
  struct Approach {
    double least, greatest;
    bool is_least() const { return greatest <= normal_slope; }
    bool is_normal() const { return is_least() || (least >= -normal_slope && greatest <= kink_slope); }
  };
  Approach approach(int e, double s, const Vector& line) const {
    const int v = vertex_at(e, s);
    if (v < 0) {
      const Vector tangent = evaluate_piece(whole_piece(edge(e).polygon), s).first;
      const double slope = tangent == Vector{} ? 0 : std::fabs(dot(tangent, line)) / (length(tangent) * length(line));
      return {-slope, slope};
    }
    Approach result{1, -1};
    auto each = std::ranges::lower_bound(leaving_, std::pair(v, 0));
    for (; each != leaving_.end() && each->first == v; ++each)
      for (const bool from_start : {true, false}) {
        if ((from_start ? edge(each->second).from : edge(each->second).to) != v) continue;
        const Vector leg = outward_leg(edge(each->second).polygon, from_start);
        if (leg == Vector{}) continue;
        const double slope = dot(leg, line) / (length(leg) * length(line));
        result = {std::min(result.least, slope), std::max(result.greatest, slope)};
      }
    return result;
  }

  /// The length of the way between two places along their curve, or along their two curves by a common end of them.
  double way_along(int e, double s, int f, double t) const {
    const auto position = [this](int at, double parameter) {
      return station(at).length_from + parameter * (station(at).length_to - station(at).length_from);
    };
    const double from = position(e, s), to = position(f, t);
    const CurveSum &a = curve_of(e), &b = curve_of(f);
    if (is_same_curve(e, f)) {
      const double way = std::fabs(to - from);
      return a.from == a.to ? std::min(way, a.length - way) : way;
    }
    double least = HUGE_VAL;
    for (const bool a_starts : {true, false})
      for (const bool b_starts : {true, false})
        if ((a_starts ? a.from : a.to) == (b_starts ? b.from : b.to))
          least = std::min(least, (a_starts ? from : a.length - from) + (b_starts ? to : b.length - to));
    return least;
  }

  std::span<const GapEdge> edges_;
  double below_, best_;
  std::vector<Station> stations_;
  std::vector<CurveSum> sums_;
  std::vector<int> sum_of_;                   // for each edge the number of its curve's sums
  std::vector<std::pair<int, int>> leaving_;  // vertices, and the edges that end there
  long tested_ = 0;                           // pairs of pieces for this pair of edges
  std::optional<Gap> found_;
};

/// Twice the mean size of the edges' boxes.
double near_distance(std::span<const GapEdge> edges) {
  double sum = 0;
  for (const GapEdge& edge : edges) {
    Box box;
    for (const Point& p : edge.polygon) box.extend(p);
    sum += box.size();
  }
  return 2 * sum / static_cast<double>(edges.size());
}

}  // namespace

std::optional<Gap> find_least_gap(std::span<const GapEdge> edges, double below) {
  if (!(below > 0) || edges.empty()) return std::nullopt;
  // Where many edges are within `below` of each other, a thinner gap is looked for first.
  constexpr double widening = 4;
  for (double near = near_distance(edges); near > 0 && near * widening < below; near *= widening)
    if (const auto found = GapSearch(edges, near).run()) return found;
  return GapSearch(edges, below).run();
}

}  // namespace pliant
