// lib/pliant/fem/solve/symmetric_solver.cpp: which solver is the fastest for a symmetric positive definite matrix.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

// Measured on quadratic elements (tests/bench/README.md): one factorisation and one solution.

/// Up to so many rows everything takes some milliseconds, and LDL^T never lacks accuracy.
constexpr int largest_small = 2000;
/// Above, LDL^T asks for several gigabytes.
constexpr int largest_direct = 3000000;
/// Two levels cost as much as so many iterations of conjugate gradients with overrelaxation, whatever the size.
constexpr double iterations_of_two_levels = 110;
/// And LDL^T as many as this times the cube root of the rows: 69 at 12,000 rows, 290 at 936,000.
constexpr double iterations_of_direct = 3;

/// How many iterations conjugate gradients will take. Constants are what they reduce most slowly: they see the mass
/// only, while the diagonal has the stiffness, too. The tenth part of the rows where this matters most is looked at.
double expected_iterations(const CsrMatrix& a) {
  const CsrPattern& pattern = *a.pattern;
  std::vector<double> shares;
  for (std::size_t i = 0; i < index(a.rows()); ++i) {
    double diagonal = 0, sum = 0;
    bool is_lonely = true;  // as a value that is given
    for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k) {
      sum += a.values[index(k)];
      if (index(pattern.columns[index(k)]) == i)
        diagonal = a.values[index(k)];
      else
        is_lonely = is_lonely && a.values[index(k)] == 0;
    }
    if (!is_lonely && diagonal > 0 && !std::isnan(sum)) shares.push_back(sum / diagonal);
  }
  if (shares.empty()) return 1;
  const auto tenth = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 10);
  std::nth_element(shares.begin(), tenth, shares.end());
  constexpr double iterations_for_share_1 = 6;
  return *tenth > 0 ? iterations_for_share_1 / std::sqrt(*tenth) : HUGE_VAL;
}

/// Chooses when it sees the matrix.
class ChosenSolver : public LinearSolver {
 public:
  ChosenSolver(bool mass_dominated, std::optional<CoarseSpace> coarse)
      : has_mass_(mass_dominated), coarse_(std::move(coarse)) {}

  const char* name() const override { return solver_ ? solver_->name() : "LDL^T or conjugate gradients"; }

  std::string factor(const CsrMatrix& a) override {
    solver_ = choose(a);
    return solver_->factor(a);
  }

  SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const override {
    assert(solver_);
    return solver_->solve(b, x, tolerance);
  }

  void apply(std::span<const double> b, std::span<double> x) const override {
    assert(solver_);
    solver_->apply(b, x);
  }

 private:
  std::unique_ptr<LinearSolver> choose(const CsrMatrix& a) const {
    if (a.rows() <= largest_small) return make_direct_symmetric();
    const double iterations = has_mass_ ? expected_iterations(a) : HUGE_VAL;
    if (coarse_) return iterations <= iterations_of_two_levels ? make_conjugate_gradients() : make_two_level(*coarse_);
    if (a.rows() > largest_direct || iterations <= iterations_of_direct * std::cbrt(a.rows()))
      return make_conjugate_gradients();
    return make_direct_symmetric();
  }

  bool has_mass_;
  std::optional<CoarseSpace> coarse_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_symmetric_solver(int rows, bool mass_dominated, const CoarseSpace* coarse) {
  assert(!coarse || coarse->rows() == rows);
  // A space that is hardly coarser, as the hats are at degree 1, saves nothing.
  const bool has_coarse = coarse != nullptr && rows > largest_small && coarse->size <= rows / 2;
  return std::make_unique<ChosenSolver>(mass_dominated, has_coarse ? std::optional(*coarse) : std::nullopt);
}

}  // namespace pliant
