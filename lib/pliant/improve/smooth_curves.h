#pragma once  // lib/pliant/improve/smooth_curves.h: elements too curved, worst first (paper §5.3.4)
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/outcome.h"
#include "pliant/quality/element_quality.h"

namespace pliant {

struct SmoothOptions {
  CurvatureBounds bounds;
  bool split = false;   ///< split constrained edges of elements that nothing else can mend
  int max_sweeps = 20;  ///< visits of one element
  RefitOptions refit;
};
struct SmoothOutcome {
  std::vector<TriangleId> invalid;  ///< elements left invalid (numbers in the compacted mesh)
  PassReport report;
};
SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options = {});

}  // namespace pliant
