// lib/pliant/fem/solve/direct_symmetric.cpp: LDL^T of positive definite and of saddle point matrices, refined.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "pliant/fem/solve/residual.h"
#include "pliant/fem/solve/sparse_ldlt.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

class DirectSymmetric : public LinearSolver {
 public:
  DirectSymmetric() = default;
  DirectSymmetric(const std::vector<bool>& multipliers, double regularisation) : regularisation_(regularisation) {
    for (const bool is_multiplier : multipliers) signs_.push_back(is_multiplier ? -1 : 1);
  }

  const char* name() const override { return signs_.empty() ? "LDL^T" : "quasi-definite LDL^T"; }

  std::string factor(const CsrMatrix& a) override {
    assert(signs_.empty() || signs_.size() == index(a.rows()));
    a_ = &a;
    if (std::string why = refuse_non_finite(a); !why.empty()) return why;
    // The scaled diagonal of B diag(A)^-1 B^T is about 1.
    std::vector<double> shift;
    for (const signed char sign : signs_) shift.push_back(sign < 0 ? -regularisation_ : 0);
    const auto fault = ldlt_.factor(a, symmetric_scaling(a), signs_, shift);
    if (!fault) return {};
    const std::string row = std::to_string(fault->row);
    const std::string text = "the pivot of row " + row + " is " + describe_number(fault->pivot);
    if (!std::isfinite(fault->pivot)) return text + ": the matrix leaves the range of numbers";
    if (fault->is_singular) return text + ": the matrix is singular up to rounding";
    return text + (signs_.empty() ? ": the matrix is not positive definite"
                                  : ": the matrix is no saddle point matrix with these multipliers");
  }

  SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const override {
    std::vector<double> step(b.size()), left(b.size());
    return correct(*a_, b, x, tolerance, true,
                   [&](std::span<const double> r, double, std::span<double> y, std::string&) {
                     apply(r, step);
                     if (regularisation_ > 0) {
                       // What was subtracted is taken out at once: where rows of the first block are much greater, the
                       // norm of the residual would not show it.
                       for (std::size_t i = 0; i < y.size(); ++i) y[i] += step[i];
                       true_residual(*a_, b, y, left);
                       apply(left, step);
                     }
                     for (std::size_t i = 0; i < y.size(); ++i) y[i] += step[i];
                     return 0;
                   });
  }

  void apply(std::span<const double> b, std::span<double> x) const override {
    std::ranges::copy(b, x.begin());
    ldlt_.solve(x);
  }

 private:
  const CsrMatrix* a_ = nullptr;
  SparseLdlt ldlt_;
  std::vector<signed char> signs_;  // that the pivots must have; none: all are positive
  double regularisation_ = 0;
};

}  // namespace

std::unique_ptr<LinearSolver> make_direct_symmetric() { return std::make_unique<DirectSymmetric>(); }

std::unique_ptr<LinearSolver> make_quasi_definite(const std::vector<bool>& multipliers, double regularisation) {
  return std::make_unique<DirectSymmetric>(multipliers, regularisation);
}

}  // namespace pliant
