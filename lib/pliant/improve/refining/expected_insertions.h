// lib/pliant/improve/refining/expected_insertions.h: roughly how many points a refinement will insert.
#pragma once
#include "pliant/improve/sizing.h"

namespace pliant {

/// How many points the bounds on size ask for, roughly, for a display of progress; 0 where they are few, or only shapes
/// matter.   Complexity O(mesh), with one evaluation of the size for each triangle, or about 100,000 in a small mesh
double expected_insertions(const Mesh& mesh, const QualityGoals& goals);

}  // namespace pliant
