// lib/pliant/fem/solve/residual.h: the true residual of a solution, and what is said of it.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pliant/fem/solve/linear_solver.h"

namespace pliant {

/// Which entry is not finite, in words that begin with `what`; empty if all are.
std::string refuse_non_finite(const CsrMatrix& a);
std::string refuse_non_finite(std::span<const double> values, const std::string& what);

/// r = b - A x.   Returns     |r| / |b|, which is not finite where r is not
double true_residual(const CsrMatrix& a, std::span<const double> b, std::span<const double> x, std::span<double> r);

/// Solves without a look at the residual: overwrites a right-hand side with a solution.
using ApproximateInverse = std::function<void(std::span<double>)>;
/// One correction: from the residual r of x, whose relative norm is given, adds to x. Returns iterations, and in `why`
/// a sentence if no correction was found.
using Correction =
    std::function<int(std::span<const double> r, double residual, std::span<double> x, std::string& why)>;

/// Corrects x until its true residual is at most the tolerance, or as long as that halves it.
/// `x` holds a guess before, unless `starts_at_zero`, and the best solution after.
SolveOutcome correct(const CsrMatrix& a, std::span<const double> b, std::span<double> x, double tolerance,
                     bool starts_at_zero, const Correction& correction);

/// Powers of two s_i with which S A S has a diagonal between 1/2 and 2. Where a diagonal entry is not positive
/// (pressures, whose block may be empty), S A S has about 1 as the diagonal of B diag(A)^-1 B^T instead.
std::vector<double> symmetric_scaling(const CsrMatrix& a);
/// The power of two next to a positive number.
double nearest_power_of_two(double value);

}  // namespace pliant
