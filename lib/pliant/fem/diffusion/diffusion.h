// lib/pliant/fem/diffusion/diffusion.h: steady solutions and steps in time of the convection-diffusion equation.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pliant/fem/diffusion/diffusion_equation.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/fem/solve/no_solution.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// How time steps are taken. All are implicit, so that steps may be of any length.
enum class TimeScheme {
  sdirk2,          ///< two stages, L-stable, order 2 (Alexander 1977, gamma = 1 - 1/sqrt(2)); both have the same matrix
  crank_nicolson,  ///< order 2, not damping: a jump in the data keeps ringing
  euler            ///< backward Euler, order 1
};

struct DiffusionOptions {
  TimeScheme scheme = TimeScheme::sdirk2;
  /// d(M c)/dt, which keeps the total to rounding; or M dc/dt, which keeps constants to rounding.
  bool conservative = true;
  bool needs_initial = true;  ///< a field that is missing needs initial values; else it begins with zeros
  bool wants_fluxes = false;  ///< what crosses curves is worth computing
};

/// The equation of a problem on one mesh in memory, whose field it solves for.
class Diffusion {
 public:
  /// Makes the field from the problem's initial values where the mesh has none; by face where a condition lets it jump.
  /// Throws      InputError where the field does not fit, or where it is missing and so are the initial values
  Diffusion(const DiffusionProblem& problem, Mesh& mesh, const DiffusionOptions& options);

  const DiffusionEquation& equation() const { return equation_; }

  /// Replaces the field by the solution that does not change in time, at mesh.time.
  /// Throws      InputError, NoSolution
  void solve_steady();
  /// Takes the field through a step from time t0 to mesh.time, in which the control points have moved on straight lines
  /// from `from` to where they are; an empty `from` says that they have not moved.
  /// Throws      InputError, NoSolution
  void step(std::span<const Point> from, double t0);

  /// Adds what is known of the last solution: totals, extremes, energy, fluxes, residuals; in the document's units.
  void report(PassReport& report) const;

 private:
  /// The least and greatest values over the mesh, to a millionth of their difference.
  std::pair<double, double> extremes() const;
  void find_field();
  void assemble(const Configuration& at, std::optional<double> shift, bool serves_again);
  void factor(std::optional<double> shift);
  std::unique_ptr<LinearSolver> choose_solver(std::optional<double> shift) const;
  void solve(std::vector<double> b, std::span<double> x, std::optional<double> shift);
  /// The same of a step, where nothing enters but what the load says.
  void solve_around_mean(std::vector<double> b, std::span<double> x);
  /// Counts a solution whose right-hand side was `part_of_size` of the whole one in size. Throws NoSolution.
  void take_note(const SolveOutcome& outcome, double part_of_size);
  /// The solution of  (mass + shift stiffness) x = b + shift load,  where `right_side` makes b once mass is known.
  using RightSide = std::function<std::vector<double>()>;
  void solve_at(const Configuration& at, std::optional<double> shift, bool serves_again, const RightSide& right_side,
                std::span<double> x);
  void step_conservatively(std::span<const Point> from, double t0, bool moves);
  void step_by_derivatives(std::span<const Point> from, double t0, bool moves);
  void put(std::span<const double> unknowns);

  const DiffusionProblem& problem_;
  Mesh& mesh_;
  DiffusionOptions options_;
  DiffusionEquation equation_;
  int field_ = none;

  DiffusionSystem system_;
  CsrMatrix matrix_;  // mass + shift * stiffness, or stiffness alone, with equations of their own for fixed unknowns
  std::unique_ptr<LinearSolver> solver_;
  bool is_assembled_ = false;             // the system is the one that all steps have
  std::optional<double> prepared_shift_;  // of the matrix that the solver has, if the system is that one
  std::unique_ptr<CurveFluxes> fluxes_;
  CurveFluxes::Totals curve_totals_;
  double worst_residual_ = 0;
  long solves_ = 0, iterations_ = 0;
};

}  // namespace pliant
