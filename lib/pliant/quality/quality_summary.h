// lib/pliant/quality/quality_summary.h: a mesh in a few figures, which passes report before and after.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// How large one component u of one field is. NaN if the field has no value.
struct ComponentSize {
  std::string field;
  int component = 0;
  double largest = 0;  ///< the largest |control value|: a bound of |u|
  double l2 = 0;  ///< the root of ∫ u² dA over the mesh, exact to rounding; NaN if tangled elements make it negative
};
/// The figures; they equal those of report_quality bit for bit. NaN if no element has a value.
struct QualitySummary {
  std::int64_t triangles = 0, invalid = 0, degenerate = 0;
  double min_logical_angle = 0;  ///< degrees
  double min_scaled_jacobian = 0, min_shape = 0, max_distortion = 0;
  std::vector<ComponentSize> fields;
};
/// Measures the whole mesh, at a fraction of the cost of report_quality.
///
/// Requires    check_arrays(data) to be empty
/// Complexity  O(data)
QualitySummary summarize_quality(const MeshData& data);

/// How much a component has grown: the ratio of after to before, 1 if both are zero.
struct ComponentGrowth {
  std::string field;
  int component = 0;
  double largest = 1, l2 = 1;
};
/// The growth of every component that both meshes carry.
std::vector<ComponentGrowth> field_growth(const QualitySummary& before, const QualitySummary& after);

}  // namespace pliant
