// lib/pliant/fem/solve/linear_solver.h: factor, solve, residual: what every solver of linear systems offers.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "pliant/fem/csr_matrix.h"

namespace pliant {

/// What a matrix is known to be.
enum class MatrixKind {
  positive_definite,  ///< symmetric positive definite
  quasi_definite,     ///< symmetric, with a negative semi-definite block (saddle point systems)
  general             ///< with a symmetric pattern
};

/// How a solution was reached.
struct SolveOutcome {
  bool converged = false;
  double residual = 0;  ///< |b - A x| / |b|, computed anew from the solution (0 where b is 0)
  int iterations = 0;   ///< of conjugate gradients
  int refinements = 0;  ///< of a direct solution
  std::string why;      ///< a sentence with the figures, where it has not converged
};

/// Solves systems with one matrix. The same matrix and right-hand side give the same bits.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  virtual const char* name() const = 0;
  /// Takes the matrix, and factors it or makes a preconditioner. The matrix must live as long as it is used.
  /// Returns     an empty text, or why it cannot be factored
  virtual std::string factor(const CsrMatrix& a) = 0;
  /// Solves A x = b until the relative residual is at most `tolerance`. `x` holds a guess before, which direct solvers
  /// do not need, and the best solution found after.
  virtual SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const = 0;
};

/// The relative residual that every system is solved to.
inline constexpr double solver_tolerance = 1e-12;

/// LDL^T of symmetric positive definite matrices, by approximate minimum degree.
std::unique_ptr<LinearSolver> make_direct_symmetric();
/// Conjugate gradients for symmetric positive definite matrices.
std::unique_ptr<LinearSolver> make_conjugate_gradients();
/// LU with a symmetric ordering, for general matrices.
std::unique_ptr<LinearSolver> make_direct_general();

/// The solver for a symmetric positive definite matrix of so many rows. `mass_dominated` says that it is like M + dt K.
std::unique_ptr<LinearSolver> make_symmetric_solver(int rows, bool mass_dominated);

}  // namespace pliant
