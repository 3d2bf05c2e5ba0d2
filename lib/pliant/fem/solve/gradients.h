// lib/pliant/fem/solve/gradients.h: the loop of conjugate gradients, for operators that are given as functions.
#pragma once
#include <functional>
#include <span>
#include <string>

namespace pliant {

/// What conjugate gradients ask for. All of it in scaled unknowns.
struct GradientsProblem {
  /// y = A x.
  std::function<void(std::span<const double> x, std::span<double> y)> apply;
  /// z = M^-1 r; none where z is r.
  std::function<void(std::span<const double> r, std::span<double> z)> precondition;
  /// The norm of r in the original unknowns.
  std::function<double(std::span<const double> r)> original_norm;
  /// Costs as much as a product: then it is asked for only where the norm of r lets expect an answer.
  bool norm_is_costly = false;
};

/// Solves A y = r from y = 0, until the original norm of the residual has fallen by `reduction`; r is overwritten with
/// what is left of it, as the recurrence has it. Returns     iterations; `why` says what stopped them, where it was not
/// the reduction
int conjugate_gradients(const GradientsProblem& problem, std::span<double> r, std::span<double> y, double reduction,
                        std::string& why);

}  // namespace pliant
