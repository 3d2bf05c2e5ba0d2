#include "pliant/geometry/shape_bounds.h"  // lib/pliant/geometry/shape_bounds.cpp: branch and bound on Bernstein ratios

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "pliant/geometry/bisect_net.h"
#include "pliant/geometry/jacobian_terms.h"
#include "pliant/geometry/quadratic_shape.h"

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }
constexpr double least_upper = 1e-6;  // below it the width is relative to this

/// One coefficient of sqrt(3) det J, and of |chi_2|^2 - chi_2.chi_3 + |chi_3|^2: tau is the first over the second.
struct Ratio {
  double determinant, square;
};
struct RatioMean {
  static void add(Ratio& a, const Ratio& b) {
    a = {0.5 * (a.determinant + b.determinant), 0.5 * (a.square + b.square)};
  }
  static void align(Ratio&, int) {}
};

struct Piece {
  double lower;
  std::size_t coefficients;  ///< where they begin
  std::array<Barycentric, 3> corners;
};

/// A power of two that brings the net's extent to about 1: squares neither overflow nor underflow.
double scale_of(std::span<const Point> net) {
  Box box;
  for (const Point& p : net) box.extend(p);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  if (!(extent > 0 && std::isfinite(extent))) return 1;
  if (extent > 0x1p-100 && extent < 0x1p100) return 1;
  int exponent = 0;
  std::frexp(extent, &exponent);
  return std::ldexp(1, -exponent);
}

/// Memory is reused from call to call.
class Enclosure {
 public:
  void begin(int degree, std::span<const Point> net) {
    degree_ = 2 * (degree - 1);
    size_ = at(net_size(degree_));
    pieces_.clear();
    upper_ = std::numeric_limits<double>::infinity();
    const double scale = scale_of(net);
    const JacobianTerms& terms = JacobianTerms::of(degree);
    std::array<Vector, max_partials> along_2, along_3;
    partial_differences(terms, net, along_2, along_3);
    for (std::size_t m = 0; m < terms.partials.size(); ++m) {
      along_2[m] *= scale;
      along_3[m] *= scale;
    }
    const std::vector<int>& order = lattice_order(degree_);
    coefficients_.assign(size_, {0, 0});
    double greatest = 0;
    for (const JacobianTerm& term : terms.terms) {
      const Vector &u = along_2[at(term.i)], &v = along_3[at(term.i)];
      const Vector &s = along_2[at(term.j)], &t = along_3[at(term.j)];
      Ratio& target = coefficients_[at(order[at(term.target)])];
      target.determinant += term.weight * std::numbers::sqrt3 * cross(u, t);
      target.square += term.weight * (dot(u, s) - 0.5 * (dot(u, t) + dot(v, s)) + dot(v, t));
      greatest = std::max(
          greatest, term.weight * (squared_length(u) + squared_length(v) + squared_length(s) + squared_length(t)));
    }
    error_ = 16 * static_cast<double>(size_) * std::numeric_limits<double>::epsilon() * greatest;
    add({0, 0, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  }

  ShapeBounds refine(double relative_width, int most_pieces) {
    for (int pieces = 1; pieces < most_pieces; ++pieces) {
      const double lower = pieces_.front().lower;
      if (size_ == 1 || upper_ - lower <= relative_width * std::max(std::fabs(upper_), least_upper)) break;
      std::pop_heap(pieces_.begin(), pieces_.end(), later);
      const Piece parent = pieces_.back();
      pieces_.pop_back();
      const std::size_t left = coefficients_.size(), right = left + size_;
      coefficients_.resize(right + size_);
      Ratio* all = coefficients_.data();
      bisect_net<RatioMean>(degree_, all + parent.coefficients, all + left, all + right, row_);
      const auto& [a, b, c] = parent.corners;
      const Barycentric middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
      add({0, left, {a, c, middle}});
      add({0, right, {c, b, middle}});
    }
    return {std::min(pieces_.front().lower, upper_), upper_, worst_};
  }

 private:
  static bool later(const Piece& a, const Piece& b) { return a.lower > b.lower; }

  void add(Piece piece) {
    const Ratio* first = coefficients_.data() + piece.coefficients;
    piece.lower = 1;
    for (std::size_t i = 0; i < size_; ++i) {
      const double square = first[i].square, determinant = first[i].determinant - error_;
      // tau >= -1 anyway: all that is known where a coefficient of the square is not positive.
      const double bound = square > error_ ? determinant / (determinant > 0 ? square + error_ : square - error_) : -1;
      piece.lower = std::min(piece.lower, std::max(bound, -1.0));
    }
    const auto corners = lattice_corners(degree_);
    for (std::size_t i = 0; i < 3; ++i) {
      const Ratio& value = first[corners[i]];
      const double tau = value.square > 0 ? value.determinant / value.square : 0;
      if (tau < upper_) {
        upper_ = tau;
        worst_ = piece.corners[i];
      }
    }
    pieces_.push_back(piece);
    std::push_heap(pieces_.begin(), pieces_.end(), later);
  }

  int degree_ = 0;
  std::size_t size_ = 1;
  std::vector<Ratio> coefficients_, row_;
  std::vector<Piece> pieces_;
  double error_ = 0;
  double upper_ = 0;
  Barycentric worst_{};
};

/// p = 2: numerator and denominator of tau are quadratic forms.
ShapeBounds least_quadratic_shape(std::span<const Point> net) {
  const double scale = scale_of(net);
  // Columns of T, up to a common factor, at the three corners of the linear net; T = J E^-1, E the map from the unit
  // right triangle to the equilateral one.
  std::array<Vector, 3> u{net[3] - net[0], net[1] - net[3], net[4] - net[5]};
  std::array<Vector, 3> w{net[5] - net[0], net[4] - net[3], net[2] - net[5]};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] *= scale;
    w[i] = std::numbers::inv_sqrt3 * (2 * scale * w[i] - u[i]);
    greatest = std::max(greatest, squared_length(u[i]) + squared_length(w[i]));
  }
  QuadraticForm determinant, square;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i == 2 ? 0 : i + 1;
    determinant[i] = 2 * cross(u[i], w[i]);
    square[i] = squared_length(u[i]) + squared_length(w[i]);
    determinant[3 + i] = cross(u[i], w[j]) + cross(u[j], w[i]);
    square[3 + i] = dot(u[i], u[j]) + dot(w[i], w[j]);
  }
  return least_ratio(determinant, square, 8 * std::numeric_limits<double>::epsilon() * greatest);
}

}  // namespace

ShapeBounds least_shape(int degree, std::span<const Point> net, double relative_width, int most_pieces) {
  assert(1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  net = net.first(at(net_size(degree)));
  if (degree == 2) return least_quadratic_shape(net);
  thread_local Enclosure enclosure;
  enclosure.begin(degree, net);
  return enclosure.refine(relative_width, most_pieces);
}

}  // namespace pliant
