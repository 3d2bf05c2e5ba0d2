// lib/pliant/geometry/validity/swept_validity.cpp: bisection in space, halving in time.
#include "pliant/geometry/validity/swept_validity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/bisect_net.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/geometry/validity/jacobian_enclosure.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant {
namespace {

constexpr double finest_interval = 0x1p-12;  // shorter intervals of time are not halved
constexpr int depth_at_cusp = 20;  // pieces at a cusp's corner are bisected no further; they are 2^-10 of the element

/// det J(xi, t) in tensor Bernstein form: for each of the three coefficients in time a net in lattice order.
struct SweptJacobian {
  int degree = 0;
  double error = 0;     // of each coefficient, as in JacobianEnclosure; the middle net has one addition more
  double greatest = 0;  // max |coefficient|
  std::array<std::array<double, max_jacobian_size>, 3> coefficients;
};

struct FloatPartials {
  std::array<Vector, max_partials> along_2, along_3;
};

/// A weighted sum of cross products, and the same sum of the absolute values of all their products.
struct SizedSum {
  double value = 0, size = 0;
  void add(double weight, const Vector& a, const Vector& b) {
    const double plus = a.x * b.y;
    const double minus = a.y * b.x;
    value += weight * (plus - minus);
    size += weight * (std::fabs(plus) + std::fabs(minus));
  }
};

/// Sets `result` to det J during the motion; false if differences overflow.
bool sweep(int degree, std::span<const Point> from, std::span<const Point> to, SweptJacobian& result) {
  const JacobianTerms& terms = JacobianTerms::of(degree);
  const std::size_t count = terms.partials.size();
  FloatPartials a;
  FloatPartials b;
  partial_differences(terms, from, a.along_2, a.along_3);
  partial_differences(terms, to, b.along_2, b.along_3);
  const double greatest =
      std::max(greatest_component(std::span(a.along_2).first(count), std::span(a.along_3).first(count)),
               greatest_component(std::span(b.along_2).first(count), std::span(b.along_3).first(count)));
  if (!std::isfinite(greatest)) return false;
  for (FloatPartials* p : {&a, &b})
    normalise_differences(std::span(p->along_2).first(count), std::span(p->along_3).first(count), greatest);

  result.degree = jacobian_degree(degree);
  result.greatest = 0;
  double largest_size = 0;
  const std::vector<int>& order = lattice_order(result.degree);
  auto term = terms.terms.begin();
  for (int target = 0; target < net_size(result.degree); ++target) {
    std::array<SizedSum, 3> sums;
    for (; term != terms.terms.end() && term->target == target; ++term) {
      const std::size_t i = index(term->i);
      const std::size_t j = index(term->j);
      sums[0].add(term->weight, a.along_2[i], a.along_3[j]);
      sums[1].add(term->weight / 2, a.along_2[i], b.along_3[j]);
      sums[1].add(term->weight / 2, b.along_2[i], a.along_3[j]);
      sums[2].add(term->weight, b.along_2[i], b.along_3[j]);
    }
    for (std::size_t m = 0; m < 3; ++m) {
      result.coefficients[m][index(order[index(target)])] = sums[m].value;
      result.greatest = std::max(result.greatest, std::fabs(sums[m].value));
      largest_size = std::max(largest_size, sums[m].size);
    }
  }
  // The coefficients of the middle net have twice as many terms.
  result.error = (2 * terms.most_terms + 8) * unit_roundoff * largest_size + 0x1p-1000;
  return true;
}

/// Proves det J > 0 on the whole element for all times of one interval, or gives up.
class IntervalProof {
 public:
  IntervalProof(const SweptJacobian& jacobian, int cusp)
      : jacobian_(jacobian), cusp_(cusp), size_(index(net_size(jacobian.degree))) {}

  bool holds_on(double begin, double end) {
    const bool is_finest = end - begin <= finest_interval;
    const int most_pieces = is_finest ? 4000 : 60;
    restrict_to(begin, end);
    const double error = jacobian_.error + 16 * unit_roundoff * jacobian_.greatest;  // two interpolations in time
    for (int count = 0; !pieces_.empty(); ++count) {
      const auto [depth, cusp] = pieces_.back();
      pieces_.pop_back();
      const double bound = error + 2 * depth * jacobian_.degree * unit_roundoff * jacobian_.greatest;
      piece_.assign(stack_.end() - static_cast<std::ptrdiff_t>(3 * size_), stack_.end());
      stack_.resize(stack_.size() - 3 * size_);
      if (*std::min_element(piece_.begin(), piece_.end()) > bound) continue;
      if (cusp >= 0 && depth >= depth_at_cusp) continue;
      if (count >= most_pieces || !is_positive_at_corners(bound, cusp)) return false;
      bisect();
      pieces_.push_back({depth + 1, corner_in_left(cusp)});
      pieces_.push_back({depth + 1, corner_in_right(cusp)});
    }
    return true;
  }

