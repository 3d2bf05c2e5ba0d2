// lib/pliant/geometry/net_layout.cpp: the order of the control points of a Bézier triangle.
#include "pliant/geometry/net_layout.h"

#include <cassert>
#include <cstddef>

namespace pliant {

NetLayout::NetLayout(int degree) : degree_(degree) {
  const int p = degree;
  if (p == 0) {
    exponents_ = {{0, 0, 0}};
  } else {
    exponents_ = {{p, 0, 0}, {0, p, 0}, {0, 0, p}};
    for (int k = 1; k < p; ++k) exponents_.push_back({p - k, k, 0});
    for (int k = 1; k < p; ++k) exponents_.push_back({0, p - k, k});
    for (int k = 1; k < p; ++k) exponents_.push_back({k, 0, p - k});
    for (int i = p - 2; i >= 1; --i)
      for (int j = p - i - 1; j >= 1; --j) exponents_.push_back({i, j, p - i - j});
  }
  index_.assign(static_cast<std::size_t>((p + 1) * (p + 1)), -1);
  multinomial_.resize(exponents_.size());
  for (std::size_t n = 0; n < exponents_.size(); ++n) {
    const auto [i, j, k] = exponents_[n];
    index_[static_cast<std::size_t>(i * (p + 1) + j)] = static_cast<int>(n);
    double c = 1;  // (p choose i)(p - i choose j); every step is exact up to degree 34, and rounded once above that
    for (int m = 1; m <= i; ++m) c = c * (p - i + m) / m;
    for (int m = 1; m <= j; ++m) c = c * (k + m) / m;
    multinomial_[n] = c;
  }
}

const NetLayout& NetLayout::of(int degree) {
  static const std::vector<NetLayout> all = [] {
    std::vector<NetLayout> layouts;
    for (int p = 0; p <= max_net_degree; ++p) layouts.push_back(NetLayout(p));
    return layouts;
  }();
  assert(0 <= degree && degree <= max_net_degree);
  return all[static_cast<std::size_t>(degree)];
}

std::vector<int> nested_net_order(int degree) {
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<int> net;
  // The inner entries form a net of degree `inner`; all their exponents are at least `depth`.
  for (int inner = degree, depth = 0; inner >= 0; inner -= 3, ++depth) {
    if (inner == 0) {
      net.push_back(layout.index(depth, depth));
      break;
    }
    for (int index = 0; index < NetLayout::of(inner).first_interior(); ++index) {
      const auto& exponents = NetLayout::of(inner).exponents(index);
      net.push_back(layout.index(exponents[0] + depth, exponents[1] + depth));
    }
  }
  assert(static_cast<int>(net.size()) == layout.size());
  return net;
}

}  // namespace pliant
