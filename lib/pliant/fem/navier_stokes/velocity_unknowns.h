// lib/pliant/fem/navier_stokes/velocity_unknowns.h: which unknowns the velocity at each control point is made of.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/configuration.h"
#include "pliant/fem/navier_stokes/flow_problem.h"

namespace pliant {

/// The velocity as a function of unknowns: the control values of the continuous field, of the mesh's degree, are
/// combinations of unknowns, and parts that conditions give.
///
/// On curves that follow the flow the unknowns are the coefficients of a spline on the curve's own knots: only such
/// velocities can the curve follow, and only against them can stress and surface tension be in equilibrium. On curves
/// with slip there is one unknown along the curve in place of two.
class VelocityUnknowns {
 public:
  struct Term {
    int unknown;
    double weight;
  };

  /// `jumps` says across which curves the pressure may jump. `by_splines` says whether curves that follow the flow have
  /// splines as velocities; if not, velocities on them are those of the edges.
  /// Requires    a compact mesh, valid elements
  /// Complexity  O(mesh)
  VelocityUnknowns(const FlowProblem& problem, const Mesh& mesh, std::span<const char> jumps, bool by_splines);

  int size() const { return size_; }
  /// What the x (component 0) or the y (component 1) of a control point is a sum of, beside what is given.
  std::span<const Term> terms(PointId p, int component) const {
    const std::size_t row = 2 * index(p) + index(component);
    return std::span(terms_).subspan(index(starts_[row]), index(starts_[row + 1] - starts_[row]));
  }
  /// Is a control value an unknown, and nothing else?
  bool is_plain(PointId p, int component) const {
    const auto sum = terms(p, component);
    return sum.size() == 1 && sum[0].weight == 1 && !has_given_[index(p)];
  }
  /// Does a condition give a part of the velocity at a control point?
  bool has_given(PointId p) const { return has_given_[index(p)] != 0; }

  /// For each element: the part of the mesh that it belongs to, where each part is connected, and ends at walls inside
  /// the mesh across which the pressure jumps; and whether the flow of a part is enclosed: its velocity is given across
  /// the whole of its boundary, so that what enters must leave.
  int part_of(TriangleId t) const { return part_of_triangle_[index(t)]; }
  bool is_enclosed(int part) const { return enclosed_[index(part)] != 0; }
  const std::vector<char>& enclosed() const { return enclosed_; }

  /// The given parts at all control points, 0 elsewhere: interpolants on edges. In an enclosed flow they are corrected,
  /// by what interpolation changed of the flux, so that as much leaves as enters.
  /// Shapes      values: point_slots x 2
  /// Throws      InputError where a coefficient is not finite, and where more enters an enclosed flow than leaves it
  void give(const Configuration& at, std::span<double> values) const;
  /// Adds to the values of control points what the unknowns are to them.
  void expand(std::span<const double> unknowns, std::span<double> values) const;

 private:
  struct Weighted {
    int place;
    double weight;
  };
  class Builder;
  struct Balance;
  std::vector<Balance> balance_fluxes(const Configuration& at) const;
  void correct_fluxes(const Configuration& at, std::span<double> values) const;

  const FlowProblem& problem_;
  const Mesh& mesh_;
  std::vector<std::vector<HalfEdgeId>> edges_;  // of each curve
  int size_ = 0;
  std::vector<int> starts_;  // of each row among the terms
  std::vector<Term> terms_;
  std::vector<char> has_given_;  // for each control point
  std::vector<int> part_of_triangle_;
  std::vector<char> enclosed_;  // for each part
};

}  // namespace pliant
