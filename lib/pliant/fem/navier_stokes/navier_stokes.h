// lib/pliant/fem/navier_stokes/navier_stokes.h: steady flows, and steps of flows in time, on a mesh that moves.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pliant/fem/navier_stokes/flow_equation.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/fem/solve/no_solution.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

struct FlowOptions {
  enum class Scheme {
    bdf2,  ///< order 2, also for steps of uneven lengths; the first step is one of euler
    euler  ///< backward Euler, order 1
  } scheme = Scheme::bdf2;
  /// The velocity that convects is extrapolated; so often a step is solved again with the one that came out.
  int corrections = 0;
  /// The mesh moves with the fluid, but for curves that stay, on which the fluid is at rest: nothing is convected.
  bool mesh_follows = false;
  /// Curves that follow the flow have splines as velocities (VelocityUnknowns).
  bool by_splines = true;
};

/// What solving has taken.
struct FlowCounts {
  int solves = 0;             ///< of linear equations
  double worst_residual = 0;  ///< the greatest of their relative residuals
  int euler_steps = 0;        ///< steps that were of order 1
};

/// The flow of a problem on one mesh in memory. What one step leaves for the next one is in fields of the mesh, where
/// passes carry it along: `velocity`; `acceleration`, the last change of the velocity at control points, by the length
/// of the step; and, where the mesh does not follow the fluid, `mesh_velocity`, the last step's motion of the mesh by
/// its length. `pressure` is a result that no step reads.
class NavierStokes {
 public:
  /// Throws      InputError where fields with these names do not fit, and for meshes of degree 1
  NavierStokes(const FlowProblem& problem, Mesh& mesh, const FlowOptions& options);

  /// Refuses fields that a step reads, where they are not continuous or have not two components.
  /// Throws      InputError
  static void require_fields(const Mesh& mesh);

  const FlowEquation& equation() const { return equation_; }

  /// Solves for the flow that does not change in time, at mesh.time. Newton's method begins with the solution without
  /// convection; where it does not converge, convection is raised by and by.
  /// Throws      InputError, NoSolution
  void solve_steady();
  /// Makes the field `velocity` where the mesh has none: that of the problem's initial values that has no divergence,
  /// or, where nothing has inertia, the solution at mesh.time.
  /// Throws      InputError, NoSolution
  void initialise();
  /// Takes the flow through a step from time t0 to mesh.time, in which control points have moved on straight lines from
  /// `from` to where they are; an empty `from` says that they have not moved.
  /// `last_dt` is the length of the step before: none where there was none.
  /// Throws      InputError, NoSolution
  void step(std::span<const Point> from, double t0, std::optional<double> last_dt);

  /// Makes the field `vorticity`, dv/dx - du/dy of the field `velocity`: its projection, continuous in each face.
  /// Throws      NoSolution
  void put_vorticity();
  FlowCounts counts;  ///< of all that this object did; who makes several for one simulation hands them on

  /// By the name of the curve: the force of the fluid on curves that stay and whose velocity is given, by the residual
  /// of the last solution.
  const std::map<std::string, Vector>& forces() const { return forces_; }
  /// Adds what is known of the last solution, in the document's units.
  void report(PassReport& report) const;

 private:
  void require_triangles() const;
  bool has_inertia() const;
  double greatest_density() const;  ///< at corners of elements
  std::vector<double> field_values(const char* name) const;
  void put(const char* name, std::vector<double> values);
  void put_state();
  /// A field of one component that has these control values in element after element.
  void put_scalar(const char* name, std::span<const double> element_values, bool by_face);
  /// Solves one linear equation; the result is in state_. The factors of the last such equation with convection may
  /// serve again, where that is near.
  void solve(const Configuration& at, const FlowTerms& terms, bool reuses_factors = false);
  /// How fast the terms of each equation would make its unknown, if they did not cancel: where a flow rests, its
  /// velocity is the rounding of these.
  double velocity_of_terms(std::span<const double> load, std::span<const double> x) const;
  void solve_without_convection(const Configuration& at);
  /// Newton's method from state_ with this part of convection; false, and state_ unchanged, where it does not converge.
  bool iterate(const Configuration& at, double convection);
  void find_forces(const Configuration& at, const FlowTerms& terms);

  const FlowProblem& problem_;
  Mesh& mesh_;
  FlowOptions options_;
  FlowEquation equation_;
  FlowState state_;
  CsrMatrix matrix_;
  // Kept, since on one mesh the order of elimination serves again.
  std::unique_ptr<LinearSolver> symmetric_solver_, general_solver_, pivoting_solver_;
  bool has_factors_ = false;  // general_solver_, of a matrix that it has solved
  std::map<std::string, Vector> forces_;
  double last_change_ = 0, rounded_ = 0;
};

}  // namespace pliant
