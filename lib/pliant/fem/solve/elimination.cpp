// lib/pliant/fem/solve/elimination.cpp: approximate minimum degree by Eigen, the tree of elimination, column counts.
#include "pliant/fem/solve/elimination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#define EIGEN_MPL2_ONLY
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Pattern = Eigen::SparseMatrix<float, Eigen::ColMajor, int>;

/// The upper triangle by columns, without the matrix's zeros, but with the whole diagonal: Eigen's ordering puts rows
/// without a diagonal entry last, as if they were dense. It needs values, and does not read them.
Pattern upper_pattern(const CsrMatrix& a) {
  const CsrPattern& pattern = *a.pattern;
  std::int64_t count = a.rows();
  for (int i = 0; i < a.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k)
      if (pattern.columns[index(k)] < i && a.values[index(k)] != 0) ++count;
  // What Eigen's ordering asks for: both triangles, a fifth more, and two numbers a row.
  if (2 * count + 2 * count / 5 + 2 * std::int64_t{a.rows()} > std::numeric_limits<int>::max())
    throw std::length_error("the matrix has " + std::to_string(a.values.size()) +
                            " entries, too many for an order of elimination");
  Pattern upper(a.rows(), a.rows());
  upper.resizeNonZeros(count);
  int next = 0;
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k)
      if (const int j = pattern.columns[index(k)]; j < i && a.values[index(k)] != 0) upper.innerIndexPtr()[next++] = j;
    upper.innerIndexPtr()[next++] = i;
    upper.outerIndexPtr()[i + 1] = next;
  }
  std::fill_n(upper.valuePtr(), count, 1.0F);
  return upper;
}

/// The parent of each column: the first row below the diagonal of L's column (Liu 1986, with compressed paths).
std::vector<int> elimination_tree(const PermutedLower& lower) {
  const std::size_t n = lower.diagonal.size();
  std::vector<int> parents(n, -1), ancestors(n, -1);
  for (std::size_t k = 0; k < n; ++k)
    for (std::int64_t e = lower.starts[k]; e < lower.starts[k + 1]; ++e)
      for (int i = lower.columns[index(e)]; i != -1 && index(i) < k;) {
        const int next = std::exchange(ancestors[index(i)], static_cast<int>(k));
        if (next == -1) parents[index(i)] = static_cast<int>(k);
        i = next;
      }
  return parents;
}

/// The nodes of a forest, children before parents and each subtree together.
std::vector<int> postorder(const std::vector<int>& parents) {
  const std::size_t n = parents.size();
  std::vector<int> first(n, -1), sibling(n, -1), order, stack;
  for (std::size_t k = n; k-- > 0;)
    if (const int parent = parents[k]; parent >= 0)
      sibling[k] = std::exchange(first[index(parent)], static_cast<int>(k));
  order.reserve(n);
  for (std::size_t root = 0; root < n; ++root) {
    if (parents[root] >= 0) continue;
    stack.push_back(static_cast<int>(root));
    while (!stack.empty()) {
      const std::size_t node = index(stack.back());
      if (const int child = std::exchange(first[node], -1); child >= 0) {
        stack.push_back(child);
      } else {
        order.push_back(static_cast<int>(node));
        stack.pop_back();
        if (sibling[node] >= 0) stack.push_back(sibling[node]);
      }
    }
  }
  return order;
}

/// Walks along the rows of L: row k has an entry in each column on the paths from those of the matrix's row up to k.
std::vector<int> column_counts(const PermutedLower& lower, const std::vector<int>& parents) {
  const std::size_t n = parents.size();
  std::vector<int> counts(n, 0), reached(n, -1);
  for (std::size_t k = 0; k < n; ++k) {
    const int row = static_cast<int>(k);
    reached[k] = row;
    for (std::int64_t e = lower.starts[k]; e < lower.starts[k + 1]; ++e)
      for (int i = lower.columns[index(e)]; reached[index(i)] != row; i = parents[index(i)]) {
        ++counts[index(i)];
        reached[index(i)] = row;
      }
  }
  return counts;
}

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) places[index(order[k])] = static_cast<int>(k);
  return places;
}

}  // namespace

std::int64_t Elimination::fill() const { return std::accumulate(counts.begin(), counts.end(), std::int64_t{0}); }

PermutedLower permute(const CsrMatrix& a, const std::vector<double>& scaling, const std::vector<int>& places) {
  const CsrPattern& pattern = *a.pattern;
  const std::size_t n = index(a.rows());
  PermutedLower result;
  result.starts.assign(n + 1, 0);
  result.diagonal.assign(n, 0);
  const auto for_each_lower = [&](const auto& visit) {
    for (std::size_t i = 0; i < n; ++i)
      for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k)
        if (const std::size_t j = index(pattern.columns[index(k)]); j <= i && a.values[index(k)] != 0)
          visit(i, j, a.values[index(k)]);
  };
  for_each_lower([&](std::size_t i, std::size_t j, double) {
    if (i != j) ++result.starts[index(std::max(places[i], places[j])) + 1];
  });
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  result.columns.resize(index(result.starts[n]));
  result.values.resize(index(result.starts[n]));
  std::vector<std::int64_t> next(result.starts.begin(), result.starts.end() - 1);
  for_each_lower([&](std::size_t i, std::size_t j, double value) {
    const double scaled = scaling[i] * value * scaling[j];
    const auto [column, row] = std::minmax(places[i], places[j]);
    if (i == j) {
      result.diagonal[index(row)] = scaled;
    } else {
      const std::size_t place = index(next[index(row)]++);
      result.columns[place] = column;
      result.values[place] = scaled;
    }
  });
  return result;
}

Elimination order_by_minimum_degree(const CsrMatrix& a) {
  Elimination result;
  if (a.rows() == 0) return result;
  {
    const Pattern upper = upper_pattern(a);
    Eigen::AMDOrdering<int>::PermutationType permutation;
    Eigen::AMDOrdering<int>{}(upper.selfadjointView<Eigen::Upper>(), permutation);  // new to old, as `order`
    result.order.assign(permutation.indices().data(), permutation.indices().data() + a.rows());
  }
  result.places = inverse(result.order);
  const std::vector<double> ones(index(a.rows()), 1);
  PermutedLower lower = permute(a, ones, result.places);
  const std::vector<int> post = postorder(elimination_tree(lower));
  std::vector<int> order(result.order.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = result.order[index(post[k])];
  result.order = std::move(order);
  result.places = inverse(result.order);
  lower = permute(a, ones, result.places);
  result.parents = elimination_tree(lower);
  result.counts = column_counts(lower, result.parents);
  return result;
}

}  // namespace pliant
