// formats/svg_import/areas/nesting.cpp: what lies on either side of loops that neither cross nor touch.
#include "formats/svg_import/areas/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "pliant/boundary/box_pairs.h"

namespace pliant::svg {
namespace {

/// A part of a Bézier curve along which x is monotone.
struct MonotonePart {
  int loop;
  int degree;
  std::array<Point, 4> points;

  const Point& front() const { return points[0]; }
  const Point& back() const { return points[static_cast<std::size_t>(degree)]; }
  bool goes_right() const { return front().x < back().x; }
  double high_end() const { return std::max(front().x, back().x); }
  Box box() const {
    Box out;
    for (int i = 0; i <= degree; ++i) out.extend(points[static_cast<std::size_t>(i)]);
    return out;
  }
  /// Does a vertical line just right of x meet the part? (It meets it once or not at all.)
  bool crosses(double x) const { return (front().x <= x) != (back().x <= x); }

  Point at(double t) const {
    std::array<Point, 4> p = points;
    for (int level = degree; level > 0; --level)
      for (int i = 0; i < level; ++i) {
        const auto k = static_cast<std::size_t>(i);
        p[k] = (1 - t) * p[k] + t * p[k + 1];
      }
    return p[0];
  }
  /// The part's y at this x.
  double height(double x) const {
    double low = 0, high = 1;  // x(low) <= x < x(high), or the other way round
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      ((at(middle).x <= x) == (front().x <= x) ? low : high) = middle;
    }
    return at(low).y;
  }
};

/// The zeros in (0, 1) of the derivative of one coordinate of a Bézier curve of degree 1 to 3.
std::vector<double> turning_points(const std::array<double, 4>& c, int degree) {
  std::vector<double> out;
  const auto add = [&out](double t) {
    if (t > 0 && t < 1) out.push_back(t);
  };
  if (degree == 2) {
    add((c[0] - c[1]) / (c[0] - 2 * c[1] + c[2]));
  } else if (degree == 3) {
    const double a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
    // a (1-t)^2 + 2 b t (1-t) + d t^2
    const double discriminant = b * b - a * d;
    if (discriminant < 0) return out;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const auto& [numerator, denominator] : {std::pair(q, d), std::pair(a, q)})
      if (numerator + denominator != 0) add(numerator / (numerator + denominator));
    std::sort(out.begin(), out.end());
  }
  return out;
}

class Nester {
 public:
  Nester(const std::vector<ShapeLoop>& loops, const std::vector<bool>& even_odd)
      : loops_(loops), even_odd_(even_odd), lowest_(loops.size(), Point{0, HUGE_VAL}), area_(loops.size(), 0) {
    for (std::size_t i = 0; i < loops.size(); ++i) add_loop(static_cast<int>(i));
  }

  Nesting nest() {
    find_parents();
    fill();
    return std::move(result_);
  }

