// lib/pliant/fem/diffusion/curve_fluxes.h: what crosses each curve, from the residual of the equation.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/fem/diffusion/diffusion_problem.h"

namespace pliant {

/// Sums, for the faces beside each curve, what the equation lacks there: what enters a face through the curve, tested
/// with the basis functions of the curve's control points. Such fluxes balance the amounts in the faces exactly, and
/// converge faster than derivatives on the curve.
///
/// Where two curves of one face meet, whose fluxes are both not given, they share the residual of their common vertex
/// by the lengths of their edges there; the sum over all curves is exact.
class CurveFluxes {
 public:
  /// Requires    a mesh whose topology stays
  CurveFluxes(const DiffusionProblem& problem, const Mesh& mesh);

  /// Adds what an element lacks: factor * residual[k], in the order of its net.
  void add_element(TriangleId t, double factor, std::span<const double> residual);
  /// Adds what a condition lets into the face of a half-edge through its edge, by its points from origin to target.
  void add_edge(HalfEdgeId h, double factor, std::span<const double> enters);

  struct Totals {
    /// For each curve what enters through it from outside, or from a slit on both of its sides; through a curve between
    /// two faces, what leaves the face on its left.
    std::vector<double> fluxes;
    /// For each curve between two faces, what enters both of them: what a condition sets free there.
    std::vector<double> freed;
  };
  Totals totals() const;

 private:
  struct Side {  // a control point of a curve, as one of the faces beside it sees it
    CurveId curve;
    bool is_left;
    int place;
    double length = 0, known = 0;
  };
  int find_place(PointId p, FaceId f) const;
  Side* find_side(CurveId c, bool is_left, int place);

  const DiffusionProblem& problem_;
  const Mesh& mesh_;
  std::vector<std::array<std::int32_t, 2>> places_;  // (point, face), sorted
  std::vector<double> residuals_;                    // of each place
  std::vector<Side> sides_;                          // sorted by place, curve and side
  std::vector<int> starts_, local_, touched_;        // of each element: local points that are places, and which
};

}  // namespace pliant
