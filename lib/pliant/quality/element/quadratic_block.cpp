// lib/pliant/quality/element/quadratic_block.cpp: the measures of quadratic elements, computed for two at a time.
#include "pliant/quality/element/quadratic_block.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <span>

#include "pliant/geometry/bernstein.h"
#include "pliant/quality/element/element_forms.h"

namespace pliant {
namespace {

/// A Pack holds a number of each of `width` elements, as a vector type of the compiler; on a machine without such
/// vectors it computes one element after the other. Since products and sums are not contracted, each element gets the
/// same bits as with single doubles.
constexpr std::size_t width = 2;
using Pack [[gnu::vector_size(width * sizeof(double))]] = double;
using Mask [[gnu::vector_size(width * sizeof(double))]] = std::int64_t;

inline Pack load(const double* from) {
  Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}
inline void store(const Pack& pack, double* to) { std::memcpy(to, &pack, sizeof pack); }
inline Pack least(const Pack& a, const Pack& b) { return b < a ? b : a; }
inline Pack most(const Pack& a, const Pack& b) { return a < b ? b : a; }
inline Pack masked(const Pack& a, std::int64_t bits) { return std::bit_cast<Pack>(std::bit_cast<Mask>(a) & bits); }
inline Pack absolute(const Pack& a) { return masked(a, 0x7fffffffffffffff); }
inline Pack root(const Pack& a) {
  Pack result;
  for (std::size_t k = 0; k < width; ++k) result[k] = std::sqrt(a[k]);
  return result;
}

struct PackVector {
  Pack x, y;
};
inline PackVector operator-(const PackVector& a, const PackVector& b) { return {a.x - b.x, a.y - b.y}; }
inline Pack dot(const PackVector& a, const PackVector& b) { return a.x * b.x + a.y * b.y; }
inline Pack cross(const PackVector& a, const PackVector& b) { return a.x * b.y - a.y * b.x; }
inline Pack length(const PackVector& a) { return root(dot(a, a)); }
inline PackVector choose(const Mask& which, const PackVector& a, const PackVector& b) {
  return {which ? a.x : b.x, which ? a.y : b.y};
}

/// triangle_shape of the triangle with sides u and v from its first corner, and w between their ends.
inline Pack shape_of(const PackVector& u, const PackVector& w, const PackVector& v) {
  return 4 * std::numbers::sqrt3 * (cross(u, v) / 2) / (dot(u, u) + dot(w, w) + dot(v, v));
}

/// Measures `width` elements by simple bounds. `settled` tells for which of them these are the bounds that the code for
/// single elements would find, without subdivision.
struct Elements {
  std::array<PackVector, 6> p;
  std::array<PackVector, 3> a, b;  // derivatives at the corners, along edges 12 and 13: sides of control triangles
  std::array<Pack, 6> jacobian, squares;
  Pack error;
  Mask settled;

  /// Elements with lengths whose squares could over- or underflow are left to the code that scales first.
  void differentiate() {
    a = {p[3] - p[0], p[1] - p[3], p[4] - p[5]};
    b = {p[5] - p[0], p[4] - p[3], p[2] - p[5]};
    Pack greatest{};
    for (std::size_t i = 0; i < 3; ++i)
      for (const PackVector& v : {a[i], b[i]}) greatest = most(greatest, most(absolute(v.x), absolute(v.y)));
    settled = (greatest >= 0x1p-200) & (greatest <= 0x1p200);
    const Pack unit = masked(greatest, 0x7ff0000000000000);
    error = quadratic_error * unit * unit;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      jacobian[i] = 4 * cross(a[i], b[i]);
      squares[i] = 4 * (dot(a[i], a[i] - b[i]) + dot(b[i], b[i]));
      jacobian[3 + i] = 2 * (cross(a[i], b[j]) + cross(a[j], b[i]));
      squares[3 + i] = 2 * (2 * dot(a[i], a[j]) - dot(a[i], b[j]) - dot(a[j], b[i]) + 2 * dot(b[i], b[j]));
    }
  }

