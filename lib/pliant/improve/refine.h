// lib/pliant/improve/refine.h: points into elements too large, too poor or too curved (paper §5.3.2).
#pragma once
#include <optional>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct RefineOptions {
  std::optional<QualityGoals> goals;   ///< absent: those of the mesh's criteria (goals_of)
  std::optional<long> max_insertions;  ///< ends after so many insertions, and tells what is left
  long max_triangles = 10'000'000;     ///< more than so many are an error
  RefitOptions refit;
  Progress* progress = nullptr;  ///< told the points inserted
};

/// Refines until every element meets the goals or is given up; each element that does not meet them at the end is
/// counted in the report, with its reason and place. Before each round what keeps poor triangles from being flipped is
/// removed (Tamer): so valid meshes that have moved far come back. Works in rounds, each with an empty history, until
/// one inserts nothing: so what is tried depends on the mesh that is left alone, and refining it again with the same
/// goals changes nothing.
///
/// Mending a shape splits no edge on a curve into parts shorter than the triangle's own shortest edge, unless another
/// vertex is as close to that edge; nor does it insert a point closer to others than that. With the bounds on angles
/// that can be kept this is what holds anyway (Ruppert); where curved edges, small angles or a greater bound spoil
/// that, it is what ends the refinement.
///
/// Throws      std::invalid_argument as goals_of; TooManyTriangles (triangle_budget.h) beforehand, where a lower bound
/// of what the goals ask for exceeds
///             `max_triangles`, or as soon as there are more; the mesh is then unspecified
PassReport refine(Mesh& mesh, const RefineOptions& options = {});

/// Why `refine` would attack this triangle: "too large", "too poor", "too curved", or null.
const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

}  // namespace pliant
