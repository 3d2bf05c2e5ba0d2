// lib/pliant/fem/solve/sparse_ldlt.cpp: supernodes take over, one after the other, what those before them eliminated.
#include "pliant/fem/solve/sparse_ldlt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/fem/solve/dense_panel.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// So many columns of a panel are eliminated one by one, before the columns right of them are updated at once.
constexpr int block_width = 8;
/// Pivots below this, on a diagonal of about 1, are looked at: is the matrix singular up to rounding?
constexpr double small_pivot = 1e-8;
/// Those below this, of the wrong sign or 0, are rounding.
constexpr double negligible_pivot = 1e-11;
/// | A z | of a vector that A should map to 0, in units of the last place of |A||z|.
constexpr double singular_rounding = 64 * 0x1p-52;

}  // namespace

std::optional<SparseLdlt::Fault> SparseLdlt::factor(const CsrMatrix& a, std::vector<double> scaling,
                                                    std::span<const signed char> signs, std::span<const double> shift) {
  scaling_ = std::move(scaling);
  PermutedLower lower;
  {
    Elimination elimination = order_by_minimum_degree(a);
    lower = permute(a, scaling_, elimination.places);
    supernodes_ = find_supernodes(elimination, lower);
    order_ = std::move(elimination.order);
  }
  if (!shift.empty())
    for (std::size_t k = 0; k < order_.size(); ++k) lower.diagonal[k] += shift[index(order_[k])];
  assemble(lower);

  const std::size_t count = index(supernodes_.size());
  // The supernodes that have rows among the columns of s are in the list that starts at waiting[s]; `done` rows of each
  // are dealt with.
  std::vector<int> waiting(count, -1), next(count, -1), done(count, 0), places(order_.size(), 0);
  std::vector<double> product, weighted;
  for (int s = 0; s < supernodes_.size(); ++s) {
    const int end = supernodes_.firsts[index(s) + 1];
    for (int k = 0; k < height(s); ++k) places[index(rows(s)[k])] = k;
    const auto wait = [&](int d) {
      if (done[index(d)] == height(d)) return;
      const std::size_t target = index(supernodes_.of_column[index(rows(d)[done[index(d)]])]);
      next[index(d)] = std::exchange(waiting[target], d);
    };
    for (int d = waiting[index(s)]; d >= 0;) {
      const int after = next[index(d)], from = done[index(d)];
      int to = from;
      while (to < height(d) && rows(d)[to] < end) ++to;
      eliminate(s, d, from, to, product, weighted, places);
      done[index(d)] = to;
      wait(d);
      d = after;
    }
    if (const auto fault = factor_panel(s, signs, weighted)) return fault;
    done[index(s)] = width(s);
    wait(s);
  }
  return find_singular(lower);
}

void SparseLdlt::assemble(const PermutedLower& lower) {
  values_.assign(index(supernodes_.value_starts.back()), 0);
  for (std::size_t row = 0; row < order_.size(); ++row) {
    const auto put = [&](int column, double value) {
      const int s = supernodes_.of_column[index(column)];
      const int* const place = std::lower_bound(rows(s), rows(s) + height(s), static_cast<int>(row));
      panel(s)[(place - rows(s)) + std::ptrdiff_t{column - supernodes_.firsts[index(s)]} * height(s)] = value;
    };
    put(static_cast<int>(row), lower.diagonal[row]);
    for (std::int64_t k = lower.starts[row]; k < lower.starts[row + 1]; ++k)
      put(lower.columns[index(k)], lower.values[index(k)]);
  }
}

/// Rows `from` to `to` of the descendant are columns of s; its rows from `from` on are rows of s.
void SparseLdlt::eliminate(int s, int descendant, int from, int to, std::vector<double>& product,
                           std::vector<double>& weighted, const std::vector<int>& places) {
  const int depth = width(descendant), stride = height(descendant), columns = to - from, count = stride - from;
  const double* const source = panel(descendant);
  weighted.resize(index(depth * columns));
  for (int k = 0; k < depth; ++k) {
    const double* const column = source + std::ptrdiff_t{k} * stride;
    for (int j = 0; j < columns; ++j) weighted[index(k * columns + j)] = column[from + j] * column[k];
  }
  double* const target = panel(s);
  const int* const targets = rows(descendant) + from;
  product.assign(index(count) * index(columns), 0);
  subtract_product(count, columns, depth, source + from, stride, weighted.data(), product.data(), count);
  for (int j = 0; j < columns; ++j) {
    double* const column = target + std::ptrdiff_t{targets[j] - supernodes_.firsts[index(s)]} * height(s);
    const double* const sums = product.data() + std::ptrdiff_t{j} * count;
    for (int i = j; i < count; ++i) column[places[index(targets[i])]] += sums[i];
  }
}

