// lib/pliant/improve/refining/expected_insertions.h: roughly how many points a refinement will insert.
#pragma once
#include "pliant/improve/sizing.h"

namespace pliant {

/// Roughly how many points the bounds on size ask for, to display progress. It is 0 if these are at most 1000, or if
/// there are no bounds on size.
/// Complexity  O(triangles); the size is evaluated about 50,000 times, at least once but at most 5050 times a triangle
double expected_insertions(const Mesh& mesh, const QualityGoals& goals);

}  // namespace pliant
