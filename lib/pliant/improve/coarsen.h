#pragma once  // lib/pliant/improve/coarsen.h: remove vertices that neither size nor geometry needs (paper §5.3.3)
#include "pliant/improve/sizing.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/outcome.h"

namespace pliant {

struct CoarsenOptions {
  QualityGoals goals;
  double tolerance = 1e-4;  ///< of each curve's accumulated knot-removal error, relative to the mesh's size
  double factor = 1.0;      ///< scales the sizing function's spheres
  RefitOptions refit;
};
PassReport coarsen(Mesh& mesh, const CoarsenOptions& options);

}  // namespace pliant