/// Eliminates within the panel; its diagonal then is D, and what is below it L.
std::optional<SparseLdlt::Fault> SparseLdlt::factor_panel(int s, std::span<const signed char> signs,
                                                          std::vector<double>& weighted) {
  const int columns = width(s), stride = height(s), first = supernodes_.firsts[index(s)];
  double* const values = panel(s);
  for (int block = 0; block < columns; block += block_width) {
    const int block_end = std::min(columns, block + block_width);
    for (int k = block; k < block_end; ++k) {
      double* const column = values + std::ptrdiff_t{k} * stride;
      const double pivot = column[k];
      const int row = order_[index(first + k)];
      const double sign = signs.empty() ? 1 : signs[index(row)];
      if (!(pivot * sign > 0) || !std::isfinite(pivot)) return Fault{row, pivot, std::abs(pivot) < negligible_pivot};
      for (int j = k + 1; j < block_end; ++j) {
        const double factor = column[j] / pivot;
        double* const other = values + std::ptrdiff_t{j} * stride;
        for (int i = j; i < stride; ++i) other[i] -= factor * column[i];
      }
      for (int i = k + 1; i < stride; ++i) column[i] /= pivot;
    }
    // The columns right of the block, a few at a time, from their diagonal down.
    for (int left = block_end; left < columns; left += block_width) {
      const int some = std::min(block_width, columns - left), depth = block_end - block;
      weighted.resize(index(depth * some));
      for (int k = 0; k < depth; ++k) {
        const double* const column = values + std::ptrdiff_t{block + k} * stride;
        for (int j = 0; j < some; ++j) weighted[index(k * some + j)] = column[left + j] * column[block + k];
      }
      subtract_product(stride - left, some, depth, values + std::ptrdiff_t{block} * stride + left, stride,
                       weighted.data(), values + std::ptrdiff_t{left} * stride + left, stride);
    }
  }
  return {};
}

/// Looks at the least pivot: z, with L^T z = e_k, has z^T A z = d_k. Where A z is no more than rounding, A is singular.
std::optional<SparseLdlt::Fault> SparseLdlt::find_singular(const PermutedLower& lower) const {
  double least = small_pivot;
  int place = -1;
  for (int s = 0; s < supernodes_.size(); ++s)
    for (int k = 0; k < width(s); ++k)
      if (const double pivot = panel(s)[std::ptrdiff_t{k} * (height(s) + 1)]; std::abs(pivot) < std::abs(least)) {
        least = pivot;
        place = supernodes_.firsts[index(s)] + k;
      }
  if (place < 0) return {};
  const std::size_t n = order_.size();
  std::vector<double> z(n, 0), image(n), levels(n);
  z[index(place)] = 1;
  backward(z);
  for (std::size_t i = 0; i < n; ++i) {
    image[i] = lower.diagonal[i] * z[i];
    levels[i] = std::abs(image[i]);
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::int64_t k = lower.starts[i]; k < lower.starts[i + 1]; ++k) {
      const std::size_t j = index(lower.columns[index(k)]);
      const double in_row = lower.values[index(k)] * z[j], in_column = lower.values[index(k)] * z[i];
      image[i] += in_row;
      image[j] += in_column;
      levels[i] += std::abs(in_row);
      levels[j] += std::abs(in_column);
    }
  if (norm(image) > singular_rounding * norm(levels)) return {};
  return Fault{order_[index(place)], least, true};
}

/// x = L^-T x.
void SparseLdlt::backward(std::span<double> x) const {
  std::vector<double> local;
  for (int s = supernodes_.size() - 1; s >= 0; --s) {
    const int stride = height(s);
    local.resize(index(stride));
    for (int i = 0; i < stride; ++i) local[index(i)] = x[index(rows(s)[i])];
    for (int k = width(s) - 1; k >= 0; --k) {
      const std::size_t below = index(stride - k - 1);
      const double* const column = panel(s) + std::ptrdiff_t{k} * stride + k + 1;
      local[index(k)] -= dot({column, below}, std::span<const double>(local).last(below));
    }
    for (int k = 0; k < width(s); ++k) x[index(rows(s)[k])] = local[index(k)];
  }
}

void SparseLdlt::solve(std::span<double> b) const {
  std::vector<double> x(order_.size()), local;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = scaling_[index(order_[k])] * b[index(order_[k])];
  for (int s = 0; s < supernodes_.size(); ++s) {
    const int stride = height(s);
    local.assign(index(stride), 0);
    for (int k = 0; k < width(s); ++k) {
      const double value = x[index(rows(s)[k])] + local[index(k)];
      const double* const column = panel(s) + std::ptrdiff_t{k} * stride;
      for (int i = k + 1; i < stride; ++i) local[index(i)] -= column[i] * value;
      x[index(rows(s)[k])] = value;
    }
    for (int i = width(s); i < stride; ++i) x[index(rows(s)[i])] += local[index(i)];
  }
  for (int s = 0; s < supernodes_.size(); ++s)
    for (int k = 0; k < width(s); ++k) x[index(rows(s)[k])] /= panel(s)[std::ptrdiff_t{k} * (height(s) + 1)];
  backward(x);
  for (std::size_t k = 0; k < x.size(); ++k) b[index(order_[k])] = scaling_[index(order_[k])] * x[k];
}

}  // namespace pliant
