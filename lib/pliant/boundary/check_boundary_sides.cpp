// lib/pliant/boundary/check_boundary_sides.cpp: which face lies beside each curve?
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/check_boundary.h"

namespace pliant {
namespace {

constexpr int deepest = 60;                   // halvings towards the ray's start
constexpr std::size_t most_side_faults = 20;  // one wrong curve makes others look wrong

using ControlPolygon = std::vector<Point>;

std::pair<ControlPolygon, ControlPolygon> halves(std::span<const Point> polygon) {
  ControlPolygon left(polygon.begin(), polygon.end()), right = left;
  const std::size_t p = polygon.size() - 1;
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t i = p; i >= r; --i) left[i] = 0.5 * (left[i - 1] + left[i]);
    right[p - r] = left[p];
  }
  return {left, right};
}

/// How often a curve crosses the ray from the origin along +x upwards, minus how often it does so downwards. y = 0
/// counts as above, so that curves which join on the ray cross it once.
int crossings(std::span<const Point> polygon, int depth = 0) {
  const auto above = [](const Point& q) { return q.y >= 0; };
  const auto all = [&](const auto& holds) { return std::all_of(polygon.begin(), polygon.end(), holds); };
  if (all(above) || std::none_of(polygon.begin(), polygon.end(), above)) return 0;
  if (all([](const Point& q) { return q.x < 0; })) return 0;
  if (all([](const Point& q) { return q.x > 0; }) || depth == deepest)
    return (above(polygon.back()) ? 1 : 0) - (above(polygon.front()) ? 1 : 0);
  const auto [left, right] = halves(polygon);
  return crossings(left, depth + 1) + crossings(right, depth + 1);
}

/// The same for a curve that starts in the origin; its start does not count.
int crossings_after_start(ControlPolygon polygon) {
  int count = 0;
  for (int depth = 0; depth < deepest; ++depth) {
    const auto rest = polygon.begin() + 1;
    if (std::all_of(rest, polygon.end(), [](const Point& q) { return q.y > 0; }) ||
        std::all_of(rest, polygon.end(), [](const Point& q) { return q.y < 0; }))
      break;
    auto [near, far] = halves(polygon);
    count += crossings(far);
    polygon = std::move(near);
  }
  return count;
}

/// One of the four directions along the axes.
struct Direction {
  Vector along;
  /// The polygon relative to `start`, turned so that this direction becomes +x; only the difference is rounded.
  ControlPolygon turned(std::span<const Point> polygon, const Point& start) const {
    ControlPolygon result(polygon.begin(), polygon.end());
    for (Point& q : result) q = {dot(q - start, along), cross(along, q - start)};
    return result;
  }
};

/// The spans in each of many parallel strips of the plane, to find those that a horizontal or vertical line meets.
class Strips {
 public:
  Strips(const BoundarySpans& spans, bool horizontal) : horizontal_(horizontal) {
    for (std::size_t i = 0; i < spans.size(); ++i) all_.extend(spans.box(i).low), all_.extend(spans.box(i).high);
    strips_.resize(static_cast<std::size_t>(std::sqrt(static_cast<double>(spans.size()))) + 1);
    for (std::size_t i = 0; i < spans.size(); ++i)
      for (std::size_t k = index(spans.box(i).low); k <= index(spans.box(i).high); ++k)
        strips_[k].push_back(static_cast<int>(i));
  }
  const std::vector<int>& at(const Point& p) const { return strips_[index(p)]; }

 private:
  std::size_t index(const Point& p) const {
    const double low = horizontal_ ? all_.low.y : all_.low.x, high = horizontal_ ? all_.high.y : all_.high.x;
    if (!(low < high)) return 0;
    const double share = ((horizontal_ ? p.y : p.x) - low) / (high - low);
    if (!(share > 0)) return 0;  // also where the difference overflows
    return std::min(static_cast<std::size_t>(share * static_cast<double>(strips_.size())), strips_.size() - 1);
  }

  bool horizontal_;
  Box all_;
  std::vector<std::vector<int>> strips_;
};

/// What a ray from a place beside a curve says about the face there: how often each face counts.
struct Finding {
  Point place;
  double parameter = 0;
  bool on_left = false;
  int claimed = outside;     // what the curve says lies there
  std::map<int, int> faces;  // entries are not zero
  int own_crossings = 0;     // how often the ray crosses the curve itself, upwards minus downwards

