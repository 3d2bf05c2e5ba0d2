// lib/pliant/fem/navier_stokes/flow_problem.h: incompressible flow on the faces and curves of one mesh.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pliant/fem/coefficient.h"

namespace pliant {

/// The fluid of one face. All in the document's units.
struct FlowMaterial {
  Coefficient density{1};    ///< at least 0; 0 everywhere: the Stokes equations
  Coefficient viscosity{1};  ///< dynamic; positive
};

/// What holds on the curves of one name. Where a curve has none, it is an interface between fluids, through which
/// velocity and, but for surface tension, stress are continuous.
struct FlowCondition {
  enum class Kind {
    velocity,  ///< the velocity is `first`, `second`
    slip,      ///< nothing crosses the curve, and nothing holds the fluid back along it
    traction,  ///< the stress on the curve from outside is `first`, `second` (natural: 0, 0)
    outflow    ///< viscosity du/dn - p n = 0 (do nothing), and what comes back in brings no energy
  } kind = Kind::velocity;
  Coefficient first{0};
  Coefficient second{0};
  std::string place;  ///< JSON pointer, for messages
};

/// How a curve goes with the flow.
enum class CurveMotion {
  follows,  ///< it moves with the velocity on it
  stays     ///< the mesh does not move on it, and fluid may pass it or glide along it
};

/// density (du/dt + (u - w) grad u) = div(viscosity (grad u + grad u^T) - p) + density gravity + force,   div u = 0,
/// for a velocity u at points of a mesh that move with velocity w, and a pressure p.
struct FlowProblem {
  std::vector<FlowMaterial> materials;  ///< for each face of the boundary complex, in its order
  std::vector<FlowCondition> conditions;
  std::vector<int> condition_of_curve;               ///< for each curve: which of the conditions, or none
  std::vector<CurveMotion> motion_of_curve;          ///< for each curve
  std::vector<std::optional<Coefficient>> tensions;  ///< for each curve: surface tension, at least 0; none: without
  std::array<Coefficient, 2> gravity{Coefficient(0), Coefficient(0)};  ///< force per mass
  std::array<Coefficient, 2> force{Coefficient(0), Coefficient(0)};    ///< force per area
  std::optional<std::array<Coefficient, 2>> initial;  ///< the velocity, where the mesh has none; none: 0
  /// May the pressure jump across curves where the fluid changes, surface tension acts or there is a wall?
  bool pressure_by_face = true;
  bool depends_on_time = false;  ///< some coefficient uses the time, or a field; those of `initial` do not count
};

}  // namespace pliant
