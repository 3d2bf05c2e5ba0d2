// lib/pliant/fem/navier_stokes/mesh_velocity.h: how the mesh moves between curves that follow the flow and curves that
// stay.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "pliant/fem/csr_matrix.h"
#include "pliant/fem/navier_stokes/flow_problem.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/fem/space.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// How the mesh moves between its curves.
enum class MeshMotion {
  lagrangian,  ///< with the flow, but for curves that stay: elements at these take all of the shear
  harmonic,    ///< each component is harmonic between the curves
  blend,       ///< with the flow, which fades towards curves that stay
  fixed        ///< not at all
};

/// W: takes a velocity of the flow to a velocity of the mesh. W is linear; on curves that follow the flow it is the
/// identity, and on curves that stay it is 0. Where curves of both kinds meet, the vertex stays.
///
/// `harmonic` minimises the Dirichlet energy among the continuous functions of the mesh's degree, on the mesh as it is.
/// What is linear on all curves is reproduced everywhere, so translations, rotations and uniform strains move the mesh
/// as one body; and unlike a mesh that moves with the flow, it is not sheared by vortices between curves.
///
/// `blend` multiplies control values by smoothstep(t) = t^2 (3 - 2 t), which is 0 on curves that stay and 1 on the
/// others and `blend_width` edges away from those that stay. With d the distance from the curves that stay, d' that
/// from the curves that follow,
///     t = min(1, max(d / (d + d'), min over edges e that stay of (distance from e) / (blend_width * length of e))).
/// So the buffer is some elements wide where the mesh is graded, too, and narrower where a curve that follows is near.
/// t is Lipschitz but at vertices where curves of both kinds meet. Edges count as polygons between the points of their
/// lattices.
class MeshVelocity {
 public:
  /// Requires    a compact mesh; valid elements where `motion` is harmonic; a motion for each curve
  /// Throws      NoSolution where the matrix cannot be factored
  /// Complexity  harmonic: assembly and one factorisation for all calls of `extend`, of as many rows as there are
  ///             control points; blend: O(n log m) for n control points and m edges on curves; else O(mesh)
  MeshVelocity(const Mesh& mesh, std::span<const CurveMotion> motion_of_curve, MeshMotion motion);
  MeshVelocity(const MeshVelocity&) = delete;  // the solver refers to the matrix
  MeshVelocity& operator=(const MeshVelocity&) = delete;

  /// Control values of W u for those of u. On curves that follow they are those of u, bit for bit.
  ///
  /// Shapes      velocity, result: 2 for each slot of a PointId
  /// Requires    finite values, where `motion` is harmonic
  /// Throws      NoSolution where the harmonic values cannot be computed
  /// Complexity  harmonic: two solutions with the factors; else O(control points)
  std::vector<double> extend(std::span<const double> velocity) const;

 private:
  void prepare_harmonic(const Mesh& mesh);
  void extend_harmonically(std::span<double> values) const;

  std::vector<char> is_given_;   // control points on curves
  std::vector<double> weights_;  // what control values are multiplied by; harmonic: those that are given
  // The unknowns of the harmonic functions are numbered as Space does.
  std::vector<PointId> points_;  // of each unknown
  CsrMatrix stiffness_, matrix_;
  std::unique_ptr<LinearSolver> solver_;
};

/// How many lengths of the edges on curves that stay the buffer of `blend` is wide.
inline constexpr double blend_width = 4;

}  // namespace pliant
