// lib/pliant/flow/advect.h: one certified step of the moving mesh (paper §6).
#pragma once
#include <string>

#include "pliant/flow/velocity_field.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

enum class StepPolicy {
  refuse,  ///< an unsafe step is not taken
  limit,   ///< integrate again to t + 0.9 f dt, f the largest safe fraction
  force    ///< take it all the same
};
struct AdvectOptions {
  double dt = 0;
  int substeps = 1;  ///< Runge-Kutta steps within dt
  StepPolicy policy = StepPolicy::refuse;
  bool keep_area = false;  ///< one normal offset per closed curve
};
struct AdvectOutcome {
  enum class Status { done, limited, unsafe, not_finite, not_interpolable } status;
  double dt;        ///< the step that was taken (0 if none)
  double fraction;  ///< proved safe fraction of the asked step
  TriangleId blocking = -1;
  PassReport report;
};

/// Moves the mesh by Runge-Kutta 4 from mesh.time to mesh.time + dt: curves by moving their splines (moved points are
/// interpolated at the Greville abscissae), edges by extraction or by their interpolation nodes, then the inner control
/// points; certified along the straight motion of the control points. On refusal the mesh is unchanged.
AdvectOutcome advect(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options);

/// The same with the velocity that the mesh carries as a field of two components: control points move by v dt.
AdvectOutcome advect_by_field(Mesh& mesh, int field, const AdvectOptions& options);

}  // namespace pliant
