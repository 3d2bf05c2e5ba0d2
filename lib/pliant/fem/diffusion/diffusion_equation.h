// lib/pliant/fem/diffusion/diffusion_equation.h: the discrete equation on one mesh: matrices, loads, fixed values.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "pliant/fem/csr_matrix.h"
#include "pliant/fem/diffusion/curve_fluxes.h"
#include "pliant/fem/diffusion/diffusion_terms.h"
#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/space.h"
#include "pliant/fem/sparsity.h"

namespace pliant {

/// d(mass c)/dt = load - stiffness c.   Both matrices have the same pattern.
struct DiffusionSystem {
  CsrMatrix mass, stiffness;
  std::vector<double> load;
};

/// The equation of a problem on the elements of a mesh. The topology of the mesh must not change as long as this
/// lives; its control points may.
class DiffusionEquation {
 public:
  /// Requires    a compact mesh, valid elements; materials and conditions for its faces and curves
  DiffusionEquation(const DiffusionProblem& problem, const Mesh& mesh);

  const DiffusionProblem& problem() const { return problem_; }
  const Mesh& mesh() const { return mesh_; }
  const Space& space() const { return space_; }
  const CsrPattern& pattern() const { return *sparsity_.pattern; }
  /// Does nothing leave or enter but through curves with a given flux?
  bool is_closed() const { return closed_; }
  /// Is the stiffness symmetric?
  bool is_symmetric() const { return problem_.convection.empty(); }
  /// For each unknown: has it a given value?
  const std::vector<char>& is_fixed() const { return fixed_; }
  bool fixes_any() const { return fixes_any_; }

  /// The hat functions of the vertices, without those of fixed unknowns.
  CoarseSpace coarse_space() const;

  /// Throws      InputError where a coefficient is not finite or out of range
  /// Complexity  O(mesh)
  void assemble(const Configuration& at, DiffusionSystem& system) const;
  /// The same for the load only.
  void assemble_load(const Configuration& at, std::vector<double>& load) const;
  /// Writes the given values of fixed unknowns.
  void fix(const Configuration& at, std::span<double> unknowns) const;
  /// amounts += amount_factor * mass c, rates += rate_factor * (load - stiffness c), for a function that is given by
  /// its values on element after element, where these need not agree. Fluxes, if they are wanted, are told the same.
  void apply(const Configuration& at, std::span<const double> values, double amount_factor, std::span<double> amounts,
             double rate_factor, std::span<double> rates, CurveFluxes* fluxes) const;
  /// The interpolant of the problem's initial values at lattice nodes; at unknowns that several faces share the mean of
  /// theirs.
  std::vector<double> initial_unknowns(const Configuration& at) const;
  /// Throws InputError where the steady equation has no or many solutions, with what is missing.
  void require_determined() const;

 private:
  void collect_jumps();
  /// The unknowns on an edge, from the half-edge's origin to its target.
  void gather_edge(HalfEdgeId h, std::span<int> unknowns) const;
  /// Calls it for each edge of the curves with a condition, jumps apart: the last condition first, so that where curves
  /// meet the first one that gives a value is the one that counts.
  using UseEdge = std::function<void(HalfEdgeId h, const DiffusionCondition&, std::span<const int> unknowns)>;
  void for_each_conditioned_edge(const UseEdge& use) const;

  const DiffusionProblem& problem_;
  const Mesh& mesh_;
  Space space_;
  std::vector<std::vector<HalfEdgeId>> edges_;  // of each curve
  std::vector<HalfEdgeId> jump_edges_;
  std::vector<int> jump_members_;  // for each of them the unknowns on this side, then those on the other
  Sparsity sparsity_;
  std::vector<char> fixed_;
  bool closed_ = true, fixes_any_ = false;
};

}  // namespace pliant
