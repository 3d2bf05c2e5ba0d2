#include "pliant/boundary/arrangement_input.h"

#include <algorithm>

#include "pliant/boundary/arrangement_curves.h"
#include "pliant/boundary/curve_intersections.h"

namespace pliant {
namespace {

constexpr double straight = 1e-13;     // height over length
constexpr double least_stride = 1e-4;  // least advance of a leg along the chord, of an even share

/// A span along the line through its two points farthest apart.
class LineSpan {
 public:
  explicit LineSpan(std::span<const Point> polygon) : polygon_(polygon) {
    Box box;
    for (const Point& p : polygon) box.extend(p);
    size_ = box.size();
  }

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

}  // namespace

std::vector<BSpline> split_at_stops(const BSpline& spline) {
  const std::vector<double> breaks = spline.breaks();
  const std::size_t count = breaks.size() - 1, order = static_cast<std::size_t>(spline.degree()) + 1;
  std::vector<Point> points(count * order);
  const auto polygon = [&](std::size_t s) { return std::span<Point>(points).subspan(s * order, order); };
  std::vector<bool> careful(count);
  for (std::size_t s = 0; s < count; ++s) {
    spline.extract(breaks[s], polygon(s));
    careful[s] = LineSpan(polygon(s)).needs_care();
  }
  const auto first = static_cast<std::size_t>(std::find(careful.begin(), careful.end(), true) - careful.begin());
  if (first == count) return {spline};
  std::vector<BSpline> result;
  const std::size_t begin = spline.closed() ? first : 0;
  for (std::size_t i = 0; i < count;) {
    const std::size_t s = (begin + i) % count;
    if (careful[s]) {
      LineSpan(polygon(s)).append_segments(spline.degree(), breaks[s], breaks[s + 1], result);
      ++i;
      continue;
    }
    std::size_t run = 1;
    while (i + run < count && !careful[(begin + i + run) % count]) ++run;
    const std::size_t last = (begin + i + run - 1) % count;
    double t1 = breaks[last + 1];
    if (last < s) t1 = spline.last_parameter() + (t1 - spline.first_parameter());
    result.push_back(part_of_curve(spline, breaks[s], t1));
    i += run;
  }
  return result;
}

}  // namespace pliant