 private:
  void add_loop(int loop) {
    const auto l = static_cast<std::size_t>(loop);
    for (const BSpline& curve : loops_[l].loop->curves) {
      const std::vector<double> breaks = curve.breaks();
      const auto count = static_cast<std::size_t>(curve.degree()) + 1;
      for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
        std::array<Point, 4> points{};
        curve.extract(breaks[s], {points.data(), count});
        add_span(loop, curve.degree(), points);
      }
      // Coordinates relative to a point of the loop, so that no cancellation changes the sign of its area.
      std::vector<Point> near = curve.points();
      const Point origin = loops_[l].loop->curves.front().points().front();
      for (Point& p : near) p -= origin;
      area_[l] += BSpline(curve.degree(), curve.closed(), curve.knots(), std::move(near)).area();
    }
  }

  void add_span(int loop, int degree, const std::array<Point, 4>& points) {
    const auto coordinate = [&](double Point::*which) {
      std::array<double, 4> out{};
      for (std::size_t i = 0; i < 4; ++i) out[i] = points[i].*which;
      return out;
    };
    MonotonePart rest{loop, degree, points};
    Point& lowest = lowest_[static_cast<std::size_t>(loop)];
    const auto lower = [&lowest](const Point& p) {
      if (p.y < lowest.y) lowest = p;
    };
    lower(rest.front());
    lower(rest.back());
    for (const double t : turning_points(coordinate(&Point::y), degree)) lower(rest.at(t));
    double done = 0;
    for (const double t : turning_points(coordinate(&Point::x), degree)) {
      MonotonePart before = rest;
      cut(rest, (t - done) / (1 - done), before);
      parts_.push_back(before);
      done = t;
    }
    parts_.push_back(rest);
  }

  /// Cuts the part before t off from `rest` and puts it into `before`; both meet in one point bit for bit.
  static void cut(MonotonePart& rest, double t, MonotonePart& before) {
    const auto p = static_cast<std::size_t>(rest.degree);
    for (std::size_t level = 0; level <= p; ++level) {
      before.points[level] = rest.points[0];
      for (std::size_t i = 0; i + level < p; ++i) rest.points[i] = (1 - t) * rest.points[i] + t * rest.points[i + 1];
    }
  }

  /// Does `a` run above `b` just right of x? Both are there, and do not cross.
  static bool is_above(const MonotonePart& a, const MonotonePart& b, double x) {
    const double common = std::min(a.high_end(), b.high_end());
    const double ya = a.height(x), yb = b.height(x);
    const double far = x + (common - x) / 2;
    // Two parts that start in one point are compared behind it.
    const double near_zero = 1e-9 * (std::abs(ya - yb) + std::abs(a.height(far) - ya) + std::abs(b.height(far) - yb));
    if (std::abs(ya - yb) > near_zero) return ya > yb;
    return a.height(far) > b.height(far);
  }

  /// Finds the loop that each loop lies in, from the part of a curve that is next below its lowest point.
  void find_parents() {
    std::vector<Box> boxes;
    boxes.reserve(parts_.size() + loops_.size());
    double bottom = HUGE_VAL;
    for (const MonotonePart& part : parts_) {
      boxes.push_back(part.box());
      bottom = std::min(bottom, boxes.back().low.y);
    }
    for (const Point& p : lowest_) boxes.push_back({{p.x, bottom}, p});
    std::vector<int> below(loops_.size(), nothing);
    const int part_count = static_cast<int>(parts_.size());
    visit_overlapping_pairs(boxes, [&](int i, int j) {
      if (i >= part_count || j < part_count) return true;
      const MonotonePart& part = parts_[static_cast<std::size_t>(i)];
      const int loop = j - part_count;
      const Point& from = lowest_[static_cast<std::size_t>(loop)];
      if (part.loop == loop || !part.crosses(from.x) || part.height(from.x) > from.y) return true;
      int& best = below[static_cast<std::size_t>(loop)];
      if (best == nothing || is_above(part, parts_[static_cast<std::size_t>(best)], from.x)) best = i;
      return true;
    });
    order_.resize(loops_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) {
      const Point &p = lowest_[static_cast<std::size_t>(a)], &q = lowest_[static_cast<std::size_t>(b)];
      return std::pair(p.y, a) < std::pair(q.y, b);
    });
    // Loops are taken in the order of their lowest points, so that the parent of the loop below is known already.
    parents_.assign(loops_.size(), nothing);
    for (const int loop : order_) {
      const int hit = below[static_cast<std::size_t>(loop)];
      if (hit == nothing) continue;
      const MonotonePart& part = parts_[static_cast<std::size_t>(hit)];
      const auto other = static_cast<std::size_t>(part.loop);
      const bool inside = part.goes_right() == (area_[other] > 0);
      parents_[static_cast<std::size_t>(loop)] = inside ? part.loop : parents_[other];
    }
  }

  bool fills(int shape, long winding) const {
    return even_odd_[static_cast<std::size_t>(shape)] ? winding % 2 != 0 : winding != 0;
  }

  /// Goes down the tree of loops with the winding number of every shape.
  void fill() {
    std::vector<std::vector<int>> children(loops_.size());
    std::vector<int> roots;
    for (const int loop : order_) {
      const int parent = parents_[static_cast<std::size_t>(loop)];
      (parent == nothing ? roots : children[static_cast<std::size_t>(parent)]).push_back(loop);
    }
    result_.sides.resize(loops_.size());
    std::vector<long> winding(even_odd_.size(), 0);
    struct Visit {
      int loop;
      bool leaves;
    };
    std::vector<Visit> stack;
    for (auto it = roots.rbegin(); it != roots.rend(); ++it) stack.push_back({*it, false});
    while (!stack.empty()) {
      const auto [loop, leaves] = stack.back();
      stack.pop_back();
      const auto l = static_cast<std::size_t>(loop);
      const int shape = loops_[l].shape;
      long& w = winding[static_cast<std::size_t>(shape)];
      const long turn = area_[l] > 0 ? 1 : -1;
      if (leaves) {
        w -= turn;
        continue;
      }
      const int parent = parents_[l];
      Sides& sides = result_.sides[l];
      sides.is_counterclockwise = turn > 0;
      sides.outer = parent == nothing ? nothing : result_.sides[static_cast<std::size_t>(parent)].inner;
      w += turn;
      if (fills(shape, w)) {
        sides.inner = shape;
        if (sides.outer != nothing && sides.outer != shape && result_.overlaps.size() < most_overlaps)
          result_.overlaps.push_back({shape, sides.outer, lowest_[l]});
      } else {
        sides.inner = sides.outer == shape ? nothing : sides.outer;
      }
      stack.push_back({loop, true});
      for (auto it = children[l].rbegin(); it != children[l].rend(); ++it) stack.push_back({*it, false});
    }
  }

  const std::vector<ShapeLoop>& loops_;
  const std::vector<bool>& even_odd_;
  std::vector<MonotonePart> parts_;
  std::vector<Point> lowest_;
  std::vector<double> area_;
  std::vector<int> order_, parents_;
  Nesting result_;
};

}  // namespace

Nesting nest(const std::vector<ShapeLoop>& loops, const std::vector<bool>& even_odd) {
  return Nester(loops, even_odd).nest();
}

}  // namespace pliant::svg
