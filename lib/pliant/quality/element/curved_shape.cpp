// lib/pliant/quality/element/curved_shape.cpp: the least tau in an element, the minimum of a ratio of two polynomials.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/quality/element/element_forms.h"
#include "pliant/quality/element/element_quality.h"

// tau = sqrt(3) N / S with N = det J and S = `squares` (element_forms.h). If every Bernstein coefficient of
// sqrt(3) N - t S on a piece of the element is nonnegative, tau >= t there; that gives a lower bound for the piece. The
// values of tau at the corners of pieces are upper bounds of the minimum. Pieces are bisected, depth first, until the
// lower and the upper bound agree.
namespace pliant {
namespace {

constexpr int greatest_depth = 60;
constexpr int most_pieces = 4096;

/// Where the coefficients with exponent k start, if they stand in rows of constant k and in a row by ascending j. In
/// this order, a bisection of edge 12 is one de Casteljau scheme for each row.
constexpr int row_start(int degree, int k) { return k * (degree + 1) - k * (k - 1) / 2; }

/// For each coefficient in the order of NetLayout its position in that order.
const std::vector<int>& row_order(int degree) {
  static const std::vector<std::vector<int>> all = [] {
    std::vector<std::vector<int>> orders;
    for (int d = 0; d <= 2 * (max_degree - 1); ++d) {
      std::vector<int>& order = orders.emplace_back();
      for (int n = 0; n < net_size(d); ++n) {
        const auto [i, j, k] = NetLayout::of(d).exponents(n);
        order.push_back(row_start(d, k) + j);
      }
    }
    return orders;
  }();
  return all[index(degree)];
}

/// Newest-vertex bisection of a net in rows. With m the middle of edge 12, `left` becomes the net on the triangle
/// (3, 1, m) and `right` that on (2, 3, m); edge 12 of either, which is bisected next, is opposite to m.
void bisect(int degree, const double* net, double* left, double* right) {
  double row[2 * max_degree];
  for (int k = 0; k <= degree; ++k) {
    const int n = degree - k;
    std::copy_n(net + row_start(degree, k), n + 1, row);
    for (int t = 0; t <= n; ++t) {
      left[row_start(degree, t) + n - t] = row[0];   // (i, j, k) = (n - t, t, k) becomes (k, n - t, t)
      right[row_start(degree, t) + k] = row[n - t];  // (i, j, k) = (t, n - t, k) becomes (n - t, k, t)
      for (int x = 0; x < n - t; ++x) row[x] = 0.5 * (row[x] + row[x + 1]);
    }
  }
}

/// Finds a lower bound of the least tau by bisection. The nets of N and S are given in rows.
class ShapeSearch {
 public:
  explicit ShapeSearch(const ElementForms& forms)
      : degree_(forms.degree), size_(index(forms.size())), error_(forms.error) {
    for (std::size_t n = 0; n < size_; ++n)
      greatest_ = std::max({greatest_, std::fabs(forms.jacobian[n]), std::fabs(forms.squares[n])});
  }

  double run(const double* jacobian, const double* squares) {
    for (const int corner : {0, degree_, static_cast<int>(size_) - 1}) see(jacobian[corner], squares[corner], error_);
    const double whole = lower_bound(jacobian, squares, 0);
    if (is_enough(whole)) return whole;
    // A stack of pieces, each with the nets of N and S. At every depth at most one sibling waits.
    thread_local std::vector<double> stack;
    stack.resize(2 * size_ * (greatest_depth + 3));
    int depths[greatest_depth + 3];
    double bounds[greatest_depth + 3];
    std::copy_n(jacobian, size_, stack.data());
    std::copy_n(squares, size_, stack.data() + size_);
    depths[0] = 0;
    bounds[0] = whole;
    double result = HUGE_VAL;
    for (int top = 0, count = 0; top >= 0; ++count) {
      if (is_enough(bounds[top]) || depths[top] == greatest_depth || count >= most_pieces) {
        result = std::min(result, bounds[top--]);
        continue;
      }
      const int depth = depths[top] + 1;
      double* parent = piece(stack, top);
      double *left = piece(stack, top + 1), *right = piece(stack, top + 2);
      for (const std::size_t form : {std::size_t{0}, size_}) bisect(degree_, parent + form, left + form, right + form);
      see(left[size_ - 1], left[2 * size_ - 1], error_at(depth));
      double first = lower_bound(left, left + size_, depth), second = lower_bound(right, right + size_, depth);
      if (first < second) {  // the poorer piece comes first, since it lowers the upper bound soonest
        std::swap_ranges(left, left + 2 * size_, right);
        std::swap(first, second);
      }
      std::copy_n(left, 2 * size_, parent);
      std::copy_n(right, 2 * size_, left);
      bounds[top] = first;
      bounds[top + 1] = second;
      depths[top] = depths[top + 1] = depth;
      ++top;
    }
    return result;
  }

 private:
  double* piece(std::vector<double>& stack, int n) const { return stack.data() + 2 * size_ * index(n); }
  /// The error bound of a coefficient at this depth: a bisection rounds each coefficient at most `degree` times.
  double error_at(int depth) const { return error_ + depth * degree_ * 0x1p-53 * greatest_; }
  /// True if a lower bound is close enough to the upper bound.
  bool is_enough(double bound) const {
    return bound >= upper_ - std::max(shape_relative_width * std::fabs(upper_), shape_absolute_width);
  }
  /// Takes a value of tau, with N = n and S = s, as an upper bound of the least tau.
  void see(double n, double s, double error) {
    if (s > error) upper_ = std::min(upper_, std::numbers::sqrt3 * n / s);
  }
  /// The greatest t with sqrt(3) n - t s >= 0 for all coefficients, where n and s are uncertain by the error. If some s
  /// may not be positive, -1: tau is never less.
  double lower_bound(const double* n, const double* s, int depth) const {
    const double error = error_at(depth);
    double least = 1;
    for (std::size_t i = 0; i < size_; ++i) {
      if (s[i] <= error) return -1;
      const double sure = n[i] - error;
      least = std::min(least, std::numbers::sqrt3 * sure / (sure >= 0 ? s[i] + error : s[i] - error));
    }
    return std::max(least, -1.0);
  }

  int degree_;
  std::size_t size_;
  double error_, greatest_ = 0;
  double upper_ = 1;  // upper bound of the least tau
};

}  // namespace

double curved_shape(const ElementForms& forms) {
  if (!forms.is_finite) return std::numeric_limits<double>::quiet_NaN();
  if (forms.is_point) return 0;
  const std::vector<int>& order = row_order(forms.degree);
  double jacobian[max_form_size], squares[max_form_size];
  for (std::size_t n = 0; n < order.size(); ++n) {
    jacobian[order[n]] = forms.jacobian[n];
    squares[order[n]] = forms.squares[n];
  }
  return ShapeSearch(forms).run(jacobian, squares);
}

double curved_shape(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  return curved_shape(forms);
}

}  // namespace pliant
