// lib/pliant/fem/solve/direct_general.cpp: LU of general matrices by Eigen, ordered, scaled and pivoted so that it is
// fast.
#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#define EIGEN_MPL2_ONLY
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include "pliant/fem/solve/elimination.h"
#include "pliant/fem/solve/gmres.h"
#include "pliant/fem/solve/residual.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// A diagonal entry that is at least this share of the greatest of its column is the pivot: those that are good enough
/// keep the fill that the order was made for.
constexpr double pivot_threshold = 0.1;
/// How many entries the factors may have for one of a Cholesky factor of the same pattern: L and U, and columns joined.
constexpr std::int64_t entries_for_fill = 4;

/// The matrix is ordered before Eigen gets it: its own AMDOrdering gives SparseLU the inverse of what that expects.
struct OrderAsItIs {
  using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) {
    permutation.resize(matrix.cols());
    permutation.setIdentity();
  }
};
using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// 1 where an entry or the one across the diagonal is not zero, else 0: what the order of elimination reads.
CsrMatrix symmetric_shape(const CsrMatrix& a) {
  CsrMatrix shape{a.pattern, std::vector<double>(a.values.size(), 0)};
  const CsrPattern& pattern = *a.pattern;
  for (int i = 0; i < a.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      if (a.values[index(k)] == 0) continue;
      shape.values[index(k)] = 1;
      const int across = pattern.find(pattern.columns[index(k)], i);
      if (across >= 0) shape.values[index(across)] = 1;
    }
  return shape;
}

/// S A S in the order of elimination; `shift`, if not empty, is added to its diagonal.
Sparse permuted(const CsrMatrix& a, const std::vector<double>& scaling, const Elimination& elimination,
                const std::vector<double>& shift) {
  const CsrPattern& pattern = *a.pattern;
  Sparse result(a.rows(), a.rows());
  int* const starts = result.outerIndexPtr();
  const auto for_each = [&](const auto& visit) {
    for (int row = 0; row < a.rows(); ++row) {
      const std::size_t i = index(elimination.order[index(row)]);
      for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k) {
        const std::size_t j = index(pattern.columns[index(k)]);
        // A zero on the diagonal stays: the pattern that the order was made for has it.
        if (a.values[index(k)] != 0 || i == j)
          visit(row, elimination.places[j],
                scaling[i] * a.values[index(k)] * scaling[j] + (i == j && !shift.empty() ? shift[i] : 0));
      }
    }
  };
  for_each([&](int, int column, double) { ++starts[column + 1]; });
  for (int k = 0; k < a.rows(); ++k) starts[k + 1] += starts[k];
  result.resizeNonZeros(starts[a.rows()]);
  std::vector<int> next(starts, starts + a.rows());
  for_each([&](int row, int column, double value) {
    const int place = next[index(column)]++;
    result.innerIndexPtr()[place] = row;
    result.valuePtr()[place] = value;
  });
  return result;
}

class DirectGeneral : public LinearSolver {
 public:
  DirectGeneral() = default;
  DirectGeneral(const std::vector<bool>& multipliers, double regularisation) {
    for (const bool is_multiplier : multipliers) shift_.push_back(is_multiplier ? -regularisation : 0);
  }

  const char* name() const override { return shift_.empty() ? "LU" : "LU without pivoting"; }

  std::string factor(const CsrMatrix& a) override {
    a_ = &a;
    if (std::string why = refuse_non_finite(a); !why.empty() || a.rows() == 0) return why;
    scaling_ = symmetric_scaling(a);
    const bool is_new = note_shape(a);
    if (is_new) elimination_ = order_by_minimum_degree(symmetric_shape(a));
    if (entries_for_fill * elimination_.fill() > std::numeric_limits<int>::max()) {
      pattern_.reset();  // nothing of it serves another matrix
      throw std::length_error("the factors of " + std::to_string(a.rows()) + " rows have about " +
                              std::to_string(2 * elimination_.fill()) + " entries, more than can be numbered");
    }
    const Sparse matrix = permuted(a, scaling_, elimination_, shift_);
    if (is_new) {
      lu_.isSymmetric(true);
      lu_.setPivotThreshold(shift_.empty() ? pivot_threshold : 0);
      lu_.analyzePattern(matrix);
    }
    lu_.factorize(matrix);
    if (lu_.info() == Eigen::Success) return {};
    const int row = failed_row();
    if (row < 0) return "the factors do not fit into memory";
    return "the matrix is singular: no pivot is left for row " + std::to_string(row);
  }

  SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const override {
    if (!shift_.empty()) return solve_by_gmres(*a_, *this, b, x, {.tolerance = tolerance, .most_iterations = 40});
    std::vector<double> step(b.size());
    return correct(*a_, b, x, tolerance, true,
                   [&](std::span<const double> r, double, std::span<double> y, std::string&) {
                     apply(r, step);
                     for (std::size_t i = 0; i < y.size(); ++i) y[i] += step[i];
                     return 0;
                   });
  }

  void apply(std::span<const double> b, std::span<double> x) const override {
    const std::vector<int>& places = elimination_.places;
    Eigen::VectorXd right(static_cast<Eigen::Index>(b.size()));
    for (std::size_t i = 0; i < b.size(); ++i) right[places[i]] = scaling_[i] * b[i];
    const Eigen::VectorXd solution = lu_.solve(right);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = scaling_[i] * solution[places[i]];
  }

 private:
  /// Remembers which entries are zero; false where they are those of the last matrix. What follows from them alone, the
  /// order of elimination, then serves again.
  bool note_shape(const CsrMatrix& a) {
    std::vector<bool> shape;
    shape.reserve(a.values.size());
    for (const double value : a.values) shape.push_back(value != 0);
    if (pattern_ == a.pattern && shape == shape_) return false;
    pattern_ = a.pattern;
    shape_ = std::move(shape);
    return true;
  }

  /// Eigen tells the column at which elimination ended in words only, counted from 1; no number: it was memory.
  int failed_row() const {
    const std::string text = lu_.lastErrorMessage();
    const auto digits = std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (digits == text.end()) return -1;
    const int column = std::atoi(text.c_str() + (digits - text.begin())) - 1;
    const auto& permutation = lu_.colsPermutation().indices();
    for (int k = 0; k < a_->rows(); ++k)
      if (permutation[k] == column) return elimination_.order[index(k)];
    return -1;
  }

  const CsrMatrix* a_ = nullptr;
  std::vector<double> shift_;  // of the diagonal, scaled; empty: none, and rows are exchanged
  std::vector<double> scaling_;
  std::shared_ptr<const CsrPattern> pattern_;  // of the last matrix
  std::vector<bool> shape_;                    // which of its entries are not zero
  Elimination elimination_;
  Eigen::SparseLU<Sparse, OrderAsItIs> lu_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_direct_general() { return std::make_unique<DirectGeneral>(); }

std::unique_ptr<LinearSolver> make_saddle_general(const std::vector<bool>& multipliers, double regularisation) {
  return std::make_unique<DirectGeneral>(multipliers, regularisation);
}

}  // namespace pliant
