#pragma once  // lib/pliant/improve/feature_sizes.h: how small is what a vertex came from?
#include <vector>

#include "pliant/improve/sharp_corners.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/star.h"

namespace pliant {

/// By vertex, the size of the feature that begot it: of those that a mesh has at first the shortest edge, or the
/// distance of a curve opposite; of new ones what their triangles came from. Refinement for the sake of shapes makes no
/// edge much shorter than that, whatever angles and curves it meets.
class FeatureSizes {
 public:
  /// Complexity  O(mesh)
  explicit FeatureSizes(const Mesh& mesh);

  double of(PointId v) const { return sizes_[static_cast<std::size_t>(v)]; }
  /// A new vertex, from its star, has the size `inherited` unless it lies on a curve and comes closer to another; where
  /// nothing is inherited (0) its shortest edge.
  void set(const Mesh& mesh, const Star& star, double inherited, const SharpCorners& corners);

 private:
  std::vector<double> sizes_;
};

}  // namespace pliant
