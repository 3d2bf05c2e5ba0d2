// lib/pliant/geometry/spline/bspline_interpolate.cpp: Greville abscissae, interpolation by a banded solve.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

/// A matrix that is banded, except for its last `border` rows and columns, which may be full. On a closed curve the
/// band wraps round; the entries that wrap are put into the border.
class BorderedBand {
 public:
  BorderedBand(int size, int width, int border)
      : inner_(size - border),
        width_(width),
        border_(border),
        band_(count(inner_ * (2 * width + 1))),
        right_(count(inner_ * border)),
        below_(count(border * inner_width())),
        corner_(count(border * border)) {}

  /// Sets entry (i, j) of the band, or adds to entry (i, j) of the border, where several columns may wrap to one.
  void set(int i, int j, double value) {
    if (i < inner_ && j < inner_)
      band(i, j) = value;
    else if (i < inner_)
      right(i, j - inner_) += value;
    else if (j < inner_)
      below(i - inner_, j) += value;
    else
      corner_[count((i - inner_) * border_ + j - inner_)] += value;
  }

  /// Replaces b by the solution; false if a pivot vanishes. No pivoting in the band: collocation matrices of B-splines
  /// are totally positive, for which elimination in order is stable.
  bool solve(std::span<Point> b) {
    for (int k = 0; k < inner_; ++k) {
      const double pivot = band(k, k);
      if (!(std::fabs(pivot) > 1e-12)) return false;
      for (int i = k + 1; i <= std::min(k + width_, inner_ - 1); ++i) {
        const double factor = band(i, k) / pivot;
        if (factor == 0) continue;
        for (int j = k + 1; j <= std::min(k + width_, inner_ - 1); ++j) band(i, j) -= factor * band(k, j);
        for (int c = 0; c < border_; ++c) right(i, c) -= factor * right(k, c);
        b[count(i)] -= factor * b[count(k)];
      }
    }
    for (int i = inner_ - 1; i >= 0; --i) {
      const double pivot = band(i, i);
      for (int j = i + 1; j <= std::min(i + width_, inner_ - 1); ++j) {
        const double entry = band(i, j);
        if (entry == 0) continue;
        b[count(i)] -= entry * b[count(j)];
        for (int c = 0; c < border_; ++c) right(i, c) -= entry * right(j, c);
      }
      b[count(i)] = b[count(i)] / pivot;
      for (int c = 0; c < border_; ++c) right(i, c) /= pivot;
    }
    const auto edge = b.subspan(count(inner_));
    for (int r = 0; r < border_; ++r)
      for (int j = 0; j < inner_; ++j) {
        if (!near_end(j)) {
          j = inner_ - width_ - 1;
          continue;
        }
        const double entry = below(r, j);
        if (entry == 0) continue;
        edge[count(r)] -= entry * b[count(j)];
        for (int c = 0; c < border_; ++c) corner_[count(r * border_ + c)] -= entry * right(j, c);
      }
    if (!solve_corner(edge)) return false;
    for (int i = 0; i < inner_; ++i)
      for (int c = 0; c < border_; ++c) b[count(i)] -= right(i, c) * edge[count(c)];
    return true;
  }

 private:
  static std::size_t count(int i) { return static_cast<std::size_t>(i); }
  int inner_width() const { return std::min(2 * width_, inner_); }
  bool near_end(int j) const { return inner_ <= 2 * width_ || j < width_ || j >= inner_ - width_; }
  double& band(int i, int j) { return band_[count(i * (2 * width_ + 1) + j - i + width_)]; }
  double& right(int i, int c) { return right_[count(i * border_ + c)]; }
  /// The rows of the border are 0 except in the first and last columns of the band, so only those are stored.
  double& below(int r, int j) {
    const int at = inner_ <= 2 * width_ || j < width_ ? j : j - inner_ + 2 * width_;
    return below_[count(r * inner_width() + at)];
  }

  /// Solves for the unknowns of the border, by an LU decomposition with row exchanges.
  bool solve_corner(std::span<Point> b) {
    if (border_ == 0) return true;
    constexpr int most = 3 * (max_curve_degree - 1);
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, most, most>;
    using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor, most, 2>;
    const Eigen::PartialPivLU<Square> factors(Eigen::Map<const Square>(corner_.data(), border_, border_));
    if (!(factors.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-12)) return false;
    Eigen::Map<Pairs> unknown(&b[0].x, border_, 2);
    const Pairs known = unknown;
    unknown = factors.solve(known);
    return true;
  }

  int inner_, width_, border_;
  std::vector<double> band_, right_, below_, corner_;
};

}  // namespace

double BSpline::unreduced_greville(int i) const {
  // The mean is taken of offsets from the first of the knots, so that it is exact where all of them coincide.
  const double start = knot(i + 1);
  double sum = 0;
  for (int j = 2; j <= degree_; ++j) sum += knot(i + j) - start;
  return std::min(start + sum / degree_, knot(i + degree_));
}

std::vector<double> BSpline::greville() const {
  std::vector<double> result(points_.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    double g = unreduced_greville(static_cast<int>(i));
    while (closed_ && g >= last_parameter()) g = first_parameter() + (g - last_parameter());
    result[i] = g;
  }
  return result;
}

bool BSpline::interpolate(std::span<const Point> values) {
  const int p = degree_, n = static_cast<int>(points_.size()), width = p - 1;
  assert(values.size() == points_.size());
  const int border = !closed_ ? 0 : n > 3 * width ? width : n;
  BorderedBand matrix(n, width, border);
  std::array<double, max_curve_degree + 1> basis;
  for (int i = 0; i < n; ++i) {
    const double g = unreduced_greville(i);
    int k = i + 1;
    while (k < i + p && knot(k + 1) <= g) ++k;
    if (!closed_) k = std::clamp(k, p, n - 1);
    // Cox and de Boor: the p + 1 basis functions k - p .. k on span k.
    basis[0] = 1;
    for (int r = 1; r <= p; ++r) {
      double carried = 0;
      for (int j = 0; j < r; ++j) {
        const double high = knot(k + j + 1), low = knot(k + j + 1 - r);
        // Quotients are taken first: at a knot they are exactly 0 or 1, so that an abscissa at a knot of full
        // multiplicity makes a row of the identity.
        const double value = basis[static_cast<std::size_t>(j)], extent = high - low;
        basis[static_cast<std::size_t>(j)] = carried + (high - g) / extent * value;
        carried = (g - low) / extent * value;
      }
      basis[static_cast<std::size_t>(r)] = carried;
    }
    for (int j = 0; j <= p; ++j) {
      const int column = k - p + j;
      if (std::abs(column - i) > width) continue;  // the value is 0, because g lies between knots i + 1 and i + p
      matrix.set(i, closed_ ? (column % n + n) % n : column, basis[static_cast<std::size_t>(j)]);
    }
  }
  std::vector<Point> solution(values.begin(), values.end());
  if (!matrix.solve(solution)) return false;
  for (const Point& d : solution)
    if (!is_finite(d)) return false;
  points_ = std::move(solution);
  return true;
}

}  // namespace pliant
