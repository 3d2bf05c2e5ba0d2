#pragma once  // lib/pliant/improve/refine.h: points into elements too large, too poor or too curved (paper §5.3.2)
#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"
#include "pliant/ops/outcome.h"

namespace pliant {

struct RefineOptions {
  QualityGoals goals;
  long max_insertions = 10'000'000;
  RefitOptions refit;
  Progress* progress = nullptr;  ///< told the points inserted
};
/// Refines until every element meets the goals or is given up (counted by reason).
PassReport refine(Mesh& mesh, const RefineOptions& options);

/// Why `refine` would attack this triangle: "too large", "too poor", "too curved", or null.
const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

}  // namespace pliant
