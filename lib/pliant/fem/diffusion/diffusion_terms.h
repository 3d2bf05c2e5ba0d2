// lib/pliant/fem/diffusion/diffusion_terms.h: the terms of the equation on one element and on one edge.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "pliant/fem/configuration.h"
#include "pliant/fem/diffusion/diffusion_problem.h"
#include "pliant/fem/edge_map.h"
#include "pliant/fem/element_matrices.h"

namespace pliant {

/// The matrices of one element in   d(mass c)/dt = load - stiffness c.   All of them, and those of edges, are divided
/// by the square of the document's unit, so that lengths are those of the mesh.
class ElementTerms {
 public:
  ElementTerms(const DiffusionProblem& problem, const Mesh& mesh);

  /// Throws      InputError where a coefficient is not finite or out of its range, with the place and the time
  void set(const Configuration& at, TriangleId t);

  std::span<const double> mass() const { return mass_; }              ///< pairs (element_matrices.h)
  std::span<const double> diffusion() const { return diffusion_; }    ///< pairs
  std::span<const double> convection() const { return convection_; }  ///< full; empty where there is none
  std::span<const double> load() const { return load_; }
  /// mass x, and load - stiffness x.
  void apply(std::span<const double> x, std::span<double> amount, std::span<double> rate);

 private:
  double value(const Coefficient& coefficient, int q) const;
  double positive(const Coefficient& coefficient, int q) const;
  SymmetricTensor tensor(const DiffusionMaterial& material, int q) const;
  [[noreturn]] void refuse(const Coefficient& coefficient, double value, int q, const char* what) const;

  const DiffusionProblem& problem_;
  const Mesh& mesh_;
  double unit_;
  std::vector<char> varying_;  // for each face: some coefficient is no constant
  ElementMap map_;
  TriangleId triangle_ = none;
  double time_ = 0;
  std::vector<double> factors_, mass_, diffusion_, convection_, load_, product_;
  std::vector<SymmetricTensor> tensors_;
  std::vector<Vector> velocities_;
};

/// The terms of one edge on a curve with a condition: what it adds to load and stiffness of the unknowns on the edge.
class EdgeTerms {
 public:
  explicit EdgeTerms(const Mesh& mesh);

  /// Throws      as ElementTerms::set
  void set(const Configuration& at, HalfEdgeId h, const DiffusionCondition& condition);

  std::span<const double> load() const { return load_; }            ///< degree + 1
  std::span<const double> stiffness() const { return stiffness_; }  ///< (degree + 1) squared, row after row
  /// The integral of each basis function along the edge.
  std::span<const double> lengths() const { return lengths_; }

 private:
  double value(const Coefficient& coefficient, int q, bool may_be_negative) const;

  const Mesh& mesh_;
  double unit_;
  EdgeMap map_;
  HalfEdgeId half_edge_{};
  double time_ = 0;
  std::vector<double> load_, stiffness_, lengths_;
};

}  // namespace pliant
