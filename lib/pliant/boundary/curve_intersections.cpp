// lib/pliant/boundary/curve_intersections.cpp: where do two Bézier curves meet? Bézier clipping.
#include "pliant/boundary/curve_intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "pliant/boundary/curve_points.h"
#include "pliant/boundary/hull_separation.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

// Near a common end, which may be the tip of a cusp:
constexpr double corner_margin = 1e-13;       // radians; curves that leave it at a greater angle are apart
constexpr double corner_tolerance = 1e-10;    // the tolerance, relative to the distance from the end
constexpr double blurred_corner = 1e-5;       // nearer, relative to the shorter curve, only crossings are looked for
constexpr double crossing_tolerance = 1e-14;  // the tolerance for these, relative to the distance from the end
constexpr double least_corner = 1e-8;         // nearer, relative to the shorter curve, nothing is compared

constexpr int most_pairs = 4000;    // pairs of parts that are looked at
constexpr double least_gain = 0.8;  // a curve of which clipping would leave more is halved instead
constexpr int newton_steps = 12;

using Polygon = std::array<Point, max_curve_degree + 1>;

/// A part of a curve: its control points, and its ends as parameters of the whole.
struct Part {
  Polygon points;
  int degree;
  double from, to;

  std::span<const Point> polygon() const { return {points.data(), static_cast<std::size_t>(degree) + 1}; }
  const Point& at(int i) const { return points[static_cast<std::size_t>(i)]; }
  double parameter(double u) const { return u == 1 ? to : from + u * (to - from); }
  Box box() const {
    Box all;
    for (const Point& p : polygon()) all.extend(p);
    return all;
  }
  double extent() const { return box().size(); }
  Part part(double u0, double u1) const {
    Part result{{}, degree, parameter(u0), parameter(u1)};
    bezier_part(polygon(), u0, u1, std::span<Point>(result.points).first(polygon().size()));
    return result;
  }
  Part reversed() const { return part(1, 0); }
};

Part whole(std::span<const Point> polygon, const Point& origin) {
  Part part{{}, static_cast<int>(polygon.size()) - 1, 0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i) part.points[i] = polygon[i] - origin;
  return part;
}

/// The interval of [0, 1] outside of which a polynomial with Bernstein coefficients d lies outside of [low, high]:
/// where the hull of its control points (i / p, d_i) meets that band. first > second if it is empty.
std::pair<double, double> clip_to_band(std::span<const double> d, double low, double high) {
  const auto p = d.size() - 1;
  double first = 2, last = -1;
  const auto take = [&](double u) {
    first = std::min(first, u);
    last = std::max(last, u);
  };
  for (std::size_t i = 0; i <= p; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(p);
    if (low <= d[i] && d[i] <= high) take(u);
    for (std::size_t j = i + 1; j <= p; ++j) {
      const double v = static_cast<double>(j) / static_cast<double>(p);
      for (const double level : {low, high})
        if ((d[i] < level) != (d[j] < level)) take(std::clamp(u + (level - d[i]) / (d[j] - d[i]) * (v - u), u, v));
    }
  }
  return {first, last};
}

/// Looks for all meetings of two curves.
class MeetingSearch {
 public:
  std::vector<Meeting> found;

