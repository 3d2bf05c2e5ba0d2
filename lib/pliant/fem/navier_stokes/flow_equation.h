// lib/pliant/fem/navier_stokes/flow_equation.h: the discrete flow equations on one mesh: unknowns, matrix, load.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/csr_matrix.h"
#include "pliant/fem/navier_stokes/flow_terms.h"
#include "pliant/fem/navier_stokes/velocity_unknowns.h"
#include "pliant/fem/space.h"
#include "pliant/fem/sparsity.h"

namespace pliant {

/// A velocity and a pressure.
struct FlowState {
  std::vector<double> velocity;  ///< control values, point_slots x 2, in the document's units
  std::vector<double> pressure;  ///< of each unknown of the pressure's space, divided by the document's unit
};

/// The equations of Taylor–Hood elements: velocities of the mesh's degree p, pressures of degree p - 1, which are
/// continuous in each face. Unknowns are those of the velocity, then those of the pressure. The topology of the mesh
/// must not change as long as this lives; its control points may.
class FlowEquation {
 public:
  /// `by_splines` as for VelocityUnknowns.
  /// Requires    a compact mesh, valid elements, a degree of at least 2; materials and conditions for its faces and
  ///             curves
  FlowEquation(const FlowProblem& problem, const Mesh& mesh, bool by_splines);

  const FlowProblem& problem() const { return problem_; }
  const Mesh& mesh() const { return mesh_; }
  const FlowForm& form() const { return form_; }
  const VelocityUnknowns& velocities() const { return velocities_; }
  const Space& pressures() const { return pressures_; }
  const CsrPattern& pattern() const { return *sparsity_.pattern; }
  int unknowns() const { return velocities_.size() + pressures_.size(); }
  /// Does the pressure jump across some curve?
  bool pressure_jumps() const { return jumps_; }
  /// For each curve: does it?
  const std::vector<char>& jumping_curves() const { return jumping_; }
  /// Which unknowns are pressures.
  std::vector<bool> multipliers() const;

  /// The matrix and the load of an equation whose given velocities are `given` (VelocityUnknowns::give).
  ///
  /// Throws      InputError where a coefficient is not finite or out of range
  /// Complexity  O(mesh)
  void assemble(const Configuration& at, const FlowTerms& terms, std::span<const double> given, CsrMatrix& matrix,
                std::vector<double>& load) const;
  /// In each part whose flow is enclosed the pressure is known up to a constant. Takes one of its unknowns out of the
  /// equation, so that the matrix is not singular.
  void pin_pressures(CsrMatrix& matrix, std::vector<double>& load) const;
  /// The state that unknowns and given velocities are. In enclosed parts the mean of the pressure becomes 0.
  FlowState state(const Configuration& at, std::span<const double> unknowns, std::span<const double> given) const;
  /// load - matrix x at each control value of the velocity, as if nothing were given: what has to act from outside.
  /// Units       forces, for the document's units
  std::vector<double> reactions(const Configuration& at, const FlowTerms& terms, const FlowState& state) const;

 private:
  void make_groups();
  std::span<const int> members(TriangleId t) const;
  /// The control values of an element's velocity as sums of its unknowns: 2 n rows.
  void fill_sums(TriangleId t, std::span<const int> unknowns, std::vector<double>& sums) const;

  const FlowProblem& problem_;
  const Mesh& mesh_;
  FlowForm form_;
  std::vector<char> jumping_;
  VelocityUnknowns velocities_;
  bool jumps_;
  Space pressures_;
  /// Elements whose matrices have the same size. Those of the first kind have nothing but plain unknowns.
  struct Kind {
    int size = 0;
    std::vector<int> members;
  };
  std::vector<Kind> kinds_;
  std::vector<int> kind_of_, place_of_;  // for each element: its kind, and which of that kind it is
  Sparsity sparsity_;
};

}  // namespace pliant
