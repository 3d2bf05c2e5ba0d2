// lib/pliant/improve/refine.h: inserts points until no element is too large, too poor or too curved (paper §5.3.2).
#pragma once
#include <optional>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct RefineOptions {
  std::optional<QualityGoals> goals;   ///< absent: those of the mesh's criteria (goals_of)
  std::optional<long> max_insertions;  ///< refinement ends after so many, and reports what is left
  long max_triangles = 10'000'000;     ///< a mesh of more triangles is an error
  RefitOptions refit;
  Progress* progress = nullptr;  ///< is told how many points were inserted
};

/// Refines until every element meets the goals or is given up. The report counts each element that does not meet them
/// at the end, with the reason and the place.
///
/// The work is done in rounds until one of them inserts nothing. A round remembers nothing of the rounds before it. So
/// what it tries depends only on the mesh, and refining the result again with the same goals changes nothing. A round
/// begins with the Tamer, which removes what keeps poor triangles from being flipped: valid meshes that have moved far
/// come back by that.
///
/// A point that mends a shape is no closer to other vertices than the length of the triangle's shortest edge. An edge
/// on a curve is split into parts shorter than 0.8 of that length only where a vertex opposite is no further from its
/// chord than the chord is long. With bounds on angles that can be kept, Ruppert's algorithm has these distances
/// anyway; where curved edges, small angles or a greater bound spoil that, these two rules end the refinement.
///
/// Throws      std::invalid_argument as goals_of; TooManyTriangles (triangle_budget.h) before anything is changed,
/// where the goals ask for more than
///             `max_triangles` by a lower bound; or as soon as there are more, and the mesh is then unspecified
PassReport refine(Mesh& mesh, const RefineOptions& options = {});

/// Why `refine` would attack this triangle: "too large", "too poor", "too curved", or null.
const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

}  // namespace pliant
