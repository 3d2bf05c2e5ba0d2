// lib/pliant/ops/refit/third_derivatives.cpp: third differences of nets, and their tables at nodes.
#include "pliant/ops/refit/third_derivatives.h"

#include <mutex>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/node_basis.h"

namespace pliant {

ThirdsInPlane::ThirdsInPlane(const Point& a, const Point& b, const Point& c) {
  const double twice_area = cross(b - a, c - a);
  const Vector g = perpendicular(a - c) / twice_area, h = perpendicular(b - a) / twice_area;  // gradients of xi2, xi3
  rows_ = {Thirds{g.x * g.x * g.x, 3 * g.x * g.x * h.x, 3 * g.x * h.x * h.x, h.x * h.x * h.x},
           Thirds{g.x * g.x * g.y, g.x * g.x * h.y + 2 * g.x * g.y * h.x, 2 * g.x * h.x * h.y + g.y * h.x * h.x,
                  h.x * h.x * h.y},
           Thirds{g.x * g.y * g.y, 2 * g.x * g.y * h.y + g.y * g.y * h.x, g.x * h.y * h.y + 2 * g.y * h.x * h.y,
                  h.x * h.y * h.y},
           Thirds{g.y * g.y * g.y, 3 * g.y * g.y * h.y, 3 * g.y * h.y * h.y, h.y * h.y * h.y}};
}

Thirds ThirdsInPlane::operator()(const Thirds& t) const {
  Thirds thirds;
  for (std::size_t m = 0; m < 4; ++m)
    thirds[m] = rows_[m][0] * t[0] + rows_[m][1] * t[1] + rows_[m][2] * t[2] + rows_[m][3] * t[3];
  return thirds;
}

void third_differences(int degree, std::span<const double> net, std::span<double> out) {
  const NetLayout &layout = NetLayout::of(degree), &below = NetLayout::of(degree - 3);
  const double factor = degree * (degree - 1.0) * (degree - 2.0);
  const std::size_t n = index(below.size());
  for (int q = 0; q < below.size(); ++q) {
    const auto& exponents = below.exponents(q);
    for (std::size_t component = 0; component < 2; ++component) {
      const auto at = [&](int along_2, int along_3) {
        return net[2 * index(layout.index(exponents[0] + 3 - along_2 - along_3, exponents[1] + along_2)) + component];
      };
      const double first = at(0, 0), second = at(1, 0), third = at(0, 1), mixed = at(1, 1);
      const Thirds thirds{at(3, 0) - 3 * at(2, 0) + 3 * second - first,
                          (at(2, 1) - 2 * mixed + third) - (at(2, 0) - 2 * second + first),
                          (at(1, 2) - 2 * mixed + second) - (at(0, 2) - 2 * third + first),
                          at(0, 3) - 3 * at(0, 2) + 3 * third - first};
      for (std::size_t m = 0; m < 4; ++m) out[(2 * m + component) * n + index(q)] = factor * thirds[m];
    }
  }
}

namespace {

std::vector<Thirds> build(int degree) {
  const NodeBasis& table = node_basis(degree);
  const std::size_t n = index(net_size(degree)), lower = index(net_size(degree - 3));
  std::vector<Thirds> thirds(table.nodes.size() * n);
  std::vector<double> net(2 * n), differences(8 * lower), basis(lower);
  for (std::size_t k = 0; k < n; ++k) {
    net.assign(2 * n, 0.0);
    net[2 * k] = 1;
    third_differences(degree, net, differences);
    for (std::size_t node = 0; node < table.nodes.size(); ++node) {
      bernstein_basis(degree - 3, table.nodes[node].xi, basis);
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t q = 0; q < lower; ++q) thirds[node * n + k][m] += basis[q] * differences[2 * m * lower + q];
    }
  }
  return thirds;
}

}  // namespace

const std::vector<Thirds>& thirds_at_nodes(int degree) {
  static std::array<std::once_flag, max_degree + 1> built;
  static std::array<std::vector<Thirds>, max_degree + 1> tables;
  std::call_once(built[index(degree)], [degree] { tables[index(degree)] = build(degree); });
  return tables[index(degree)];
}

}  // namespace pliant
