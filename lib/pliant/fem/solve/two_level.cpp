// lib/pliant/fem/solve/two_level.cpp: conjugate gradients with Gauss–Seidel on the unknowns and LDL^T on a coarse
// space.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/gradients.h"
#include "pliant/fem/solve/residual.h"
#include "pliant/fem/solve/scaled_lower.h"
#include "pliant/fem/solve/sparse_ldlt.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Which unknowns have no neighbour: their rows are solved by themselves, as those of values that are given.
std::vector<bool> lonely_rows(const ScaledLower& lower) {
  std::vector<bool> result(lower.scaling.size(), true);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (int k = lower.starts[i]; k < lower.starts[i + 1]; ++k)
      result[i] = result[index(lower.columns[index(k)])] = false;
  return result;
}

/// The space without the functions that are not 0 at lonely unknowns.
CoarseSpace restrict_to(const CoarseSpace& space, const std::vector<bool>& lonely) {
  std::vector<int> numbers(index(space.size), 0);
  for (std::size_t i = 0; i < lonely.size(); ++i)
    for (int k = space.starts[i]; lonely[i] && k < space.starts[i + 1]; ++k)
      if (space.weights[index(k)] != 0) numbers[index(space.columns[index(k)])] = -1;
  CoarseSpace result;
  for (int& number : numbers)
    if (number == 0) number = result.size++;
  for (std::size_t i = 0; i < lonely.size(); ++i) {
    for (int k = space.starts[i]; k < space.starts[i + 1]; ++k)
      if (const int number = numbers[index(space.columns[index(k)])]; number >= 0 && !lonely[i]) {
        result.columns.push_back(number);
        result.weights.push_back(space.weights[index(k)]);
      }
    result.starts.push_back(static_cast<int>(result.columns.size()));
  }
  return result;
}

/// The transposed lists: which unknowns a coarse function has, and with which weights.
CoarseSpace transpose(const CoarseSpace& space) {
  CoarseSpace result;
  result.size = space.rows();
  result.starts.assign(index(space.size) + 1, 0);
  for (const int column : space.columns) ++result.starts[index(column) + 1];
  for (std::size_t k = 1; k < result.starts.size(); ++k) result.starts[k] += result.starts[k - 1];
  result.columns.resize(space.columns.size());
  result.weights.resize(space.columns.size());
  std::vector<int> next(result.starts.begin(), result.starts.end() - 1);
  for (int i = 0; i < space.rows(); ++i)
    for (int k = space.starts[index(i)]; k < space.starts[index(i) + 1]; ++k) {
      const std::size_t place = index(next[index(space.columns[index(k)])]++);
      result.columns[place] = i;
      result.weights[place] = space.weights[index(k)];
    }
  return result;
}

/// The lower triangle of P^T A P.
CsrMatrix coarse_matrix(const CsrMatrix& a, const CoarseSpace& space) {
  const CsrPattern& pattern = *a.pattern;
  const CoarseSpace functions = transpose(space);
  const auto coarse = std::make_shared<CsrPattern>();
  CsrMatrix result;
  std::vector<double> sums(index(space.size), 0);
  std::vector<int> seen(index(space.size), -1), row;
  for (int f = 0; f < space.size; ++f) {
    row.clear();
    for (int k = functions.starts[index(f)]; k < functions.starts[index(f) + 1]; ++k) {
      const std::size_t i = index(functions.columns[index(k)]);
      for (int e = pattern.starts[i]; e < pattern.starts[i + 1]; ++e) {
        const double value = functions.weights[index(k)] * a.values[index(e)];
        const std::size_t j = index(pattern.columns[index(e)]);
        for (int g = space.starts[j]; g < space.starts[j + 1]; ++g) {
          const int other = space.columns[index(g)];
          if (other > f) continue;
          if (std::exchange(seen[index(other)], f) != f) {
            row.push_back(other);
            sums[index(other)] = 0;
          }
          sums[index(other)] += value * space.weights[index(g)];
        }
      }
    }
    std::ranges::sort(row);
    for (const int other : row) {
      coarse->columns.push_back(other);
      result.values.push_back(sums[index(other)]);
    }
    coarse->starts.push_back(static_cast<int>(coarse->columns.size()));
  }
  result.pattern = coarse;
  return result;
}

