// lib/pliant/geometry/spline/bspline_knots.cpp: knot insertion and removal, degree elevation.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

int modulo(int i, int n) { return (i % n + n) % n; }

/// The least-squares solution x[0..n-1], by Givens rotations, of the n + 1 equations
/// (1 - alpha[q]) x[q - 1] + alpha[q] x[q] = b[q], q = 0..n. The caller knows x[-1] and x[n] and has moved their terms
/// to the right side. The solution takes the place of b[0..n-1].
void solve_bidiagonal(int n, std::span<const double> alpha, std::span<Point> b) {
  std::array<double, max_curve_degree + 1> diagonal{}, above{};
  double pivot = alpha[0];
  for (int c = 0; c < n; ++c) {
    const auto at = static_cast<std::size_t>(c);
    const double below = 1 - alpha[at + 1], next = c + 1 < n ? alpha[at + 1] : 0;
    const double radius = std::hypot(pivot, below), cosine = pivot / radius, sine = below / radius;
    diagonal[at] = radius;
    above[at] = sine * next;
    const Point upper = b[at], lower = b[at + 1];
    b[at] = cosine * upper + sine * lower;
    b[at + 1] = cosine * lower - sine * upper;
    pivot = cosine * next;
  }
  for (int c = n - 1; c >= 0; --c) {
    const auto at = static_cast<std::size_t>(c);
    if (c + 1 < n) b[at] -= above[at] * b[at + 1];
    b[at] = b[at] / diagonal[at];
  }
}

/// The slots near the two ends of 0 .. size - 1, as far as a change at the seam reaches, each with its at_slot(slot).
template <class AtSlot>
std::vector<std::pair<int, Point>> near_seam(int size, int degree, const AtSlot& at_slot) {
  std::vector<std::pair<int, Point>> found;
  const int reach = 2 * degree + 2;
  for (int slot = 0; slot < size; ++slot) {
    if (slot == reach && size > 2 * reach) slot = size - reach;
    found.emplace_back(slot, at_slot(slot));
  }
  return found;
}

/// A stretch of a knot sequence with the control points that it determines: knots.size() - degree - 1 of them.
struct Stretch {
  int degree;
  std::vector<double> knots;
  std::vector<Point> points;

  void insert(double t) {
    const int p = degree;
    const int k = static_cast<int>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin()) - 1;
    std::vector<Point> next;
    for (int i = 0; i <= static_cast<int>(points.size()); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double low = knots[at],
                   high = i + p < static_cast<int>(knots.size()) ? knots[at + static_cast<std::size_t>(p)] : low;
      if (i <= k - p || i == 0)
        next.push_back(points[at]);
      else if (i > k || t <= low || i == static_cast<int>(points.size()))
        next.push_back(points[at - 1]);
      else
        next.push_back(points[at - 1] + (t - low) / (high - low) * (points[at] - points[at - 1]));
    }
    points = std::move(next);
    knots.insert(knots.begin() + k + 1, t);
  }
};

}  // namespace

void BSpline::set_point(int i, const Point& p, Edits* edits) {
  Point& here = points_[static_cast<std::size_t>(i)];
  if (edits) edits->push_back({Edit::Kind::set_point, i, here});
  here = p;
}

void BSpline::add(const BSpline& other, double factor) {
  assert(other.points_.size() == points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i)
    set_point(static_cast<int>(i), points_[i] + factor * other.points_[i]);
}

void BSpline::insert_point(int i, Edits* edits) {
  if (edits) edits->push_back({Edit::Kind::insert_point, i, {}});
  points_.insert(static_cast<std::size_t>(i), {});
}

void BSpline::erase_point(int i, Edits* edits) {
  if (edits) edits->push_back({Edit::Kind::erase_point, i, point(i)});
  points_.erase(static_cast<std::size_t>(i));
}

void BSpline::erase_knot(int i, Edits* edits) {
  if (edits) edits->push_back({Edit::Kind::erase_knot, i, {knot(i), 0}});
  knots_.erase(static_cast<std::size_t>(i));
}

void BSpline::take_back(const Edit& edit) {
  const auto i = static_cast<std::size_t>(edit.index);
  switch (edit.kind) {
    case Edit::Kind::set_point:
      points_[i] = edit.old;
      break;
    case Edit::Kind::insert_point:
      points_.erase(i);
      break;
    case Edit::Kind::erase_point:
      points_.insert(i, edit.old);
      break;
    case Edit::Kind::set_knot:
      knots_[i] = edit.old.x;
      break;
    case Edit::Kind::insert_knot:
      knots_.erase(i);
      break;
    case Edit::Kind::erase_knot:
      knots_.insert(i, edit.old.x);
      break;
  }
}

