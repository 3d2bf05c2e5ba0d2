// lib/pliant/flow/advect.h: one certified step of the moving mesh (paper §6).
#pragma once
#include <optional>
#include <span>

#include "pliant/flow/time_method.h"
#include "pliant/flow/velocity_field.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// What happens to a step that is not proved *safe*: to leave every element valid all along the motion.
enum class StepPolicy {
  refuse,  ///< it is not taken
  limit,   ///< 0.9 times the largest safe fraction of it is tried instead
  force    ///< it is taken all the same
};
/// What happens where the boundary comes closer to itself than the least gap.
enum class GapPolicy {
  stop,  ///< the step is not taken
  /// Between curves without a common end, what closes the gap further is taken out of the motion (hold_gaps). The step
  /// is not taken if a gap is thinner than `held_share` of the least one all the same.
  hold
};
inline constexpr double held_share = 0.5;

struct AdvectOptions {
  double dt = 0;  ///< the step to take (time); negative: back in time
  TimeMethod method = TimeMethod::rk4;
  int substeps = 1;  ///< equal steps of the method within dt; dopri5 chooses its own
  /// Sum of the estimates of dopri5's errors within dt (length); none: 1e-9 of the mesh's size.
  std::optional<double> tolerance;
  StepPolicy policy = StepPolicy::refuse;
  bool keep_area = false;  ///< each closed curve is offset along its normals to enclose the same area
  double min_gap = 0;      ///< the least gap between boundaries (length in the mesh; least_gap); 0: any, also none
  GapPolicy gap = GapPolicy::stop;
};
/// What became of a step.
struct AdvectOutcome {
  enum class Status {
    done,              ///< the whole step was taken
    limited,           ///< a smaller step was taken
    unsafe,            ///< no step was taken, since it is not proved safe
    not_finite,        ///< no step was taken, since the velocity is not finite somewhere
    no_velocity,       ///< no step was taken, since there is no velocity at some place or time (NoVelocity)
    too_many_steps,    ///< no step was taken, since dopri5 does not meet its tolerance
    not_interpolable,  ///< no step was taken, since no spline interpolates the moved points of a curve
    contact,           ///< no step was taken, since a gap is too thin before the step or after it
    no_progress,       ///< no step was taken, since it is too short to change the digits of the time
    late               ///< no step was taken by advect_to, since the mesh is at its time or later
  } status;
  double dt;                 ///< the step that was taken (0 if none)
  double fraction;           ///< the fraction of the asked step that is proved safe
  double asked_dt;           ///< the step that was asked for
  TriangleId blocking = -1;  ///< the element that limits the step; none if the asked step is safe
  PassReport report;
};

/// Moves the mesh from mesh.time to mesh.time + dt by the method of the options. First the splines of the
/// curves move: they interpolate the moved points at the Greville abscissae. Edges on curves are extracted from them;
/// all other control points interpolate the motion at their nodes.
///
/// Ensures     unless options.policy is `force`, every element was certified along the straight motion of its control
///             points
/// Refuses     what `Status` says; the mesh is unchanged then
/// Paper       §6
AdvectOutcome advect(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options);

/// The same with a velocity v that the mesh carries as a field of two components: control points move by v dt. With an
/// acceleration a, another such field, they move by v dt + a dt^2 / 2, which is of order 2 in time.
/// Requires    fields of two components that are not by face
AdvectOutcome advect_by_field(Mesh& mesh, int field, const AdvectOptions& options, int acceleration = none);
/// The same with control values that the mesh does not carry: two for each PointId, in the document's units; an empty
/// acceleration is 0.
AdvectOutcome advect_by_values(Mesh& mesh, std::span<const double> velocity, std::span<const double> acceleration,
                               const AdvectOptions& options);

}  // namespace pliant
