// lib/pliant/fem/solve/supernodes.cpp: which columns are joined, and the rows that they have together.
#include "pliant/fem/solve/supernodes.h"

#include <algorithm>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Wider panels would leave the cache while they are factored.
constexpr int greatest_width = 64;

/// May columns be joined, a share of whose entries then are zeros? Narrow ones gain more by it. (The limits are
/// CHOLMOD's, which were found on many matrices.)
bool is_worth_joining(int columns, double zeros) {
  return columns <= 4 || (columns <= 16 && zeros < 0.8) || (columns <= 48 && zeros < 0.1) || zeros < 0.05;
}

/// The first columns of groups whose rows are the same but for the columns themselves.
std::vector<int> fundamental_groups(const Elimination& e) {
  const int n = static_cast<int>(e.parents.size());
  std::vector<int> firsts;
  for (int k = 0; k < n; ++k)
    if (k == 0 || e.parents[index(k - 1)] != k || e.counts[index(k - 1)] != e.counts[index(k)] + 1) firsts.push_back(k);
  firsts.push_back(n);
  return firsts;
}

/// Joins a group with the one after it, where that one holds its parent and few zeros come of it.
std::vector<int> joined_groups(const Elimination& e, const std::vector<int>& firsts) {
  const int groups = static_cast<int>(firsts.size()) - 1;
  std::vector<int> result;
  result.push_back(firsts.back());
  int width_after = 0;
  double height_after = 0, zeros_after = 0;  // of the group's first column, with the diagonal
  for (int g = groups - 1; g >= 0; --g) {
    const int first = firsts[index(g)], end = firsts[index(g) + 1], width = end - first;
    const double height = e.counts[index(first)] + 1;
    const int parent = e.parents[index(end) - 1];
    if (width_after > 0 && parent >= end && parent < end + width_after) {
      const int columns = width + width_after;
      const double zeros = zeros_after + width * (height_after + width - height);
      const double total = 0.5 * columns * (columns + 1) + columns * (height_after - width_after);
      if (is_worth_joining(columns, zeros / total)) {
        width_after = columns;
        height_after += width;
        zeros_after = zeros;
        continue;
      }
    }
    result.push_back(end);
    width_after = width;
    height_after = height;
    zeros_after = 0;
  }
  if (groups > 0) result.push_back(0);
  std::ranges::reverse(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Where columns of the matrix have their entries: the rows of `lower`, transposed.
struct Columns {
  std::vector<std::int64_t> starts;
  std::vector<int> rows;

  explicit Columns(const PermutedLower& lower) : starts(lower.starts.size(), 0), rows(lower.columns.size()) {
    for (const int column : lower.columns) ++starts[index(column) + 1];
    for (std::size_t k = 1; k < starts.size(); ++k) starts[k] += starts[k - 1];
    std::vector<std::int64_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t row = 0; row + 1 < lower.starts.size(); ++row)
      for (std::int64_t k = lower.starts[row]; k < lower.starts[row + 1]; ++k)
        rows[index(next[index(lower.columns[index(k)])]++)] = static_cast<int>(row);
  }
};

}  // namespace

Supernodes find_supernodes(const Elimination& elimination, const PermutedLower& lower) {
  Supernodes result;
  const std::size_t n = elimination.parents.size();
  const std::vector<int> groups = joined_groups(elimination, fundamental_groups(elimination));
  for (std::size_t g = 0; g + 1 < groups.size(); ++g)
    for (int first = groups[g]; first < groups[g + 1];) {
      // Pieces of about the same width.
      const int left = groups[g + 1] - first, pieces = (left + greatest_width - 1) / greatest_width;
      first += (left + pieces - 1) / pieces;
      result.firsts.push_back(first);
    }
  result.of_column.resize(n);
  const Columns columns(lower);
  // The rows of a supernode: those of the matrix, and those that its children have beyond their own columns.
  std::vector<int> first_child(result.firsts.size(), -1), sibling(result.firsts.size(), -1), seen(n, -1);
  for (int s = 0; s < result.size(); ++s)
    for (int k = result.firsts[index(s)]; k < result.firsts[index(s) + 1]; ++k) result.of_column[index(k)] = s;
  for (int s = 0; s < result.size(); ++s) {
    const int first = result.firsts[index(s)], end = result.firsts[index(s) + 1];
    const auto add = [&](int row) {
      if (row < end || seen[index(row)] == s) return;
      seen[index(row)] = s;
      result.rows.push_back(row);
    };
    const std::size_t start = result.rows.size();
    for (int k = first; k < end; ++k) result.rows.push_back(k);
    for (int k = first; k < end; ++k)
      for (std::int64_t e = columns.starts[index(k)]; e < columns.starts[index(k) + 1]; ++e)
        add(columns.rows[index(e)]);
    for (int child = first_child[index(s)]; child >= 0; child = sibling[index(child)])
      for (std::int64_t e = result.row_starts[index(child)]; e < result.row_starts[index(child) + 1]; ++e)
        add(result.rows[index(e)]);
    const auto below = result.rows.begin() + static_cast<std::ptrdiff_t>(start) + (end - first);
    std::sort(below, result.rows.end());
    if (below != result.rows.end()) {
      const int parent = result.of_column[index(*below)];
      sibling[index(s)] = first_child[index(parent)];
      first_child[index(parent)] = s;
    }
    const auto height = static_cast<std::int64_t>(result.rows.size() - start);
    result.row_starts.push_back(static_cast<std::int64_t>(result.rows.size()));
    result.value_starts.push_back(result.value_starts.back() + height * (end - first));
  }
  return result;
}

}  // namespace pliant
