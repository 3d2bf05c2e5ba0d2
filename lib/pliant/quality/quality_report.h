// lib/pliant/quality/quality_report.h: measures the quality of a whole mesh, as numbers; prints nothing.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/element/element_figures.h"

namespace pliant {

/// An element with one of the worst values of a metric.
struct WorstElement {
  TriangleId triangle;
  double value;
  Point centroid;  ///< where the element's barycentre lies
};
/// One metric over the mesh. Values that do not exist (the distortion of an element without area) or overflow are
/// counted in `missing` and left out of everything else. If there is no value at all, min, max and mean are NaN.
struct MetricSummary {
  std::string name;
  double min = 0, max = 0, mean = 0;
  std::int64_t count = 0, missing = 0;
  double histogram_low = 0, histogram_high = 0;
  std::vector<std::int64_t> histogram;  ///< equal bins; the last one contains its upper end, too
  std::vector<WorstElement> worst;      ///< worst first: smallest lengths and areas, largest turning angles, and so on
};
/// An element that is not valid.
struct BadElement {
  TriangleId triangle;
  Point centroid;  ///< where its barycentre lies
};
/// A place where the mesh lies over itself: an edge of `first` crosses or touches an edge of `second`, or (`second` is
/// none) the mesh covers itself beside an edge of `first`.
struct OverlapPlace {
  TriangleId first;
  TriangleId second;
  Point place;
};
/// One face of the boundary complex, over its triangles.
struct FaceFigures {
  std::string name;
  std::int64_t triangles = 0;
  double area = 0, perimeter = 0;  ///< the perimeter consists of the edges that only one triangle of the face has
};
/// One field; each vector has one value for each component. `min` and `max` are the extreme control values, and so
/// bounds of the function; NaN if the field has no value at all. The integral is NaN if a field by face lacks a value.
struct FieldFigures {
  std::string name;
  std::vector<double> min, max, integral;
};
/// The figures of a mesh. Angles are in degrees, except the tangent jump.
struct QualityReport {
  std::int64_t triangles = 0, vertices = 0, control_points = 0;
  int degree = 0;
  double time = 0, area = 0;
  double size = 0;  ///< the diagonal of the box of all control points; places are printed to a small part of it
  std::int64_t invalid = 0, degenerate = 0;
  std::vector<BadElement> invalid_elements, degenerate_elements;  ///< the first 100 of each, or `worst` if that is more
  /// The number of pairs of boundary edges that meet elsewhere than at a common vertex (at most 100,000 are counted),
  /// and of boundary loops whose inner side is not covered exactly once.
  std::int64_t overlaps = 0;
  std::vector<OverlapPlace> overlap_places;  ///< the first `worst` of them
  std::int64_t duplicate_points = 0;         ///< vertices exactly where another vertex is
  std::int64_t unused_points = 0;            ///< points of the document that are in no triangle
  std::vector<Fault> faults;
  /// The largest angle (radians) between one-sided tangents at knots of multiplicity < p, of splines and of mesh edges.
  std::optional<double> tangent_jump;
  std::vector<FaceFigures> faces;
  std::vector<FieldFigures> fields;
  std::vector<MetricSummary> metrics;  ///< those of report_metrics(), in its order
};
struct QualityOptions {
  int worst = 5;                   ///< so many of the worst elements are listed for each metric
  int bins = 20;                   ///< bins of each histogram; 0: no histograms
  std::vector<std::string> faces;  ///< only these faces are audited; empty: all are
  double jacobian_width = 1e-3;    ///< width of the bounds of min and max det J, relative to its largest coefficient
};

/// Measures every metric of a document, and, if `elements` is given, of every chosen element. Faults, overlaps,
/// duplicate and unused points, tangent jump, size and time are those of the whole document; everything else is
/// measured over the chosen faces.
///
/// Requires    check_arrays(data) to be empty; M1 to M6 need not hold
/// Throws      std::invalid_argument if `options.faces` names a face that the document does not have
QualityReport report_quality(const MeshData& data, const QualityOptions& options = {},
                             ElementFigures* elements = nullptr);

/// Converts the figures of a scaled mesh (normalize_unit) to the units of its document: places, lengths, areas, values
/// of det J, and integrals of fields; also the figures of single elements.
void restore_unit(QualityReport& report, ElementFigures& elements, double unit);

}  // namespace pliant
