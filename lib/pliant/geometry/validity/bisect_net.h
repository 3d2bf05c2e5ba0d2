// lib/pliant/geometry/validity/bisect_net.h: halving a triangle of Bernstein coefficients (private to this layer).
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "pliant/geometry/lattice.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

/// The indices of the three corners in lattice order.
constexpr std::array<int, 3> lattice_corners(int degree) {
  return {0, lattice_index(degree, 0), lattice_index(degree, degree)};
}

/// Newest-vertex bisection of a net in lattice order. With m the middle of edge 01, `left` is the net on (v0, v2, m)
/// and `right` the one on (v2, v1, m). Repeated, it makes pieces of only four shapes, whose diameter halves every
/// second time.
///
/// `Mean` says how two coefficients are averaged. Mean::add(a, b) replaces a by the mean of a and b, or by their sum if
/// nothing is to be divided; Mean::align(a, n) then multiplies a by 2^n, for the n sums that a did not take part in.
/// `row` has room for degree + 1 values.
template <class Mean, class T>
void bisect_net(int degree, const T* net, T* left, T* right, T* row) {
  for (int k = 0; k <= degree; ++k) {
    const int n = degree - k;
    for (int t = 0; t <= n; ++t) row[t] = net[lattice_index(t + k, k)];
    for (int t = 0; t <= n; ++t) {
      T& to_left = left[lattice_index(k + t, t)];
      T& to_right = right[lattice_index(n, t)];
      to_left = row[0];
      to_right = row[n - t];
      Mean::align(to_left, degree - t);
      Mean::align(to_right, degree - t);
      for (int x = 0; x < n - t; ++x) Mean::add(row[x], row[x + 1]);
    }
  }
}

template <class Mean, class T>
void bisect_net(int degree, const T* net, T* left, T* right, std::vector<T>& row) {
  row.resize(static_cast<std::size_t>(degree) + 1);
  bisect_net<Mean>(degree, net, left, right, row.data());
}

/// Which corner of the left or right half a corner of the parent is; -1 if it is none, or if there is none.
constexpr int corner_in_left(int corner) { return corner == 0 ? 0 : corner == 2 ? 1 : -1; }
constexpr int corner_in_right(int corner) { return corner == 1 ? 1 : corner == 2 ? 0 : -1; }

/// Means of doubles.
struct FloatingMean {
  static void add(double& a, double b) { a = 0.5 * (a + b); }
  static void align(double&, int) {}
};

}  // namespace pliant