void BSpline::insert_knot(double t, Edits* edits) {
  const int p = degree_, n = static_cast<int>(points_.size());
  if (closed_ && t == last_parameter()) t = first_parameter();
  assert(first_parameter() <= t && t < last_parameter() && (closed_ || t > first_parameter()));
  const int s = multiplicity(t), k = interval(t);
  assert(s < p);
  const int first = k - p + 1, count = p - s;
  std::array<Point, max_curve_degree> fresh;
  for (int j = 0; j < count; ++j) {
    const double alpha = (t - knot(first + j)) / (knot(first + j + p) - knot(first + j));
    fresh[static_cast<std::size_t>(j)] = (1 - alpha) * point(first + j - 1) + alpha * point(first + j);
  }
  if (first >= 0) {
    insert_point(first + count - 1, edits);
    for (int j = 0; j < count; ++j) set_point(first + j, fresh[static_cast<std::size_t>(j)], edits);
  } else {  // the change crosses the seam; control points far from the seam move on by one place
    const auto at_slot = [&](int slot) {
      const int j = modulo(slot - first, n + 1);
      return j < count ? fresh[static_cast<std::size_t>(j)] : point(first + j - 1);
    };
    const std::vector<std::pair<int, Point>> ends = near_seam(n + 1, p, at_slot);
    insert_point(0, edits);
    for (const auto& [slot, place] : ends) set_point(slot, place, edits);
  }
  if (edits) edits->push_back({Edit::Kind::insert_knot, k + 1, {}});
  knots_.insert(static_cast<std::size_t>(k) + 1, t);
}

std::optional<BSpline::KnotRemoval> BSpline::plan_removal(double& t) const {
  const int p = degree_, m = static_cast<int>(points_.size());
  if (closed_ && t == last_parameter()) t = first_parameter();
  const int s = multiplicity(t);
  if (s == 0 || s > p || (closed_ && m <= p)) return std::nullopt;
  const int r = interval(t);  // the last copy of t is the one that goes
  // Without this knot the knots are u_i = t_i (i < r), t_{i+1} (i >= r), and the points x_i obey
  // d_i = (1 - alpha_i) x_{i-1} + alpha_i x_i, i = r - p .. r - s, where x_{r-p-1} and x_{r-s} stay as they are.
  const int from = r - p, n = p - s;
  std::array<double, max_curve_degree + 1> alpha;
  KnotRemoval plan{r, s, from, n, {}, 0};
  auto& x = plan.points;
  for (int q = 0; q <= n; ++q) {
    const int i = from + q;
    alpha[static_cast<std::size_t>(q)] = (t - knot(i)) / (knot(i + p + 1) - knot(i));
    x[static_cast<std::size_t>(q)] = point(i);
  }
  const Point before = point(from - 1), after = point(r - s + 1);
  const auto last = static_cast<std::size_t>(n);
  x[0] -= (1 - alpha[0]) * before;
  x[last] -= alpha[last] * after;
  solve_bidiagonal(n, alpha, x);
  for (int q = 0; q <= n; ++q) {
    const auto at = static_cast<std::size_t>(q);
    const Point& left = q == 0 ? before : x[at - 1];
    const Point& right = q == n ? after : x[at];
    plan.error = std::max(plan.error, distance(point(from + q), (1 - alpha[at]) * left + alpha[at] * right));
  }
  return plan;
}

std::optional<double> BSpline::removal_error(double t) const {
  const std::optional<KnotRemoval> plan = plan_removal(t);
  if (!plan) return std::nullopt;
  return plan->error;
}