 private:
  /// Makes the element, with its three nets of the time interval, the only piece.
  void restrict_to(double begin, double end) {
    const auto mix = [](double s, double x, double y) { return (1 - s) * x + s * y; };
    stack_.resize(3 * size_);
    pieces_.assign(1, {0, cusp_});
    for (std::size_t n = 0; n < size_; ++n) {
      const auto& c = jacobian_.coefficients;
      const double first[2] = {mix(begin, c[0][n], c[1][n]), mix(begin, c[1][n], c[2][n])};
      const double last[2] = {mix(end, c[0][n], c[1][n]), mix(end, c[1][n], c[2][n])};
      stack_[n] = mix(begin, first[0], first[1]);
      stack_[size_ + n] = mix(end, first[0], first[1]);
      stack_[2 * size_ + n] = mix(end, last[0], last[1]);
    }
  }

  /// Whether det J is positive at the corners of piece_ when the interval begins and when it ends.
  bool is_positive_at_corners(double bound, int cusp) const {
    const std::array<int, 3> corners = lattice_corners(jacobian_.degree);
    for (int c = 0; c < 3; ++c) {
      const std::size_t n = index(corners[index(c)]);
      if (c != cusp && (piece_[n] <= bound || piece_[2 * size_ + n] <= bound)) return false;
    }
    return true;
  }

  void bisect() {
    const std::size_t old = stack_.size();
    stack_.resize(old + 6 * size_);
    for (std::size_t m = 0; m < 3; ++m)
      bisect_net<FloatingMean>(jacobian_.degree, &piece_[m * size_], &stack_[old + m * size_],
                               &stack_[old + (3 + m) * size_], row_);
  }

  struct Place {
    int depth;
    int cusp;  // the corner of the piece that is forgiven, or -1
  };
  const SweptJacobian& jacobian_;
  int cusp_;
  std::size_t size_;
  std::vector<double> stack_;  // three nets for each piece
  std::vector<Place> pieces_;
  std::vector<double> piece_;
  std::vector<double> row_;
};

/// The end of the proved part of [begin, end].
double proved_until(IntervalProof& proof, double begin, double end) {
  if (proof.holds_on(begin, end)) return end;
  if (end - begin <= finest_interval) return begin;
  const double middle = (begin + end) / 2;
  const double reached = proved_until(proof, begin, middle);
  return reached < middle ? reached : proved_until(proof, middle, end);
}

/// Proves quickly that all coefficients of a quadratic element's det J are positive during the motion, by far; false
/// proves nothing. The differences of the net and their products are those of `quadratic_jacobian`.
bool is_surely_positive(std::span<const Point> from, std::span<const Point> to) {
  const auto along_2 = [](std::span<const Point> n) { return std::array{n[3] - n[0], n[1] - n[3], n[4] - n[5]}; };
  const auto along_3 = [](std::span<const Point> n) { return std::array{n[5] - n[0], n[4] - n[3], n[2] - n[5]}; };
  const std::array a{along_2(from), along_2(to)}, b{along_3(from), along_3(to)};
  double least = HUGE_VAL, sum = 0, greatest = 0;
  const auto see = [&](double coefficient) {
    least = std::min(least, coefficient);
    sum += coefficient;  // not finite if any of them, or any difference, is not
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    for (std::size_t time = 0; time < 2; ++time) {
      for (const Vector& v : {a[time][i], b[time][i]})
        greatest = std::max(greatest, std::max(std::fabs(v.x), std::fabs(v.y)));
      see(cross(a[time][i], b[time][i]));
      see((cross(a[time][i], b[time][j]) + cross(a[time][j], b[time][i])) / 2);
    }
    const auto between = [&](std::size_t m, std::size_t n) {
      return (cross(a[0][m], b[1][n]) + cross(a[1][m], b[0][n])) / 2;
    };
    see(between(i, i));
    see((between(i, j) + between(j, i)) / 2);
  }
  constexpr double rounding = 1e-12;  // all errors together are some 1e-14 of the greatest product
  const double bound = rounding * greatest * greatest;
  return std::isfinite(sum) && bound > 1e-280 && bound < 1e280 && least > bound;
}

bool is_valid(int degree, std::span<const Point> net, int cusp) {
  return (cusp < 0 ? certify(degree, net) : certify_cusp(degree, net, cusp)) == Validity::valid;
}

}  // namespace

double safe_fraction(int degree, std::span<const Point> from, std::span<const Point> to, int cusp) {
  assert(-1 <= cusp && cusp < 3);
  assert(1 <= degree && degree <= max_degree);
  assert(from.size() >= index(net_size(degree)) && to.size() >= index(net_size(degree)));
  if (degree == 2 && is_surely_positive(from, to)) return 1;
  const auto count = static_cast<std::ptrdiff_t>(net_size(degree));
  if (!std::all_of(from.begin(), from.begin() + count, is_finite) ||
      !std::all_of(to.begin(), to.begin() + count, is_finite))
    return 0;
  SweptJacobian jacobian;
  if (!sweep(degree, from, to, jacobian)) return 0;
  const auto size = static_cast<std::ptrdiff_t>(net_size(jacobian.degree));
  const bool is_all_positive = std::ranges::all_of(jacobian.coefficients, [&](const auto& net) {
    return std::all_of(net.begin(), net.begin() + size, [&](double x) { return x > jacobian.error; });
  });
  if (is_all_positive) return 1;
  if (std::equal(from.begin(), from.begin() + net_size(degree), to.begin()))
    return is_valid(degree, from, cusp) ? 1 : 0;  // at rest, the exact answer holds for all times
  IntervalProof proof(jacobian, cusp);
  return proved_until(proof, 0, 1);
}

}  // namespace pliant
