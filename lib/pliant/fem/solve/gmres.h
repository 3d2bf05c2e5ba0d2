// lib/pliant/fem/solve/gmres.h: GMRES for general matrices, with the factors of another matrix near by.
#pragma once
#include <span>

#include "pliant/fem/solve/linear_solver.h"

namespace pliant {

struct GmresOptions {
  double tolerance = solver_tolerance;
  int most_iterations = 200;  ///< in all
  /// Iterations until it begins anew from what it has; two vectors are kept for each.
  int restart = 60;
};

/// Solves A x = b by flexible GMRES, preconditioned from the right by `apply` of a solver that has factored another
/// matrix: that of the stage or of Newton's step before, or a symmetric part of A. No factor of A is made, so a near
/// matrix is solved in the time of some solutions (tests/bench/README.md has figures).
///
/// What a cycle reduces, by as much as the true residual must fall, is the residual with rows scaled as direct solvers
/// scale them: the true one alone would say nothing of continuity where viscosities are great.
///
/// `x` holds a guess before, 0 if there is none, and the best solution found after. The same input gives the same bits.
///
/// Requires    a preconditioner with as many rows as A, whose `factor` returned an empty text
/// Refuses     numbers that are not finite in A, b or x, as a LinearSolver does
/// Ensures     the residual of the outcome is the true one, computed from A, b and x
/// Complexity  k iterations: k products with A, k applications of the preconditioner, and O(k min(k, restart) rows)
SolveOutcome solve_by_gmres(const CsrMatrix& a, const LinearSolver& preconditioner, std::span<const double> b,
                            std::span<double> x, const GmresOptions& options = {});

}  // namespace pliant