  void measure_jacobian(QuadraticBlock& block, std::size_t l, double jacobian_width) {
    const Pack corner_least = least(least(jacobian[0], jacobian[1]), jacobian[2]);
    const Pack corner_most = most(most(jacobian[0], jacobian[1]), jacobian[2]);
    const Pack all_least = least(least(least(corner_least, jacobian[3]), jacobian[4]), jacobian[5]);
    const Pack all_most = most(most(most(corner_most, jacobian[3]), jacobian[4]), jacobian[5]);
    const Pack accepted = jacobian_width * most(absolute(all_least), absolute(all_most));
    settled &= (corner_least - all_least <= accepted) & (all_most - corner_most <= accepted);
    settled &= all_least > 4 * error;  // this also proves that the element is valid
    const Pack lower = all_least - error, upper = all_most + error;
    store(lower, &block.jacobian[l]);
    store(upper, &block.jacobian_max[l]);
    store(lower / most(absolute(lower), absolute(upper)), &block.scaled_jacobian[l]);

    Pack mean{};
    for (const Pack& c : jacobian) mean += c;
    mean /= 6;
    store(mean / 2, &block.area[l]);
    const std::span<const double> mass = mass_matrix(2);
    std::array<Pack, 6> excess;
    for (std::size_t i = 0; i < 6; ++i) excess[i] = jacobian[i] / mean - 1;
    Pack sum{};
    for (std::size_t i = 0; i < 6; ++i) {
      Pack row{};
      for (std::size_t j = 0; j < 6; ++j) row += mass[6 * i + j] * excess[j];
      sum += row * excess[i];
    }
    store(1 + 2 * most(sum, Pack{}), &block.distortion[l]);
  }

  void measure_shape(QuadraticBlock& block, std::size_t l) {
    Pack upper = 1 + Pack{}, lower = 1 + Pack{};
    for (std::size_t i = 0; i < 3; ++i) upper = least(upper, std::numbers::sqrt3 * jacobian[i] / squares[i]);
    for (std::size_t i = 0; i < 6; ++i) {
      lower = least(lower, std::numbers::sqrt3 * (jacobian[i] - error) / (squares[i] + error));
      settled &= squares[i] > error;
    }
    settled &= lower >= upper - most(shape_relative_width * absolute(upper), shape_absolute_width + Pack{});
    store(lower, &block.shape[l]);
    Pack control = least(1 + Pack{}, shape_of(a[0], p[5] - p[3], b[0]));
    control = least(control, shape_of(a[1], p[4] - p[1], b[1]));
    control = least(control, shape_of(a[2], p[2] - p[4], b[2]));
    store(least(control, shape_of(p[5] - p[4], p[3] - p[5], p[3] - p[4])), &block.control_tau[l]);
  }

  /// The logical triangle: its shape, and its least angle, which is opposite to the shortest side.
  void measure_logical(QuadraticBlock& block, std::size_t l) const {
    const PackVector u = p[1] - p[0], v = p[2] - p[0], w = p[2] - p[1];
    store(shape_of(u, w, v), &block.logical_tau[l]);
    const Pack uu = dot(u, u), ww = dot(w, w), vv = dot(v, v);
    const Mask is_u = (uu <= ww) & (uu <= vv), is_w = ww <= vv;
    const PackVector g = choose(is_u, p[0] - p[2], choose(is_w, u, w));
    const PackVector h = choose(is_u, p[1] - p[2], choose(is_w, v, p[0] - p[1]));
    store(absolute(cross(g, h)), &block.angle_sine[l]);
    store(dot(g, h), &block.angle_cosine[l]);
  }

  /// Turning and length of the edges. (dot, |cross|) of the two legs of an edge is a vector in the upper half-plane,
  /// and the leftmost of the three belongs to the largest angle.
  void measure_edges(QuadraticBlock& block, std::size_t l) {
    PackVector largest{1 + Pack{}, Pack{}};
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t f = (e + 1) % 3;
      const PackVector first = p[3 + e] - p[e], second = p[f] - p[3 + e];
      PackVector turn{dot(first, second), absolute(cross(first, second))};
      const Pack scale = 1 / (absolute(turn.x) + turn.y);
      turn.x *= scale;
      turn.y *= scale;
      settled &= turn.x > 0;
      largest = choose(cross(largest, turn) > 0, turn, largest);
      const Pack chord = length(p[f] - p[e]), legs = length(first) + length(second);
      settled &= legs - chord <= 1e-14 * legs;
      store(chord, &block.edge_length[e][l]);
    }
    store(largest.y, &block.turn_sine[l]);
    store(largest.x, &block.turn_cosine[l]);
  }
};

}  // namespace

void measure_block(QuadraticBlock& block, double jacobian_width) {
  static_assert(QuadraticBlock::size % width == 0);
  for (std::size_t l = 0; l < QuadraticBlock::size; l += width) {
    Elements elements;
    for (std::size_t k = 0; k < 6; ++k) elements.p[k] = {load(&block.x[k][l]), load(&block.y[k][l])};
    elements.differentiate();
    elements.measure_jacobian(block, l, jacobian_width);
    elements.measure_shape(block, l);
    elements.measure_logical(block, l);
    elements.measure_edges(block, l);
    for (std::size_t k = 0; k < width; ++k) block.settled[l + k] = elements.settled[k] != 0;
  }
}

}  // namespace pliant
