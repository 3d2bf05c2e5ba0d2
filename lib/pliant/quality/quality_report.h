// lib/pliant/quality/quality_report.h: the figures of a whole mesh; prints nothing.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/element/element_figures.h"

namespace pliant {

struct WorstElement {
  TriangleId triangle;
  double value;
  Point centroid;  ///< where the element's barycentre lies
};
/// One metric over the mesh. Values that do not exist (distortion of an element without area) or overflow are left out
/// of all but `missing`; where there is no value at all, min, max and mean are NaN.
struct MetricSummary {
  std::string name;
  double min = 0, max = 0, mean = 0;
  std::int64_t count = 0, missing = 0;
  double histogram_low = 0, histogram_high = 0;
  std::vector<std::int64_t> histogram;  ///< equal bins; the last one holds its upper end, too
  std::vector<WorstElement> worst;      ///< worst first; for lengths and areas the smallest, for turning the largest
};
/// An element that is not valid.
struct BadElement {
  TriangleId triangle;
  Point centroid;  ///< where its barycentre lies
};
/// Where the mesh lies over itself.
struct OverlapPlace {
  TriangleId first;   ///< with an edge that crosses or touches one of `second`, or beside which the mesh lies on itself
  TriangleId second;  ///< or none
  Point place;
};
struct FaceFigures {
  std::string name;
  std::int64_t triangles = 0;
  double area = 0, perimeter = 0;  ///< perimeter: the edges with exactly one triangle of the face
};
/// A value a component. `min` and `max` are those of the control values, so bounds of the function; NaN where the field
/// has no value (a field by face that lacks a place).
struct FieldFigures {
  std::string name;
  std::vector<double> min, max, integral;
};
/// Angles are degrees, except the tangent jump.
struct QualityReport {
  std::int64_t triangles = 0, vertices = 0, control_points = 0;
  int degree = 0;
  double time = 0, area = 0;
  double size = 0;  ///< the diagonal of the box of all control points: what places are to be told apart by
  std::int64_t invalid = 0, degenerate = 0;
  std::vector<BadElement> invalid_elements, degenerate_elements;  ///< the first 100 of each, or `worst` if that is more
  /// Pairs of boundary edges that meet elsewhere than at a common vertex (at most 100,000 are counted), and boundary
  /// loops whose inner side is not covered just once.
  std::int64_t overlaps = 0;
  std::vector<OverlapPlace> overlap_places;  ///< the first `worst`
  std::int64_t duplicate_points = 0;         ///< vertices at the very place of another one
  std::int64_t unused_points = 0;            ///< of the document, in no triangle
  std::vector<Fault> faults;
  /// Largest angle (radians) between one-sided tangents at knots of multiplicity < p, of splines and of mesh edges.
  std::optional<double> tangent_jump;
  std::vector<FaceFigures> faces;
  std::vector<FieldFigures> fields;
  std::vector<MetricSummary> metrics;  ///< those of report_metrics(), in its order
};
struct QualityOptions {
  int worst = 5;
  int bins = 20;                   ///< 0: no histograms
  std::vector<std::string> faces;  ///< audit these faces only; empty: all
  double jacobian_width = 1e-3;    ///< of the enclosures of min and max det J, relative to its largest coefficient
};

/// Every metric of the document, which need not satisfy M1–M6: only its arrays must be well-formed (check_arrays).
/// Faults, overlaps, duplicate and unused points, tangent jump and time are of the whole document, all else of the
/// chosen faces.
///
/// With `elements` also the measures of every chosen element.
///
/// Throws      std::invalid_argument where `options.faces` names a face that the document does not have
QualityReport report_quality(const MeshData& data, const QualityOptions& options = {},
                             ElementFigures* elements = nullptr);

/// Brings the figures of a normalised mesh (normalize_unit) back to the units of its document: places, lengths, areas,
/// values of det J, and the fields' integrals; the figures of single elements as well.
void restore_unit(QualityReport& report, ElementFigures& elements, double unit);

}  // namespace pliant
