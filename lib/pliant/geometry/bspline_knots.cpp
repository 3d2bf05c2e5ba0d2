#include <algorithm>  // lib/pliant/geometry/bspline_knots.cpp: knot insertion and removal, degree elevation
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "pliant/geometry/bspline.h"

namespace pliant {
namespace {

int modulo(int i, int n) { return (i % n + n) % n; }

/// The least-squares solution of (1 - alpha[q]) x[q - 1] + alpha[q] x[q] = b[q], q = 0..n, for x[0..n-1], where x[-1]
/// and x[n] are already known and moved to the right side: one equation too many. Givens rotations.
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

BSpline::KnotInsertion BSpline::plan_insertion(double& t) const {
  const int p = degree_;
  if (closed_ && t == last_parameter()) t = first_parameter();
  assert(first_parameter() <= t && t < last_parameter() && (closed_ || t > first_parameter()));
  const int s = multiplicity(t), k = interval(t);
  assert(s < p);
  KnotInsertion plan{k + 1, k - p + 1, p - s, {}};
  for (int j = 0; j < plan.count; ++j) {
    const int i = plan.first + j;
    const double alpha = (t - knot(i)) / (knot(i + p) - knot(i));
    plan.points[static_cast<std::size_t>(j)] = (1 - alpha) * point(i - 1) + alpha * point(i);
  }
  return plan;
}

std::optional<BSpline::KnotInsertion> BSpline::insert_knot_locally(double t) {
  KnotInsertion plan = plan_insertion(t);
  const int last = plan.first + plan.count - 1;
  if (plan.first < 0 || last > static_cast<int>(points_.size())) return std::nullopt;
  std::array<Point, max_curve_degree> old{};
  std::copy_n(points_.begin() + plan.first, plan.count - 1, old.begin());
  points_.insert(points_.begin() + last, Point{});
  std::copy_n(plan.points.begin(), plan.count, points_.begin() + plan.first);
  knots_.insert(knots_.begin() + plan.knot, t);
  plan.points = old;
  return plan;
}

void BSpline::take_back(const KnotInsertion& insertion) {
  knots_.erase(knots_.begin() + insertion.knot);
  points_.erase(points_.begin() + insertion.first + insertion.count - 1);
  std::copy_n(insertion.points.begin(), insertion.count - 1, points_.begin() + insertion.first);
}

void BSpline::insert_knot(double t) {
  if (insert_knot_locally(t)) return;
  const KnotInsertion plan = plan_insertion(t);
  const int n = static_cast<int>(points_.size());
  std::vector<Point> next(static_cast<std::size_t>(n) + 1);
  for (int slot = 0; slot <= n; ++slot) {
    const int j = modulo(slot - plan.first, n + 1);
    next[static_cast<std::size_t>(slot)] =
        j < plan.count ? plan.points[static_cast<std::size_t>(j)] : point(plan.first + j - 1);
  }
  points_ = std::move(next);
  knots_.insert(knots_.begin() + plan.knot, t);
}

std::optional<BSpline::KnotRemoval> BSpline::plan_removal(double& t) const {
  const int p = degree_, m = static_cast<int>(points_.size());
  if (closed_ && t == last_parameter()) t = first_parameter();
  const int s = multiplicity(t);
  if (s == 0 || s > p || (closed_ && m <= p)) return std::nullopt;
  const int r = interval(t);  // the knot that goes is the last of its copies
  // Without it the knots are u_i = t_i (i < r), t_{i+1} (i >= r), and the points x_i obey
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

std::optional<double> BSpline::remove_knot(double t) {
  const std::optional<KnotRemoval> plan = plan_removal(t);
  if (!plan) return std::nullopt;
  const auto& [r, s, from, n, x, error] = *plan;
  const int m = static_cast<int>(points_.size());
  const bool seam_goes = closed_ && r == 0 && s == 1;
  const int origin = closed_ && r == 0 && s > 1 ? -1 : 0;  // u_origin is the first knot
  std::vector<Point> next(static_cast<std::size_t>(m) - 1);
  for (int slot = 0; slot < m - 1; ++slot) {
    const int j = closed_ ? modulo(slot + origin - from, m - 1) : slot - from;
    next[static_cast<std::size_t>(slot)] = j < 0   ? point(slot)
                                           : j < n ? x[static_cast<std::size_t>(j)]
                                                   : point(from + j + 1);
  }
  points_ = std::move(next);
  if (seam_goes) {
    knots_.back() += knots_[1] - knots_[0];
    knots_.erase(knots_.begin());
  } else {
    knots_.erase(origin < 0 ? knots_.end() - 2 : knots_.begin() + r);
  }
  return error;
}

std::optional<double> BSpline::remove_break(double t) {
  const BSpline old = *this;
  const int s = multiplicity(t);
  if (s == 0) return std::nullopt;
  double sum = 0;
  for (int i = 0; i < s; ++i) {
    const auto error = remove_knot(t);
    if (!error) {
      *this = old;
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

  // The arguments are now consecutive knots; one more knot must follow (at the clamped end take earlier copies).
  const auto after = std::upper_bound(stretch.knots.begin(), stretch.knots.end(), arguments.front());
  auto start = after - stretch.knots.begin() - copies(arguments, arguments.front());
  if (start + p >= static_cast<std::ptrdiff_t>(stretch.knots.size())) --start;
  return stretch.points[static_cast<std::size_t>(start) - 1];
}

BSpline BSpline::elevated() const {
  const int p = degree_, q = p + 1;
  assert(p < max_curve_degree);
  // The new knots: every break once more.
  std::vector<double> knots = breaks();
  if (closed_) knots.pop_back();
  knots.insert(knots.end(), knots_.begin(), knots_.end());
  std::sort(knots.begin(), knots.end());
  const int count = static_cast<int>(knots.size()) - (closed_ ? 1 : q + 1);

  // New point i is the blossom at q knots, which is the mean of the old blossom with one of them left out. What is
  // left refines the old knots there, so that knot insertion (convex combinations) finds its value.
  std::vector<Point> points;
  const auto new_knot = [&](int i) {
    if (!closed_ || i < count) return knots[static_cast<std::size_t>(i)];
    const int periods = i / count - 1;  // the very arithmetic of knot(): copies of a knot stay equal
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
  if (!closed_) {  // the mean of equal points may be off in the last digit
    points.front() = points_.front();
    points.back() = points_.back();
  }
  return BSpline(q, closed_, std::move(knots), std::move(points));
}

}  // namespace pliant