  void search(const Part& a, const Part& b, const CommonEnds& common, double tolerance) {
    tolerance_ = tolerance;
    const int count = common.start_start + common.start_end + common.end_start + common.end_end;
    if (count == 0) {
      meet_ends(a, b, common);
      meet(a, b);
    } else if (count == 1) {
      from_common_end(common.end_start || common.end_end ? a.reversed() : a,
                      common.start_end || common.end_end ? b.reversed() : b);
    } else if (!coincide(a, b)) {
      const std::array halves_a{a.part(0, 0.5), a.part(0.5, 1)}, halves_b{b.part(0, 0.5), b.part(0.5, 1)};
      const std::array both{common.start_start, common.start_end, common.end_start, common.end_end};
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
          CommonEnds here;
          if (both[2 * i + j])
            (i == 0 ? (j == 0 ? here.start_start : here.start_end) : (j == 0 ? here.end_start : here.end_end)) = true;
          search(halves_a[i], halves_b[j], here, tolerance);
        }
    }
  }

  /// Ends of one curve on the other.
  void search_ends(const Part& a, const Part& b, const CommonEnds& common, double tolerance) {
    const bool meet_in_a_node = common.start_start || common.start_end || common.end_start || common.end_end;
    tolerance_ = meet_in_a_node ? std::min(tolerance, corner_tolerance * std::min(a.extent(), b.extent())) : tolerance;
    meet_ends(a, b, common);
  }

 private:
  void report(const Part& a, double u, const Part& b, double v) { found.push_back({a.parameter(u), b.parameter(v)}); }

  void meet_ends(const Part& a, const Part& b, const CommonEnds& common) {
    const std::array start_of{common.start_start || common.start_end, common.start_start || common.end_start};
    const std::array end_of{common.end_start || common.end_end, common.start_end || common.end_end};
    for (const double u : {0.0, 1.0})
      if (!(u == 0 ? start_of[0] : end_of[0]))
        if (const auto v = parameter_on(b, a.at(u == 0 ? 0 : a.degree), tolerance_)) report(a, u, b, *v);
    for (const double v : {0.0, 1.0})
      if (!(v == 0 ? start_of[1] : end_of[1]))
        if (const auto u = parameter_on(a, b.at(v == 0 ? 0 : b.degree), tolerance_)) report(a, *u, b, v);
  }

  /// The parameter of the point of `part` nearest to p, if it is within the tolerance.
  static std::optional<double> parameter_on(const Part& part, const Point& p, double tolerance) {
    const Box box = part.box();
    if (p.x < box.low.x - tolerance || p.x > box.high.x + tolerance || p.y < box.low.y - tolerance ||
        p.y > box.high.y + tolerance)
      return std::nullopt;
    const Nearest nearest = nearest_on_curve(part.polygon(), p);
    if (nearest.distance <= tolerance) return nearest.t;
    return std::nullopt;
  }

  /// Whether no leg of one is parallel to a leg of the other, so that the curves meet at most once.
  static bool is_transversal(const Part& a, const Part& b) {
    int sign = 0;
    for (int i = 0; i < a.degree; ++i) {
      const Vector leg = a.at(i + 1) - a.at(i);
      if (leg == Vector{}) continue;
      for (int j = 0; j < b.degree; ++j) {
        const Vector other = b.at(j + 1) - b.at(j);
        if (other == Vector{}) continue;
        const double turn = cross(leg, other), least = 1e-12 * length(leg) * length(other);
        const int here = turn > least ? 1 : turn < -least ? -1 : 0;
        if (here == 0 || (sign != 0 && here != sign)) return false;
        sign = here;
      }
    }
    return sign != 0;
  }

  /// Reports the meeting of curves that meet at most once; false if Newton's method finds none.
  bool refine(const Part& a, const Part& b) {
    double u = 0.5, v = 0.5;
    for (int step = 0; step < newton_steps; ++step) {
      const CurveJet p = bezier_jet(a.polygon(), u), q = bezier_jet(b.polygon(), v);
      const Vector gap = q.value - p.value;
      const double det = cross(p.derivative, q.derivative);
      if (!(std::fabs(det) > 0)) return false;
      const double next_u = std::clamp(u + cross(gap, q.derivative) / det, 0.0, 1.0);
      const double next_v = std::clamp(v + cross(gap, p.derivative) / det, 0.0, 1.0);
      const bool stays = std::fabs(next_u - u) <= 1e-16 && std::fabs(next_v - v) <= 1e-16;
      u = next_u;
      v = next_v;
      if (stays) break;
    }
    const double gap = distance(bezier_point(a.polygon(), u), bezier_point(b.polygon(), v));
    const bool inside = 0 < u && u < 1 && 0 < v && v < 1;
    if (gap > (inside ? 1e-3 : 1.0) * tolerance_) return false;
    report(a, u, b, v);
    return true;
  }

  /// Reports where two curves begin and end to run along each other: at ends of one or the other, and within twice the
  /// tolerance in between. False if they do not run along each other.
  bool coincide(const Part& a, const Part& b) {
    struct Pair {
      double u, v;
    };
    std::array<Pair, 4> ends;
    std::size_t count = 0;
    const double reach = 2 * tolerance_;
    for (const double u : {0.0, 1.0})
      if (const auto v = parameter_on(b, a.at(u == 0 ? 0 : a.degree), reach)) ends[count++] = {u, *v};
    for (const double v : {0.0, 1.0})
      if (const auto u = parameter_on(a, b.at(v == 0 ? 0 : b.degree), reach)) ends[count++] = {*u, v};
    if (count < 2) return false;
    const auto [low, high] = std::minmax_element(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count),
                                                 [](const Pair& x, const Pair& y) { return x.u < y.u; });
    if (distance(bezier_point(a.polygon(), low->u), bezier_point(a.polygon(), high->u)) <= tolerance_) return false;
    const int samples = 2 * (a.degree + b.degree) + 1;
    for (int i = 1; i < samples; ++i) {
      // Samples near the middle come first, because curves that do not coincide are farthest apart there.
      const double where = static_cast<double>(i % 2 == 1 ? (samples + i) / 2 : (samples - i + 1) / 2) / samples;
      if (!parameter_on(b, bezier_point(a.polygon(), low->u + where * (high->u - low->u)), reach)) return false;
    }
    report(a, low->u, b, low->v);
    report(a, high->u, b, high->v);
    return true;
  }

  /// Reports all meetings of two parts that have no common end.
  void meet(const Part& a, const Part& b) {
    if (hulls_apart(a.polygon(), b.polygon(), tolerance_)) return;
    const double extent_a = a.extent(), extent_b = b.extent();
    if ((extent_a <= tolerance_ && extent_b <= tolerance_) || ++pairs_ > most_pairs) {
      if (!crossings_only_) report(a, 0.5, b, 0.5);
      return;
    }
    if (is_transversal(a, b)) {
      if (refine(a, b)) return;
    } else if (!crossings_only_ && coincide(a, b)) {
      return;
    }
    if (extent_a >= extent_b)
      cut_first(a, b, [this](const Part& x, const Part& y) { meet(x, y); });
    else
      cut_first(b, a, [this](const Part& x, const Part& y) { meet(y, x); });
  }

  /// Clips `a` with the fat line of `b`, or halves it, and goes on with what is left.
  template <class Next>
  void cut_first(const Part& a, const Part& b, const Next& next) {
    const Vector chord = b.at(b.degree) - b.at(0);
    const double size = length(chord);
    if (size > tolerance_) {
      double low = 0, high = 0;
      for (const Point& p : b.polygon()) {
        const double d = cross(chord, p - b.at(0)) / size;
        low = std::min(low, d);
        high = std::max(high, d);
      }
      std::array<double, max_curve_degree + 1> d;
      for (int i = 0; i <= a.degree; ++i) d[static_cast<std::size_t>(i)] = cross(chord, a.at(i) - b.at(0)) / size;
      const auto [first, last] =
          clip_to_band(std::span<const double>(d).first(a.polygon().size()), low - tolerance_, high + tolerance_);
      if (first > last) return;
      if (last - first < least_gain) {
        const double slack = 1e-15;  // clipping to a point would leave no curve to clip
        return next(a.part(std::max(0.0, first - slack), std::min(1.0, last + slack)), b);
      }
    }
    next(a.part(0, 0.5), b);
    next(a.part(0.5, 1), b);
  }

  /// Reports all meetings of curves that start in the same point, except that point. Coordinates relative to it keep
  /// their relative precision, however near to it they are.
  void from_common_end(Part a, Part b) {
    const double tolerance = tolerance_;
    const Point origin = a.at(0);
    for (Part* part : {&a, &b})
      for (Point& p : part->points) p -= origin;
    const double whole_extent = std::min(a.extent(), b.extent());
    const double blurred = std::min(blurred_corner * whole_extent, 1e4 * tolerance);
    const double least = std::min(least_corner * whole_extent, 16 * tolerance);
    for (;;) {
      if (cones_apart(a.polygon(), b.polygon(), corner_margin)) break;
      const double extent_a = a.extent(), extent_b = b.extent();
      const double extent_both = std::min(extent_a, extent_b);
      if (!(extent_both > least)) break;
      if (!crossings_only_ && !(extent_both > blurred)) {
        crossings_only_ = true;
        pairs_ = 0;
      }
      tolerance_ = std::min(tolerance, (crossings_only_ ? crossing_tolerance : corner_tolerance) * extent_both);
      if (!crossings_only_ && coincide(a, b)) break;
      const bool cut_a = extent_a >= extent_b / 2, cut_b = extent_b >= extent_a / 2;
      const Part near_a = cut_a ? a.part(0, 0.5) : a, near_b = cut_b ? b.part(0, 0.5) : b;
      if (cut_b) meet(near_a, b.part(0.5, 1));
      if (cut_a) meet(a.part(0.5, 1), near_b);
      if (cut_a && cut_b) meet(a.part(0.5, 1), b.part(0.5, 1));
      a = near_a;
      b = near_b;
    }
    tolerance_ = tolerance;
    crossings_only_ = false;
  }

  double tolerance_ = 0;
  int pairs_ = 0;
  bool crossings_only_ = false;  // near the tip of a cusp, where curves that are only close do not meet
};

}  // namespace

std::vector<Meeting> find_meetings(std::span<const Point> a, std::span<const Point> b, const CommonEnds& common,
                                   double tolerance) {
  MeetingSearch search;
  const Point origin = a.front();
  search.search(whole(a, origin), whole(b, origin), common, tolerance);
  return std::move(search.found);
}

std::vector<Meeting> find_end_meetings(std::span<const Point> a, std::span<const Point> b, const CommonEnds& common,
                                       double tolerance) {
  MeetingSearch search;
  const Point origin = a.front();
  search.search_ends(whole(a, origin), whole(b, origin), common, tolerance);
  return std::move(search.found);
}

}  // namespace pliant