class TwoLevel : public LinearSolver {
 public:
  explicit TwoLevel(CoarseSpace space) : space_(std::move(space)) {}

  const char* name() const override { return "two-level conjugate gradients"; }

  std::string factor(const CsrMatrix& a) override {
    assert(space_.rows() == a.rows());
    a_ = &a;
    if (std::string why = lower_.set(a, 1); !why.empty()) return why;
    active_ = restrict_to(space_, lonely_rows(lower_));
    const CsrMatrix coarse = coarse_matrix(a, active_);
    for (std::size_t i = 0; i < lower_.scaling.size(); ++i)
      for (int k = active_.starts[i]; k < active_.starts[i + 1]; ++k)
        active_.weights[index(k)] /= lower_.scaling[i];  // for scaled unknowns
    const auto fault = ldlt_.factor(coarse, symmetric_scaling(coarse));
    if (!fault) return {};
    return fault->is_singular ? "the matrix is singular up to rounding, on the coarse space"
                              : "the matrix is not positive definite, on the coarse space";
  }

  SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const override {
    return correct(*a_, b, x, tolerance, false,
                   [&](std::span<const double> r, double residual, std::span<double> y, std::string& why) {
                     return step(r, tolerance / residual, y, why);
                   });
  }

 private:
  int step(std::span<const double> r, double reduction, std::span<double> x, std::string& why) const {
    const std::size_t n = r.size();
    std::vector<double> scaled(n), y(n), work(n), coarse(index(active_.size));
    const double unit = nearest_power_of_two(norm(r));
    for (std::size_t i = 0; i < n; ++i) scaled[i] = lower_.scaling[i] * (r[i] / unit);
    const double size = norm(scaled);
    const double inner_unit = size > 0 && std::isfinite(size) ? nearest_power_of_two(size) : 1;
    for (double& value : scaled) value /= inner_unit;
    GradientsProblem problem;
    problem.apply = [&](std::span<const double> v, std::span<double> image) { lower_.product(v, image); };
    problem.precondition = [&](std::span<const double> v, std::span<double> z) { cycle(v, z, work, coarse); };
    problem.original_norm = [&](std::span<const double> v) {
      for (std::size_t i = 0; i < n; ++i) work[i] = v[i] / lower_.scaling[i];
      return norm(work);
    };
    const int iterations = conjugate_gradients(problem, scaled, y, reduction, why);
    for (std::size_t i = 0; i < n; ++i) x[i] += lower_.scaling[i] * (y[i] * inner_unit) * unit;
    return iterations;
  }

  /// Gauss–Seidel forwards, the coarse space, Gauss–Seidel backwards: symmetric, as conjugate gradients need it.
  void cycle(std::span<const double> r, std::span<double> z, std::span<double> work, std::span<double> coarse) const {
    std::ranges::copy(r, z.begin());
    lower_.forward(z);
    lower_.upper_product(z, work);  // minus the residual of z
    std::ranges::fill(coarse, 0);
    for (std::size_t i = 0; i < z.size(); ++i)
      for (int k = active_.starts[i]; k < active_.starts[i + 1]; ++k)
        coarse[index(active_.columns[index(k)])] -= active_.weights[index(k)] * work[i];
    ldlt_.solve(coarse);
    for (std::size_t i = 0; i < z.size(); ++i)
      for (int k = active_.starts[i]; k < active_.starts[i + 1]; ++k)
        z[i] += active_.weights[index(k)] * coarse[index(active_.columns[index(k)])];
    lower_.lower_product(z, work);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = r[i] - work[i];
    lower_.backward(z);
  }

  const CsrMatrix* a_ = nullptr;
  CoarseSpace space_, active_;
  ScaledLower lower_;
  SparseLdlt ldlt_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_two_level(CoarseSpace coarse) {
  return std::make_unique<TwoLevel>(std::move(coarse));
}

}  // namespace pliant
