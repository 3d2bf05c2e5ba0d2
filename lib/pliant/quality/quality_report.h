#pragma once  // lib/pliant/quality/quality_report.h: the figures of a whole mesh; prints nothing
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct WorstElement {
  TriangleId triangle;
  double value;
  Point centroid;
};
/// One metric over the mesh. Values that do not exist (distortion of an element without area) are left out of all but
/// `missing`.
struct MetricSummary {
  std::string name;
  double min = 0, max = 0, mean = 0;
  std::int64_t count = 0, missing = 0;
  double histogram_low = 0, histogram_high = 0;
  std::vector<std::int64_t> histogram;
  std::vector<WorstElement> worst;  ///< worst first; for lengths and areas the smallest, for turning the largest
};
struct FaceFigures {
  std::string name;
  std::int64_t triangles = 0;
  double area = 0, perimeter = 0;
};
struct FieldFigures {
  std::string name;
  std::vector<double> min, max, integral;  ///< a value a component
};
struct QualityReport {
  std::int64_t triangles = 0, vertices = 0, control_points = 0;
  int degree = 0;
  double time = 0, area = 0;
  std::int64_t invalid = 0, degenerate = 0;
  std::vector<TriangleId> invalid_elements, degenerate_elements;  ///< the first `worst` of each
  std::int64_t overlaps = 0;                                      ///< pairs of boundary edges that cross
  std::vector<Fault> faults;
  std::optional<double>
      tangent_jump;  ///< largest angle (radians) between one-sided tangents at knots of multiplicity < p
  std::vector<FaceFigures> faces;
  std::vector<FieldFigures> fields;
  std::vector<MetricSummary> metrics;  ///< jacobian, scaled_jacobian, shape, logical_tau, control_tau, distortion,
                                       ///< logical_angle, turning_angle, edge_length, element_area, in this order
};
struct QualityOptions {
  int worst = 5;
  int bins = 20;
  std::vector<std::string> faces;  ///< audit these faces only; empty: all
};

/// Every metric of the document, which need not satisfy M1–M6: only its arrays must be well-formed (check_arrays).
QualityReport report_quality(const MeshData& data, const QualityOptions& options = {});

}  // namespace pliant
