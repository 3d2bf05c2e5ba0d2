// lib/pliant/geometry/placement/shape_bounds.cpp: branch and bound on Bernstein ratios.
#include "pliant/geometry/placement/shape_bounds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/placement/quadratic_shape.h"
#include "pliant/geometry/validity/bisect_net.h"
#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {
namespace {

constexpr double least_width = 1e-11;  // bounds this close to each other are always close enough

/// One Bernstein coefficient of sqrt(3) det J, and one of |chi_2|^2 - chi_2.chi_3 + |chi_3|^2. tau is the ratio of the
/// two polynomials.
struct Ratio {
  double determinant, square;
};
/// How bisect_net takes means of such pairs.
struct RatioMean {
  static void add(Ratio& a, const Ratio& b) {
    a = {0.5 * (a.determinant + b.determinant), 0.5 * (a.square + b.square)};
  }
  static void align(Ratio&, int) {}
};

struct DomainPiece {
  double lower;              ///< a lower bound of tau on the piece
  std::size_t coefficients;  ///< the index of its first coefficient
  std::array<Barycentric, 3> corners;
};

/// A power of two by which the net is scaled so that squares neither overflow nor underflow; mostly 1.
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

/// The pieces of an element in a heap, the one with the least bound of tau on top. Memory is reused from call to call.
class Enclosure {
 public:
  void begin(int degree, std::span<const Point> net) {
    degree_ = 2 * (degree - 1);
    size_ = index(net_size(degree_));
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
      const Vector &u = along_2[index(term.i)], &v = along_3[index(term.i)];
      const Vector &s = along_2[index(term.j)], &t = along_3[index(term.j)];
      Ratio& target = coefficients_[index(order[index(term.target)])];
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
      if (size_ == 1 || upper_ - lower <= std::max(relative_width * std::fabs(upper_), least_width)) break;
      std::pop_heap(pieces_.begin(), pieces_.end(), later);
      const DomainPiece parent = pieces_.back();
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
  static bool later(const DomainPiece& a, const DomainPiece& b) { return a.lower > b.lower; }

  void add(DomainPiece piece) {
    const Ratio* first = coefficients_.data() + piece.coefficients;
    piece.lower = 1;
    for (std::size_t i = 0; i < size_; ++i) {
      const double square = first[i].square, determinant = first[i].determinant - error_;
      // tau is at least -1 everywhere. If a coefficient of the square is not positive, nothing more is known.
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
  std::vector<DomainPiece> pieces_;
  double error_ = 0;
  double upper_ = 0;
  Barycentric worst_{};
};

/// A piece of an element with p = 2: the two columns of T, up to a common factor, at its corners. Between the corners
/// they are linear.
struct LinearPiece {
  std::array<Vector, 3> u, w;
  std::array<Barycentric, 3> corners;
  ShapeBounds bounds;

  /// Bounds tau, whose numerator and denominator are quadratic forms. `greatest` is the greatest |T|^2 at a corner of
  /// the whole element.
  void enclose(double greatest) {
    QuadraticForm determinant, square;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = i == 2 ? 0 : i + 1;
      determinant[i] = 2 * cross(u[i], w[i]);
      square[i] = squared_length(u[i]) + squared_length(w[i]);
      determinant[3 + i] = cross(u[i], w[j]) + cross(u[j], w[i]);
      square[3 + i] = dot(u[i], u[j]) + dot(w[i], w[j]);
    }
    const double most = std::max({square[0], square[1], square[2]});
    bounds = least_ratio(determinant, square,
                         8 * std::numeric_limits<double>::epsilon() * std::sqrt(most * std::max(most, greatest)));
    // Where T nearly vanishes, tau is more precise when it is computed from T than from the forms.
    const Barycentric local = bounds.worst;
    Vector a, b;
    bounds.worst = {};
    for (std::size_t i = 0; i < 3; ++i) {
      a += local[i] * u[i];
      b += local[i] * w[i];
      for (std::size_t c = 0; c < 3; ++c) bounds.worst[c] += local[i] * corners[i][c];
    }
    const double below = squared_length(a) + squared_length(b);
    if (below > 0) bounds.upper = 2 * cross(a, b) / below;
    bounds.lower = std::min(bounds.lower, bounds.upper);
  }

  /// The half at one end of edge 01, its corners in the order of newest-vertex bisection.
  LinearPiece half(std::size_t end) const {
    const auto middle = [](const auto& ends) { return 0.5 * (ends[0] + ends[1]); };
    const std::size_t first = end == 0 ? 0 : 2, second = end == 0 ? 2 : 1;
    const Barycentric &x = corners[0], &y = corners[1];
    return {{u[first], u[second], middle(u)},
            {w[first], w[second], middle(w)},
            {corners[first], corners[second], {(x[0] + y[0]) / 2, (x[1] + y[1]) / 2, (x[2] + y[2]) / 2}},
            {}};
  }
};

ShapeBounds least_quadratic_shape(std::span<const Point> net, double relative_width, int most_pieces) {
  const double scale = scale_of(net);
  // T = J E^-1, where E is the map from the unit right triangle to the equilateral one.
  LinearPiece whole{{net[3] - net[0], net[1] - net[3], net[4] - net[5]},
                    {net[5] - net[0], net[4] - net[3], net[2] - net[5]},
                    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                    {}};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    whole.u[i] *= scale;
    whole.w[i] = std::numbers::inv_sqrt3 * (2 * scale * whole.w[i] - whole.u[i]);
    greatest = std::max(greatest, squared_length(whole.u[i]) + squared_length(whole.w[i]));
  }
  whole.enclose(greatest);
  ShapeBounds bounds = whole.bounds;
  const auto is_enough = [&] {
    return bounds.upper - bounds.lower <= std::max(relative_width * std::fabs(bounds.upper), least_width);
  };
  if (is_enough()) return bounds;
  thread_local std::vector<LinearPiece> pieces;
  const auto later = [](const LinearPiece& a, const LinearPiece& b) { return a.bounds.lower > b.bounds.lower; };
  pieces.assign(1, whole);
  for (int count = 1; count < most_pieces && !is_enough(); ++count) {
    std::pop_heap(pieces.begin(), pieces.end(), later);
    const LinearPiece parent = pieces.back();
    pieces.pop_back();
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      pieces.push_back(parent.half(end));
      pieces.back().enclose(greatest);
      if (const ShapeBounds& found = pieces.back().bounds; found.upper < bounds.upper) {
        bounds.upper = found.upper;
        bounds.worst = found.worst;
      }
      std::push_heap(pieces.begin(), pieces.end(), later);
    }
    bounds.lower = std::min(pieces.front().bounds.lower, bounds.upper);
  }
  return bounds;
}

}  // namespace

ShapeBounds least_shape(int degree, std::span<const Point> net, double relative_width, int most_pieces) {
  assert(1 <= degree && degree <= max_degree && net.size() >= index(net_size(degree)));
  net = net.first(index(net_size(degree)));
  if (degree == 2) return least_quadratic_shape(net, relative_width, most_pieces);
  thread_local Enclosure enclosure;
  enclosure.begin(degree, net);
  return enclosure.refine(relative_width, most_pieces);
}

}  // namespace pliant