  void count(int face, int times) {
    if (face == outside || times == 0) return;
    if ((faces[face] += times) == 0) faces.erase(face);
  }
  /// The one face that counts once, or `outside` if none counts; empty if the curves contradict each other.
  std::optional<int> found() const {
    if (faces.empty()) return outside;
    if (faces.size() > 1 || faces.begin()->second != 1) return std::nullopt;
    return faces.begin()->first;
  }
};

class Sides {
 public:
  explicit Sides(const BoundaryComplex& boundary)
      : boundary_(boundary), spans_(boundary), rows_(spans_, true), columns_(spans_, false) {}

  std::vector<Fault> check() {
    std::map<int, std::vector<Finding>> wrong;
    const std::vector<std::size_t> longest = longest_spans();
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      Finding one = look(longest[c], 1);
      if (one.found() == one.claimed) continue;
      wrong[static_cast<int>(c)] = {std::move(one), look(longest[c], -1)};
    }
    std::vector<Fault> faults;
    for (std::size_t f = 0; f < boundary_.faces.size() && !wrong.empty(); ++f)
      report_face(static_cast<int>(f), wrong, faults);
    report_curves(wrong, faults);
    return faults;
  }

 private:
  std::vector<std::size_t> longest_spans() const {
    std::vector<std::size_t> longest(boundary_.curves.size(), 0);
    std::vector<double> sizes(longest.size(), -1);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const auto c = static_cast<std::size_t>(spans_[i].curve);
      if (const double size = spans_.box(i).size(); size > sizes[c]) longest[c] = i, sizes[c] = size;
    }
    return longest;
  }

  /// Follows a ray from the middle of a span. It runs along the axis that is farther from the tangent, in the direction
  /// of `sign`.
  Finding look(std::size_t own, double sign) const {
    const BoundarySpan& span = spans_[own];
    const Curve& curve = boundary_.curves[static_cast<std::size_t>(span.curve)];
    const auto [before, after] = halves(spans_.polygon(own));
    const Vector tangent = after[1] - after[0];
    const bool horizontal = std::fabs(tangent.y) >= std::fabs(tangent.x);
    const Direction ray{horizontal ? Vector{sign, 0} : Vector{0, sign}};
    Finding finding;
    finding.place = after[0];
    finding.parameter = span.t0 + 0.5 * (span.t1 - span.t0);
    finding.on_left = cross(tangent, ray.along) > 0;
    finding.claimed = finding.on_left ? curve.left : curve.right;
    const auto add = [&](std::size_t i, int times) {
      const Curve& crossed = boundary_.curves[static_cast<std::size_t>(spans_[i].curve)];
      finding.count(crossed.left, times);
      finding.count(crossed.right, -times);
      if (spans_[i].curve == span.curve) finding.own_crossings += times;
    };
    // The first half is run backwards, which changes the signs of its crossings.
    ControlPolygon backwards = ray.turned(before, finding.place);
    std::reverse(backwards.begin(), backwards.end());
    add(own, crossings_after_start(ray.turned(after, finding.place)) - crossings_after_start(std::move(backwards)));
    for (const int s : (horizontal ? rows_ : columns_).at(finding.place)) {
      const auto i = static_cast<std::size_t>(s);
      if (i == own || !reaches(spans_.box(i), finding.place, ray)) continue;
      add(i, crossings(ray.turned(spans_.polygon(i), finding.place)));
    }
    return finding;
  }

  static bool reaches(const Box& box, const Point& start, const Direction& ray) {
    if (ray.along.y == 0)
      return box.low.y <= start.y && start.y <= box.high.y &&
             (ray.along.x > 0 ? box.high.x > start.x : box.low.x < start.x);
    return box.low.x <= start.x && start.x <= box.high.x &&
           (ray.along.y > 0 ? box.high.y > start.y : box.low.y < start.y);
  }

  /// Whether this curve would be right with left and right exchanged.
  bool is_exchanged(int c, const Finding& finding) const {
    const Curve& curve = boundary_.curves[static_cast<std::size_t>(c)];
    Finding other = finding;
    other.count(curve.left, -2 * finding.own_crossings);
    other.count(curve.right, 2 * finding.own_crossings);
    return other.found() == (finding.on_left ? curve.right : curve.left);
  }

  bool is_exchanged(int c, const std::map<int, std::vector<Finding>>& wrong) const {
    const auto it = wrong.find(c);
    return it != wrong.end() && std::any_of(it->second.begin(), it->second.end(),
                                            [&](const Finding& finding) { return is_exchanged(c, finding); });
  }

  /// If a face is on the wrong side of all its curves, reports that as one fault and takes the curves out of `wrong`.
  void report_face(int f, std::map<int, std::vector<Finding>>& wrong, std::vector<Fault>& faults) const {
    std::vector<int> around;
    double area = 0;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const Curve& curve = boundary_.curves[c];
      if (curve.left == curve.right || (curve.left != f && curve.right != f)) continue;
      if (!is_exchanged(static_cast<int>(c), wrong)) return;
      around.push_back(static_cast<int>(c));
      area += (curve.left == f ? 1 : -1) * swept_area(curve.spline);
    }
    if (around.size() < 2 || area > 0) return;
    const Finding& first = wrong.at(around.front()).front();
    std::string text = name(f) + " lies on the wrong side of all its curves, ";
    constexpr std::size_t most = 4;
    for (std::size_t k = 0; k < std::min(most, around.size()); ++k)
      text += (k > 0 ? ", " : "") + describe_curve(boundary_, around[k]);
    if (around.size() > most) text += " and " + std::to_string(around.size() - most) + " more";
    faults.push_back({"boundary", "/faces/" + std::to_string(f),
                      text + ", the first at parameter " + describe_number(first.parameter) + ", " +
                          describe_point(first.place) + ": exchange left and right of all of them"});
    for (const int c : around) wrong.erase(c);
  }

  double swept_area(const BSpline& spline) const {
    std::vector<Point> points = spline.points();  // moved near the origin, where areas of open curves lose fewer digits
    for (Point& p : points) p -= spans_.nodes().front();
    return BSpline(spline.degree(), spline.closed(), spline.knots(), std::move(points)).area();
  }

  /// How doubtful it is that this curve is wrong, and not another one that its ray crosses; 0 is least.
  int doubt(int c, const Finding& finding) const { return is_exchanged(c, finding) ? 0 : finding.found() ? 1 : 2; }

  /// Reports only the curves that are wrong with the least doubt, because the others may be right once these are.
  void report_curves(const std::map<int, std::vector<Finding>>& wrong, std::vector<Fault>& faults) const {
    int least = 2;
    for (const auto& [c, findings] : wrong)
      for (const Finding& finding : findings) least = std::min(least, doubt(c, finding));
    for (const auto& [c, findings] : wrong)
      for (const Finding& finding : findings) {
        if (doubt(c, finding) != least || faults.size() >= most_side_faults) continue;
        report_curve(c, finding, faults);
        break;
      }
  }

  void report_curve(int c, const Finding& finding, std::vector<Fault>& faults) const {
    const Curve& curve = boundary_.curves[static_cast<std::size_t>(c)];
    const char* side = finding.on_left ? "left" : "right";
    std::string text = describe_curve(boundary_, c) + " at parameter " + describe_number(finding.parameter) + ", " +
                       describe_point(finding.place) + ", names " + name(finding.claimed) + " on its " + side;
    if (is_exchanged(c, finding)) {
      text += ", but " + name(finding.on_left ? curve.right : curve.left) + " lies there: exchange left and right";
    } else if (const auto found = finding.found()) {
      text += ", but by all other curves " + name(*found) + " lies there";
    } else {
      std::string count;
      for (const auto& [f, times] : finding.faces)
        count +=
            (count.empty() ? "" : ", ") + name(f) + " " + std::to_string(times) + (times == 1 ? " time" : " times");
      text += ", but by the sides of all curves what lies there is " + count + ": it should be one face, once, or none";
    }
    faults.push_back({"boundary", "/curves/" + std::to_string(c) + "/" + side, std::move(text)});
  }

  std::string name(int f) const {
    return f == outside ? "the outside" : "face '" + boundary_.faces[static_cast<std::size_t>(f)].name + "'";
  }

  const BoundaryComplex& boundary_;
  BoundarySpans spans_;
  Strips rows_, columns_;
};

}  // namespace

std::vector<Fault> check_boundary_sides(const BoundaryComplex& boundary) { return Sides(boundary).check(); }

}  // namespace pliant
