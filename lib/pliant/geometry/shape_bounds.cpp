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

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }

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

class Enclosure {
 public:
  Enclosure(int degree, std::span<const Point> net) : degree_(2 * (degree - 1)), size_(at(net_size(degree_))) {
    Box box;
    for (const Point& p : net) box.extend(p);
    const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    int exponent = 0;
    if (extent > 0 && std::isfinite(extent)) std::frexp(extent, &exponent);
    const double scale = std::ldexp(1, -exponent);  // squares neither overflow nor underflow

    const JacobianTerms& terms = JacobianTerms::of(degree);
    std::array<Vector, max_partials> along_2, along_3;
    partial_differences(terms, net, along_2, along_3);
    for (std::size_t m = 0; m < terms.partials.size(); ++m) {
      along_2[m] *= scale;
      along_3[m] *= scale;
    }
    const auto order = lattice_order(degree_);
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
      if (size_ == 1 || upper_ - lower <= std::max(relative_width * std::fabs(upper_), 1e-6)) break;
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

  int degree_;
  std::size_t size_;
  std::vector<Ratio> coefficients_, row_;
  std::vector<Piece> pieces_;
  double error_ = 0;
  double upper_ = std::numeric_limits<double>::infinity();
  Barycentric worst_{};
};

}  // namespace

ShapeBounds least_shape(int degree, std::span<const Point> net, double relative_width, int most_pieces) {
  assert(1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  return Enclosure(degree, net.first(at(net_size(degree)))).refine(relative_width, most_pieces);
}

}  // namespace pliant
