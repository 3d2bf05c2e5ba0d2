// lib/pliant/geometry/control_net.cpp: evaluation, splitting, elevation.
#include "pliant/geometry/control_net.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "pliant/geometry/lattice.h"

namespace pliant {
namespace {

/// Scratch rows, on the stack for the sizes for which the header promises that nothing is allocated.
class WorkRows {
 public:
  WorkRows(int rows, int width) {
    const std::size_t size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(width);
    if (size > local_.size()) heap_.resize(size);
    data_ = size > local_.size() ? heap_.data() : local_.data();
  }
  WorkRows(const WorkRows&) = delete;
  WorkRows& operator=(const WorkRows&) = delete;
  double* data() { return data_; }

 private:
  std::array<double, net_size(max_degree) * 16> local_;
  std::vector<double> heap_;
  double* data_;
};

[[maybe_unused]] bool has_size(std::size_t size, int rows, int width) {
  return size >= static_cast<std::size_t>(rows) * static_cast<std::size_t>(width);
}

/// The corner (0, 1 or 2) that w is exactly, or -1 if w is no corner.
int corner_of(const Barycentric& w) {
  if (w[0] == 1 && w[1] == 0 && w[2] == 0) return 0;
  if (w[1] == 1 && w[0] == 0 && w[2] == 0) return 1;
  if (w[2] == 1 && w[0] == 0 && w[1] == 0) return 2;
  return -1;
}

/// out = w1 a + w2 b + w3 c. If w is a corner, `out` is a copy of that corner's row, without arithmetic. `out` may be
/// the same memory as `a`.
void combine(const Barycentric& w, int corner, int width, const double* a, const double* b, const double* c,
             double* out) {
  if (corner >= 0) {
    const double* kept = corner == 0 ? a : corner == 1 ? b : c;
    if (kept != out) std::copy_n(kept, width, out);
    return;
  }
  for (int x = 0; x < width; ++x) out[x] = w[0] * a[x] + w[1] * b[x] + w[2] * c[x];
}

/// One step of de Casteljau, in place: a net of degree `degree`, in lattice order, becomes a net of degree - 1.
void step(int degree, int width, const Barycentric& w, double* rows) {
  const int corner = corner_of(w);
  if (corner == 0) return;  // the first rows are the result already
  double* out = rows;
  for (int r = 0; r < degree; ++r) {
    for (int k = 0; k <= r; ++k, out += width) {
      const double* below = out + (r + 1) * width;
      combine(w, corner, width, out, below, below + width, out);
    }
  }
}

void to_lattice(int degree, int width, std::span<const double> net, double* rows) {
  const double* from = net.data();
  for (const int to : lattice_order(degree)) {
    std::copy_n(from, width, rows + to * width);
    from += width;
  }
}

/// For p = 2: the rows that the first step of de Casteljau combines, with weights xi1, xi2, xi3, to each row of
/// degree 1.
constexpr int linear_nets[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/// For p = 2: the first step of de Casteljau, which makes three rows. It needs no lattice order.
void step_quadratic(int width, const double* net, const Barycentric& w, double* linear) {
  const int corner = corner_of(w);
  for (int n = 0; n < 3; ++n) {
    const auto& from = linear_nets[n];
    combine(w, corner, width, net + from[0] * width, net + from[1] * width, net + from[2] * width, linear + n * width);
  }
}

/// sub_net for p = 2, the degree of most meshes, in 15 combinations of three rows.
void sub_quadratic(int width, const double* net, const std::array<const Barycentric*, 3>& corners, double* out) {
  constexpr int targets[3][3] = {{0, 3, 5}, {-1, 1, 4}, {-1, -1, 2}};  // the row that corners m <= n determine
  WorkRows work(3, width);
  double* linear = work.data();
  for (int m = 0; m < 3; ++m) {
    step_quadratic(width, net, *corners[static_cast<std::size_t>(m)], linear);
    for (int n = m; n < 3; ++n) {
      const Barycentric& v = *corners[static_cast<std::size_t>(n)];
      combine(v, corner_of(v), width, linear, linear + width, linear + 2 * width, out + targets[m][n] * width);
    }
  }
}

}  // namespace

void evaluate_net(int degree, int width, std::span<const double> net, const Barycentric& xi, std::span<double> value) {
  assert(has_size(net.size(), net_size(degree), width) && has_size(value.size(), 1, width));
  WorkRows work(net_size(degree), width);
  double* rows = work.data();
  if (degree == 2) {
    step_quadratic(width, net.data(), xi, rows);
    return combine(xi, corner_of(xi), width, rows, rows + width, rows + 2 * width, value.data());
  }
  to_lattice(degree, width, net, rows);
  for (int d = degree; d > 0; --d) step(d, width, xi, rows);
  std::copy_n(rows, width, value.data());
}

void evaluate_net(int degree, int width, std::span<const double> net, const Barycentric& xi, std::span<double> value,
                  std::span<double> along_2, std::span<double> along_3) {
  assert(has_size(net.size(), net_size(degree), width) && has_size(value.size(), 1, width));
  assert(has_size(along_2.size(), 1, width) && has_size(along_3.size(), 1, width));
  if (degree == 0) {
    std::copy_n(net.data(), width, value.data());
    std::fill_n(along_2.data(), width, 0.0);
    std::fill_n(along_3.data(), width, 0.0);
    return;
  }
  WorkRows work(net_size(degree), width);
  double* rows = work.data();
  if (degree == 2) {
    step_quadratic(width, net.data(), xi, rows);
  } else {
    to_lattice(degree, width, net, rows);
    for (int d = degree; d > 1; --d) step(d, width, xi, rows);
  }
  for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
    along_2[x] = degree * (rows[width + static_cast<int>(x)] - rows[x]);
    along_3[x] = degree * (rows[2 * width + static_cast<int>(x)] - rows[x]);
  }
  step(1, width, xi, rows);
  std::copy_n(rows, width, value.data());
}

void sub_net(int degree, int width, std::span<const double> net, const Barycentric& a, const Barycentric& b,
             const Barycentric& c, std::span<double> out) {
  assert(has_size(net.size(), net_size(degree), width) && has_size(out.size(), net_size(degree), width));
  assert(net.data() != out.data());
  if (degree == 2) return sub_quadratic(width, net.data(), {&a, &b, &c}, out.data());
  // Row (i, j, k) is the blossom with a as i of its arguments, b as j of them and c as k.
  const NetLayout& layout = NetLayout::of(degree);
  WorkRows after_a(net_size(degree), width);
  WorkRows after_b(net_size(degree), width);
  WorkRows after_c(net_size(degree), width);
  to_lattice(degree, width, net, after_a.data());
  for (int i = 0; i <= degree; ++i) {
    std::copy_n(after_a.data(), net_size(degree - i) * width, after_b.data());
    for (int j = 0; i + j <= degree; ++j) {
      const int k = degree - i - j;
      std::copy_n(after_b.data(), net_size(k) * width, after_c.data());
      for (int d = k; d > 0; --d) step(d, width, c, after_c.data());
      std::copy_n(after_c.data(), width, out.data() + layout.index(i, j) * width);
      if (k > 0) step(k, width, b, after_b.data());
    }
    if (i < degree) step(degree - i, width, a, after_a.data());
  }
}

void split_polygon(int degree, int width, std::span<const double> polygon, double s, std::span<double> left,
                   std::span<double> right) {
  assert(has_size(polygon.size(), degree + 1, width));
  assert(has_size(left.size(), degree + 1, width) && has_size(right.size(), degree + 1, width));
  WorkRows work(degree + 1, width);
  double* rows = work.data();
  std::copy_n(polygon.data(), (degree + 1) * width, rows);
  for (int d = degree; d >= 0; --d) {
    std::copy_n(rows, width, left.data() + (degree - d) * width);
    std::copy_n(rows + d * width, width, right.data() + d * width);
    for (int x = 0; x < d * width; ++x) rows[x] = (1 - s) * rows[x] + s * rows[x + width];
  }
}

void evaluate_polygon(int degree, int width, std::span<const double> polygon, double s, std::span<double> value) {
  assert(has_size(polygon.size(), degree + 1, width) && has_size(value.size(), 1, width));
  if (s == 0 || s == 1) {
    std::copy_n(polygon.data() + (s == 0 ? 0 : degree * width), width, value.data());
    return;
  }
  WorkRows work(degree + 1, width);
  double* rows = work.data();
  std::copy_n(polygon.data(), (degree + 1) * width, rows);
  for (int d = degree; d > 0; --d)
    for (int x = 0; x < d * width; ++x) rows[x] = (1 - s) * rows[x] + s * rows[x + width];
  std::copy_n(rows, width, value.data());
}

void elevate_net(int degree, int width, std::span<const double> net, std::span<double> out) {
  assert(has_size(net.size(), net_size(degree), width) && has_size(out.size(), net_size(degree + 1), width));
  assert(net.data() != out.data());
  const NetLayout& low = NetLayout::of(degree);
  const NetLayout& high = NetLayout::of(degree + 1);
  for (int n = 0; n < high.size(); ++n) {
    double* to = out.data() + n * width;
    if (n < 3) {
      std::copy_n(net.data() + (degree == 0 ? 0 : n * width), width, to);
      continue;
    }
    const auto [i, j, k] = high.exponents(n);
    const int from[3] = {i > 0 ? low.index(i - 1, j) : -1, j > 0 ? low.index(i, j - 1) : -1,
                         k > 0 ? low.index(i, j) : -1};
    const int weight[3] = {i, j, k};
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int m = 0; m < 3; ++m)
        if (from[m] >= 0) sum += weight[m] * net[static_cast<std::size_t>(from[m] * width + x)];
      to[x] = sum / (degree + 1);
    }
  }
}

void elevate_polygon(int degree, int width, std::span<const double> polygon, std::span<double> out) {
  assert(has_size(polygon.size(), degree + 1, width) && has_size(out.size(), degree + 2, width));
  assert(polygon.data() != out.data());
  std::copy_n(polygon.data(), width, out.data());
  for (int k = 1; k <= degree; ++k) {
    const double* before = polygon.data() + (k - 1) * width;
    double* to = out.data() + k * width;
    for (int x = 0; x < width; ++x) to[x] = (k * before[x] + (degree + 1 - k) * before[x + width]) / (degree + 1);
  }
  std::copy_n(polygon.data() + degree * width, width, out.data() + (degree + 1) * width);
}

}  // namespace pliant
