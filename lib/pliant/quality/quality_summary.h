// lib/pliant/quality/quality_summary.h: a mesh in a few figures, for what passes say of before and after.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// One component of one field. NaN where the field has no value.
struct ComponentSize {
  std::string field;
  int component = 0;
  double largest = 0;  ///< |control value|: a bound of |u|
  double l2 = 0;  ///< the root of ∫ u² dA over the mesh, exact to rounding; NaN where tangled elements make it < 0
};
/// The metrics are those of report_quality, to the last bit; NaN where no element has a value.
struct QualitySummary {
  std::int64_t triangles = 0, invalid = 0, degenerate = 0;
  double min_logical_angle = 0;  ///< degrees
  double min_scaled_jacobian = 0, min_shape = 0, max_distortion = 0;
  std::vector<ComponentSize> fields;
};
/// Requires    check_arrays(data) to be empty
/// Complexity  O(data): a fraction of what report_quality costs
QualitySummary summarize_quality(const MeshData& data);

/// How much a component that both meshes carry has grown: the ratio of after to before, 1 where both are zero.
struct ComponentGrowth {
  std::string field;
  int component = 0;
  double largest = 1, l2 = 1;
};
std::vector<ComponentGrowth> field_growth(const QualitySummary& before, const QualitySummary& after);

}  // namespace pliant
