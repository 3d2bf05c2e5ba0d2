// lib/pliant/geometry/validity/bisect_net.h: halving a triangle of Bernstein coefficients (private to this layer).
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "pliant/geometry/lattice.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

/// The corners' places in lattice order.
constexpr std::array<int, 3> lattice_corners(int degree) {
  return {0, lattice_index(degree, 0), lattice_index(degree, degree)};
}

/// Newest-vertex bisection in lattice order: with m the middle of edge 01, `left` is on (v0, v2, m) and `right` on
/// (v2, v1, m). Repeated, it makes pieces of only four shapes, whose diameter halves every second time.
///
/// `Mean` says how two coefficients are averaged: Mean::add(a, b) makes a the mean of a and b, perhaps without
/// dividing, and Mean::align(a, n) then makes up for n halvings that a did not take part in. `row` has room for
/// degree + 1 values.
template <class Mean, class T>
void bisect_net(int degree, const T* net, T* left, T* right, T* row) {
  for (int k = 0; k <= degree; ++k) {
    const int n = degree - k;
    for (int t = 0; t <= n; ++t) row[t] = net[lattice_index(t + k, k)];
    for (int t = 0; t <= n; ++t) {
      T& of_left = left[lattice_index(k + t, t)];
      T& of_right = right[lattice_index(n, t)];
      of_left = row[0];
      of_right = row[n - t];
      Mean::align(of_left, degree - t);
      Mean::align(of_right, degree - t);
      for (int x = 0; x < n - t; ++x) Mean::add(row[x], row[x + 1]);
    }
  }
}

template <class Mean, class T>
void bisect_net(int degree, const T* net, T* left, T* right, std::vector<T>& row) {
  row.resize(static_cast<std::size_t>(degree) + 1);
  bisect_net<Mean>(degree, net, left, right, row.data());
}

/// Where a marked corner (0, 1, 2, or -1: none) of the parent stands in the two children.
constexpr int corner_in_left(int corner) { return corner == 0 ? 0 : corner == 2 ? 1 : -1; }
constexpr int corner_in_right(int corner) { return corner == 1 ? 1 : corner == 2 ? 0 : -1; }

struct FloatingMean {
  static void add(double& a, double b) { a = 0.5 * (a + b); }
  static void align(double&, int) {}
};

}  // namespace pliant
