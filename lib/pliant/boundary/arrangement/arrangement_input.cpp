// lib/pliant/boundary/arrangement/arrangement_input.cpp: finds stops, folds and tips, and cuts a curve there.
#include "pliant/boundary/arrangement/arrangement_input.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "pliant/boundary/arrangement/arrangement_curves.h"
#include "pliant/boundary/curve_points.h"
#include "pliant/geometry/spline/turning_angle.h"

namespace pliant {
namespace {

// A span is straight if its height, divided by its size, is at most this.
constexpr double straight = 1e-13;
// A straight span stops where a leg advances along the chord by less than this part of an even share.
constexpr double least_stride = 1e-4;
// A curve stops at an end where its last leg is shorter than this part of its length.
constexpr double least_speed = 1e-7;
// A tip turns by more than this, which is as much as a span of a mesh may turn.
constexpr double most_turning = std::numbers::pi / 3;

/// A span that may lie on a line.
class LineSpan {
 public:
  explicit LineSpan(std::span<const Point> polygon) : polygon_(polygon) {
    Box box;
    for (const Point& p : polygon) box.extend(p);
    size_ = box.size();
  }

  /// Whether the span stays at one point, or lies on a line and stops or folds back there.
  bool needs_care() const {
    if (!(size_ > 0)) return true;
    Point from, to;
    for (const Point& p : polygon_)
      for (const Point& q : polygon_)
        if (squared_length(q - p) > squared_length(to - from)) {
          from = p;
          to = q;
        }
    const Vector along = (to - from) / length(to - from);
    for (const Point& p : polygon_)
      if (std::fabs(cross(along, p - from)) > straight * size_) return false;
    const Vector chord = polygon_.back() - polygon_.front();
    const double even = squared_length(chord) / static_cast<double>(polygon_.size() - 1);
    for (std::size_t i = 1; i < polygon_.size(); ++i)
      if (!(dot(polygon_[i] - polygon_[i - 1], chord) > least_stride * even)) return true;
    return false;
  }

  /// Appends the segments between the points where the span turns back, each run through with constant speed.
  void append_segments(int degree, double t0, double t1, std::vector<BSpline>& result) const {
    std::vector<double> cuts = monotone_cuts(polygon_, 1e-12 * size_);
    cuts.insert(cuts.begin(), 0);
    cuts.push_back(1);
    for (std::size_t c = 1; c < cuts.size(); ++c) {
      const Point from = c == 1 ? polygon_.front() : bezier_point(polygon_, cuts[c - 1]);
      const Point to = c + 1 == cuts.size() ? polygon_.back() : bezier_point(polygon_, cuts[c]);
      if (from == to) continue;
      std::vector<Point> points;
      for (int i = 0; i <= degree; ++i)
        points.push_back(i == degree ? to : from + static_cast<double>(i) / degree * (to - from));
      std::vector<double> knots(static_cast<std::size_t>(degree) + 1, t0 + cuts[c - 1] * (t1 - t0));
      knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1,
                   c + 1 == cuts.size() ? t1 : t0 + cuts[c] * (t1 - t0));
      result.emplace_back(degree, false, std::move(knots), std::move(points));
    }
  }

 private:
  std::span<const Point> polygon_;
  double size_ = 0;
};

/// A part of a curve in which it stops, folds back or has a tip. Segments take its place, or a corner.
struct Stop {
  double t0, t1;
  std::size_t span;
  bool is_tip;
};

/// Finds all stops of a curve, and makes the parts between them.
class StopFinder {
 public:
  StopFinder(const BSpline& spline, double tip) : spline_(spline), tip_(tip), breaks_(spline.breaks()) {}

  std::vector<BSpline> split() {
    find_stops();
    if (stops_.empty()) return {spline_};
    if (spline_.closed()) join_over_seam();
    const std::size_t count = stops_.size();
    const double first = spline_.first_parameter(), last = spline_.last_parameter();
    if (!spline_.closed()) add_run(first, stops_.front().t0);
    for (std::size_t i = 0; i < count; ++i) {
      if (stops_[i].is_tip)
        tips_.push_back({result_.size(), stops_[i]});
      else
        LineSpan(polygon_of(stops_[i].span)).append_segments(spline_.degree(), stops_[i].t0, stops_[i].t1, result_);
      if (i + 1 < count)
        add_run(stops_[i].t1, stops_[i + 1].t0);
      else
        add_run(stops_[i].t1, spline_.closed() ? stops_.front().t0 + (last - first) : last);
    }
    close_tips();
    return std::move(result_);
  }

