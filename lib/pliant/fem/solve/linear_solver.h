// lib/pliant/fem/solve/linear_solver.h: factor, solve, residual: what every solver of linear systems offers.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pliant/fem/csr_matrix.h"

namespace pliant {

struct CoarseSpace;

/// What a matrix is known to be.
enum class MatrixKind {
  positive_definite,  ///< symmetric positive definite
  quasi_definite,     ///< symmetric, with a negative semi-definite block (saddle point systems)
  general             ///< with a symmetric pattern
};

/// How a solution was reached.
struct SolveOutcome {
  /// The residual is at most the tolerance; or, where numbers of 53 bits cannot do better, at most `rounding`.
  bool converged = false;
  double residual = 0;  ///< |b - A x| / |b|, computed anew from the solution (0 where b is 0)
  /// The residual that rounding the entries of an exact solution may leave: rounding_factor * | |A||x| + |b| | / |b|,
  /// where |A||x| + |b| is taken row by row. 0 where the tolerance was reached, so that nobody asked.
  double rounding = 0;
  int iterations = 0;   ///< of conjugate gradients
  int refinements = 0;  ///< corrections of a first solution, from its true residual
  std::string why;      ///< a sentence with the figures, where it has not converged
};

/// Solves systems with one matrix. The same matrix and right-hand side give the same bits.
///
/// Rows and columns are scaled inside by powers of two, which costs no digit: entries from 1e-150 to 1e150 may stand
/// beside each other. Numbers that are not finite are refused, in the matrix by `factor`, elsewhere by `solve`.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  virtual const char* name() const = 0;
  /// Takes the matrix, and factors it or makes a preconditioner. The matrix must live as long as it is used.
  /// Returns     an empty text, or why it cannot be factored
  /// Throws      std::length_error where the factor has more entries than can be numbered
  virtual std::string factor(const CsrMatrix& a) = 0;
  /// Solves A x = b until the relative residual is at most `tolerance`. `x` holds a guess before, which direct solvers
  /// do not need, and the best solution found after.
  /// Requires    that `factor` has returned an empty text
  virtual SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const = 0;
  /// Writes to x what is about A^-1 b, without a look at the residual: preconditioners are applied so. Direct solvers
  /// solve with their factors once, for which the matrix need not live any more; others solve to a relative residual of
  /// `approximate_tolerance`.
  /// Requires    that `factor` has returned an empty text
  virtual void apply(std::span<const double> b, std::span<double> x) const;
};

/// The relative residual of an iterative solver that preconditions another one.
inline constexpr double approximate_tolerance = 1e-2;

/// The relative residual that every system is solved to.
inline constexpr double solver_tolerance = 1e-12;
/// A residual of so much, relative to | |A||x| + |b| |, is rounding: 4 units in the last place.
inline constexpr double rounding_factor = 4 * 0x1p-52;
/// Where rounding leaves more than this of the right-hand side, the matrix is taken for singular.
inline constexpr double greatest_rounding = 1e-6;

/// LDL^T of symmetric positive definite matrices, by approximate minimum degree. Only the lower triangle is read, but
/// by the residual.
std::unique_ptr<LinearSolver> make_direct_symmetric();
/// LDL^T of saddle point systems [A B^T; B -C], A positive definite, C positive semi-definite (also none).
/// `multipliers` says which unknowns are of the second block. There, `regularisation` times the diagonal of B
/// diag(A)^-1 B^T is subtracted, with which the factors exist for every order of elimination; refinement takes it out
/// of the solution, of which one is always made. Consistent systems with a multiplier that is known up to a constant
/// need nothing more.
std::unique_ptr<LinearSolver> make_quasi_definite(const std::vector<bool>& multipliers, double regularisation = 1e-8);
/// LU with a symmetric ordering, for general matrices. A matrix that is singular must be made regular first: where a
/// multiplier is known up to a constant (the pressure of an enclosed flow) the last pivot is rounding, or 0, and the
/// solution has a constant of any size. A row and column of the identity for one multiplier costs no digit.
std::unique_ptr<LinearSolver> make_direct_general();
/// The same for saddle point matrices whose first block is not symmetric: nothing is pivoted, which keeps the fill that
/// the order was made for, and as in make_quasi_definite a regularisation makes it possible; GMRES takes it out of the
/// solution. Where convection is so strong that factors without pivots grow, it does not converge, and
/// make_direct_general is for that.
std::unique_ptr<LinearSolver> make_saddle_general(const std::vector<bool>& multipliers, double regularisation = 1e-8);

/// Conjugate gradients for symmetric positive definite matrices, preconditioned by symmetric overrelaxation.
std::unique_ptr<LinearSolver> make_conjugate_gradients();
/// Conjugate gradients, preconditioned by two levels: Gauss–Seidel, and the coarse space, whose matrix is factored.
std::unique_ptr<LinearSolver> make_two_level(CoarseSpace coarse);

/// The fastest of these for a symmetric positive definite matrix of so many rows; it is chosen when the matrix is
/// factored (tests/bench/README.md has the figures). `mass_dominated` says that it is like M + dt K: conjugate
/// gradients then take over where the time step is short. `coarse`, if not null, is a coarse space of the unknowns.
std::unique_ptr<LinearSolver> make_symmetric_solver(int rows, bool mass_dominated, const CoarseSpace* coarse = nullptr);

}  // namespace pliant
