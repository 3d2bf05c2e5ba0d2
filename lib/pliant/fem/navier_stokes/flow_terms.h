// lib/pliant/fem/navier_stokes/flow_terms.h: the terms of the flow equations on one element, with those of its edges.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/edge_map.h"
#include "pliant/fem/element_map.h"
#include "pliant/fem/navier_stokes/flow_problem.h"

namespace pliant {

/// Which terms the equation of one solution has. Fields are control values of continuous fields of the mesh, two for
/// each PointId, in the document's units; empty ones are without meaning.
struct FlowTerms {
  /// density * (inertia * u - history) is the mass times the rate of the velocity.
  double inertia = 0;
  std::span<const double> history;
  /// density * (convecting . grad) u, where `convecting` is relative to the mesh.
  std::span<const double> convecting;
  double convection = 1;  ///< how much of convection counts, from 0 to 1
  /// The convecting velocity is the unknown itself: the equation is that of one step of Newton's method.
  bool newton = false;
  /// Surface tension acts on curves as they will be after so much more time at the change of velocity from `before`;
  /// this makes it implicit. 0: on curves as they are.
  double tension_time = 0;
  std::span<const double> before;
  /// In place of all that: the function of no divergence that is nearest to `history`, weighted by density.
  bool projects = false;
  /// Where the density is less, it counts as this much in that weight: fluids without inertia need some.
  double least_weight = 0;
};

/// What is the same for all elements, and follows from the problem.
struct FlowForm {
  /// Stress or gradient: viscosity (grad u + grad u^T), which forces between fluids and on curves need; or viscosity
  /// grad u, whose natural condition lets a parallel flow out. They agree where the velocity is given on the rest of
  /// the boundary and the viscosity is one constant.
  bool is_stress = false;
  /// Are all matrices without convection symmetric? Not so for stress with outflow, unless the viscosity is one
  /// constant.
  bool is_symmetric = true;
};
FlowForm choose_form(const FlowProblem& problem, const Mesh& mesh);

/// The matrix and the load of one element for the velocity's and the pressure's control values:
///
///     inertia + viscosity + convection   -div^T      load
///     -div                                0           0
///
/// Order       the x of the velocity's control values, then the y, then the pressure's
/// Units       all is divided by the square of the document's unit, so that lengths are those of the mesh; the pressure
///             is divided by the unit
class FlowElement {
 public:
  FlowElement(const FlowProblem& problem, const Mesh& mesh, const FlowForm& form, int pressure_degree);

  /// Throws      InputError where a coefficient is not finite or out of its range
  void set(std::span<const Point> points, double time, TriangleId t, const FlowTerms& terms);

  int size() const { return size_; }  ///< 2 n + m
  /// Row after row.
  std::span<const double> matrix() const { return matrix_; }
  std::span<const double> load() const { return load_; }
  /// load - matrix x.
  void residual(std::span<const double> x, std::span<double> r) const;

 private:
  double value(const Coefficient& coefficient, int q) const;
  double checked(const Coefficient& coefficient, int q, bool may_be_zero) const;
  void evaluate_materials();
  void add_volume(const FlowTerms& terms);
  void add_pressure();
  void add_edges(const FlowTerms& terms);
  void add_outflow(HalfEdgeId h, const FlowTerms& terms);
  void add_traction(HalfEdgeId h, const FlowCondition& condition);
  void add_tension(HalfEdgeId h, const Coefficient& tension, const FlowTerms& terms);
  double edge_value(HalfEdgeId h, const Coefficient& coefficient, int q, bool may_be_negative) const;
  Vector at_edge(HalfEdgeId h, std::span<const double> field, int k) const;
  double& entry(int row, int column) { return matrix_[index(row * size_ + column)]; }

  const FlowProblem& problem_;
  const Mesh& mesh_;
  FlowForm form_;
  double unit_;
  int n_, m_, size_;
  std::vector<char> varying_;  // for each face: some coefficient is no constant
  bool has_force_;
  ElementMap map_;
  EdgeMap edge_;
  std::span<const Point> points_;
  TriangleId triangle_ = none;
  double time_ = 0;
  std::vector<double> density_, viscosity_, matrix_, load_, along_x_, along_y_;
  std::vector<double> xx_, xy_, yx_, yy_;  // sums for pairs of components
  std::vector<double> gx_, gy_;            // gradients of the basis at one point
  int pressure_degree_;
};

}  // namespace pliant
