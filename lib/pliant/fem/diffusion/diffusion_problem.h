// lib/pliant/fem/diffusion/diffusion_problem.h: a convection-diffusion equation on the faces and curves of one mesh.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pliant/fem/coefficient.h"

namespace pliant {

/// What one face is made of. All in the document's units.
struct DiffusionMaterial {
  /// One value, or the three entries xx, xy, yy of a symmetric tensor; positive definite everywhere.
  std::vector<Coefficient> diffusivity{Coefficient(1)};
  /// How much the amount per area grows with the unknown (1: the unknown is the amount per area); positive.
  Coefficient capacity{1};
  std::optional<Coefficient> source;  ///< amount per area and time
};

/// What holds on the curves of one name.
struct DiffusionCondition {
  enum class Kind {
    value,  ///< the unknown is `first`
    flux,   ///< `first` enters per length and time; on a curve between two faces it is set free there
    robin,  ///< `first` (unknown - `second`) leaves per length and time; first >= 0
    jump    ///< between two faces the unknown may jump: `first` (unknown here - unknown there) crosses; first >= 0
  } kind = Kind::value;
  Coefficient first{0};
  Coefficient second{0};
  std::string place;  ///< JSON pointer, for messages
};

/// The equation  capacity (dc/dt + v grad c) = div(diffusivity grad c) + source  for one field c of one component,
/// where v is how the mesh moves, and, relative to it, `convection`.
struct DiffusionProblem {
  std::string field;                         ///< the name of the unknown
  std::vector<DiffusionMaterial> materials;  ///< for each face of the boundary complex, in its order
  std::vector<DiffusionCondition> conditions;
  std::vector<int>
      condition_of_curve;  ///< for each curve: which of the conditions; none: nothing crosses it from outside
  std::vector<std::optional<Coefficient>> initial;  ///< for each face; used where the mesh has no such field
  std::vector<Coefficient> convection;              ///< two components of a velocity relative to the mesh; empty: none
  bool depends_on_unknown = false;  ///< some coefficient uses the unknown itself: the equation is not linear
  bool depends_on_time = false;     ///< some coefficient uses the time, or a field; those of `initial` do not count
  bool matrices_depend_on_time = false;  ///< the same of diffusivity, capacity, transfers and convection alone
};

}  // namespace pliant