std::optional<double> BSpline::remove_knot(double t, Edits* edits) {
  const std::optional<KnotRemoval> plan = plan_removal(t);
  if (!plan) return std::nullopt;
  const auto& [r, s, from, n, x, error] = *plan;
  const int p = degree_, m = static_cast<int>(points_.size());
  const bool seam_goes = closed_ && r == 0 && s == 1;
  const int origin = closed_ && r == 0 && s > 1 ? -1 : 0;  // u_origin becomes the first knot
  if (from >= 0 && origin == 0) {
    erase_point(from + n, edits);
    for (int j = 0; j < n; ++j) set_point(from + j, x[static_cast<std::size_t>(j)], edits);
  } else {  // the change crosses the seam; control points far from the seam move back by one place, or not at all
    const auto at_slot = [&](int slot) {
      const int j = modulo(slot + origin - from, m - 1);
      return j < n ? x[static_cast<std::size_t>(j)] : point(from + j + 1);
    };
    const std::vector<std::pair<int, Point>> ends = near_seam(m - 1, p, at_slot);
    erase_point(origin == 0 ? 0 : m - 1, edits);
    for (const auto& [slot, place] : ends) set_point(slot, place, edits);
  }
  if (seam_goes) {
    if (edits) edits->push_back({Edit::Kind::set_knot, m, {knots_.back(), 0}});
    knots_[static_cast<std::size_t>(m)] += knots_[1] - knots_[0];
    erase_knot(0, edits);
  } else {
    erase_knot(origin < 0 ? m - 1 : r, edits);
  }
  return error;
}

std::optional<double> BSpline::remove_break(double t, Edits* edits) {
  const int s = multiplicity(t);
  if (s == 0) return std::nullopt;
  Edits own;
  Edits& all = edits ? *edits : own;
  const std::size_t mark = all.size();
  double sum = 0;
  for (int i = 0; i < s; ++i) {
    const auto error = remove_knot(t, &all);
    if (!error) {
      for (; all.size() > mark; all.pop_back()) take_back(all.back());
      return std::nullopt;
    }
    sum += *error;
  }
  return sum;
}

Point BSpline::blossom(std::span<const double> arguments) const {
  const int p = degree_, n = static_cast<int>(points_.size());
  int low = closed_ && arguments.front() >= last_parameter() ? n : interval(arguments.front());
  while (closed_ && knot(low + 1) <= arguments.front()) ++low;
  int high = low + 1;
  while (knot(high) < arguments.back()) ++high;
  const int from = low - p, to = closed_ ? high + p + 1 : std::min(high + p + 1, n + p);
  Stretch stretch{p, {}, {}};
  for (int i = from; i <= to; ++i) stretch.knots.push_back(knot(i));
  for (int i = from; i < to - p; ++i) stretch.points.push_back(point(i));

  const auto copies = [](std::span<const double> sorted, double value) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    return last - first;
  };
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (i == 0 || arguments[i] != arguments[i - 1])
      while (copies(stretch.knots, arguments[i]) < copies(arguments, arguments[i])) stretch.insert(arguments[i]);

  // The arguments are consecutive knots now. One more knot must follow them; at a clamped end, where none does, earlier
  // copies of the same values are taken.
  const auto after = std::upper_bound(stretch.knots.begin(), stretch.knots.end(), arguments.front());
  auto start = after - stretch.knots.begin() - copies(arguments, arguments.front());
  if (start + p >= static_cast<std::ptrdiff_t>(stretch.knots.size())) --start;
  return stretch.points[static_cast<std::size_t>(start) - 1];
}

BSpline BSpline::elevated() const {
  const int p = degree_, q = p + 1;
  assert(p < max_curve_degree);
  // The new knots are the old ones, and every break once more.
  std::vector<double> knots = breaks();
  if (closed_) knots.pop_back();
  knots.insert(knots.end(), knots_.begin(), knots_.end());
  std::sort(knots.begin(), knots.end());
  const int count = static_cast<int>(knots.size()) - (closed_ ? 1 : q + 1);

  // New control point i is the new blossom at q knots: the mean, over these knots, of the old blossom at the q - 1
  // others. The others include all old knots there, so that knot insertion (convex combinations) finds the blossom.
  std::vector<Point> points;
  const auto new_knot = [&](int i) {
    if (!closed_ || i < count) return knots[static_cast<std::size_t>(i)];
    const int periods = i / count - 1;  // the same arithmetic as in knot(), so that copies of a knot stay equal
    return last_parameter() + periods * period() + (knots[static_cast<std::size_t>(i % count)] - first_parameter());
  };
  for (int i = 0; i < count; ++i) {
    Point sum;
    for (int omitted = 1; omitted <= q; ++omitted) {
      std::vector<double> arguments;
      for (int j = 1; j <= q; ++j)
        if (j != omitted) arguments.push_back(new_knot(i + j));
      sum += blossom(arguments);
    }
    points.push_back(sum / q);
  }
  if (!closed_) {  // a mean of equal points may differ from them in the last digit
    points.front() = points_.front();
    points.back() = points_.back();
  }
  return BSpline(q, closed_, std::move(knots), std::move(points));
}

}  // namespace pliant