 private:
  struct Tip {
    std::size_t after;  // how many parts of the result come before it
    Stop stop;
  };

  std::span<const Point> polygon_of(std::size_t s) {
    points_.resize(static_cast<std::size_t>(spline_.degree()) + 1);
    spline_.extract(breaks_[s], points_);
    return points_;
  }

  void find_stops() {
    for (std::size_t s = 0; s + 1 < breaks_.size(); ++s) {
      const auto polygon = polygon_of(s);
      if (LineSpan(polygon).needs_care())
        stops_.push_back({breaks_[s], breaks_[s + 1], s, false});
      else
        find_tips(polygon, s, 0, 1);
    }
  }

  /// Halves a part that turns too much or stops at an end, until it is short enough to be a tip or does neither.
  void find_tips(std::span<const Point> polygon, std::size_t s, double u0, double u1) {
    double length = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i) length += distance(polygon[i - 1], polygon[i]);
    const double slowest =
        std::min(distance(polygon[0], polygon[1]), distance(polygon[polygon.size() - 2], polygon.back()));
    if (turning_angle(polygon) <= most_turning && slowest > least_speed * length) return;
    if (length <= tip_) return add_tip(s, u0, u1);
    const double middle = u0 + (u1 - u0) / 2;
    if (!(u0 < middle && middle < u1)) return;
    std::array<Point, max_curve_degree + 1> half;
    const auto part = std::span<Point>(half).first(polygon.size());
    bezier_part(polygon, 0, 0.5, part);
    find_tips(part, s, u0, middle);
    bezier_part(polygon, 0.5, 1, part);
    find_tips(part, s, middle, u1);
  }

  void add_tip(std::size_t s, double u0, double u1) {
    const double from = breaks_[s], to = breaks_[s + 1];
    const Stop tip{from + u0 * (to - from), u1 == 1 ? to : from + u1 * (to - from), s, true};
    if (!stops_.empty() && stops_.back().is_tip && stops_.back().t1 == tip.t0)
      stops_.back().t1 = tip.t1;
    else
      stops_.push_back(tip);
  }

  void join_over_seam() {
    Stop& last = stops_.back();
    const Stop& first = stops_.front();
    if (stops_.size() < 2 || !first.is_tip || !last.is_tip || first.t0 != spline_.first_parameter() ||
        last.t1 != spline_.last_parameter())
      return;
    last.t1 += first.t1 - first.t0;
    stops_.erase(stops_.begin());
    if (stops_.size() > 1) std::rotate(stops_.begin(), stops_.end() - 1, stops_.end());
    const double period = spline_.last_parameter() - spline_.first_parameter();
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      stops_[i].t0 += period;
      stops_[i].t1 += period;
    }
  }

  void add_run(double t0, double t1) {
    if (!(t0 < t1)) return;
    const double last = spline_.last_parameter(), period = last - spline_.first_parameter();
    if (spline_.closed() && t0 >= last) {
      t0 -= period;
      t1 -= period;
    }
    result_.push_back(part_of_curve(spline_, t0, t1));
  }

  /// Makes the two parts beside each tip end in the same point. A tip at an end of the curve keeps the end point.
  void close_tips() {
    const std::size_t count = result_.size();
    for (const Tip& tip : tips_) {
      if (count == 0) return;
      const bool has_before = tip.after > 0 || spline_.closed(), has_after = tip.after < count || spline_.closed();
      BSpline& before = result_[(tip.after + count - 1) % count];
      BSpline& after = result_[tip.after % count];
      const int last = static_cast<int>(before.points().size()) - 1;
      const Point low = has_before ? before.points().back() : spline_.points().front();
      const Point high = has_after ? after.points().front() : spline_.points().back();
      const Point place = !has_before ? low : !has_after ? high : 0.5 * (low + high);
      if (has_before) before.set_point(last, place);
      if (has_after) after.set_point(0, place);
    }
  }

  const BSpline& spline_;
  double tip_;
  std::vector<double> breaks_;
  std::vector<Point> points_;
  std::vector<Stop> stops_;
  std::vector<Tip> tips_;
  std::vector<BSpline> result_;
};

}  // namespace

std::vector<BSpline> split_at_stops(const BSpline& spline, double tip) { return StopFinder(spline, tip).split(); }

}  // namespace pliant
