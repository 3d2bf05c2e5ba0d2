// lib/pliant/quality/quality_report.cpp: gathers the figures of a mesh, its faces, its fields and its elements.
#include "pliant/quality/quality_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/half_edges.h"
#include "pliant/quality/duplicates.h"
#include "pliant/quality/element/element_measures.h"
#include "pliant/quality/field_figures.h"
#include "pliant/quality/metric_summary.h"
#include "pliant/quality/overlaps.h"
#include "pliant/quality/tangent_jump.h"

namespace pliant {
namespace {

std::vector<bool> chosen_faces(const BoundaryComplex& boundary, const std::vector<std::string>& names) {
  std::vector<bool> chosen(boundary.faces.size(), names.empty());
  for (const std::string& name : names) {
    const int face = find_face(boundary, name);
    if (face == outside) throw std::invalid_argument("there is no face named \"" + name + "\"");
    chosen[index(face)] = true;
  }
  return chosen;
}

class Reporter {
 public:
  Reporter(const MeshData& data, const QualityOptions& options)
      : data_(data),
        options_(options),
        n_(index(net_size(data.degree))),
        is_face_chosen_(chosen_faces(data.boundary, options.faces)) {
    for (std::size_t t = 0; t < data.triangle_faces.size(); ++t)
      if (is_face_chosen_[index(data.triangle_faces[t])]) chosen_.push_back(static_cast<TriangleId>(t));
  }

  QualityReport run(ElementFigures* elements) {
    report_.degree = data_.degree;
    report_.time = data_.time;
    const HalfEdges half_edges(data_);
    report_.faults = check_structure(data_, half_edges);
    report_.tangent_jump = tangent_jump(data_);
    Overlaps overlaps = find_overlaps(data_, half_edges, options_.worst);
    report_.overlaps = overlaps.count;
    report_.overlap_places = std::move(overlaps.places);
    measure_elements(half_edges, elements != nullptr);
    measure_points(half_edges.is_sound());
    report_.fields = field_figures(data_, chosen_);
    for (std::size_t m = 0; m < metrics_.size(); ++m) {
      MetricSummary summary = metrics_[m].finish();
      for (WorstElement& worst : summary.worst) {
        const auto place = index(worst.triangle);
        const bool is_edge = report_metrics()[m]->per == Metric::Per::edge;
        worst.triangle = is_edge ? triangle_of_edge(place) : chosen_[place];
        worst.centroid = barycentre(worst.triangle);
      }
      report_.metrics.push_back(std::move(summary));
    }
    for (std::size_t f = 0; f < figures_.size(); ++f)
      if (is_face_chosen_[f]) report_.faces.push_back(figures_[f]);
    if (elements != nullptr) *elements = list_elements();
    return std::move(report_);
  }

 private:
  bool is_chosen(TriangleId t) const { return is_face_chosen_[index(data_.triangle_faces[index(t)])]; }

  std::span<const Point> gather(TriangleId t) {
    for (std::size_t k = 0; k < n_; ++k) net_[k] = data_.points[index(data_.triangles[index(t) * n_ + k])];
    return std::span<const Point>(net_).first(n_);
  }

  void measure_points(bool is_sound) {
    Box box;
    for (const Point& p : data_.points) box.extend(p);
    report_.size = box.size();
    enum : char { unused, control_point, vertex };
    const auto uses_in = [this](auto&& is_wanted) {
      std::vector<char> use(data_.points.size(), unused);
      for (std::size_t t = 0; t < data_.triangle_faces.size(); ++t) {
        if (!is_wanted(static_cast<TriangleId>(t))) continue;
        const PointId* net = &data_.triangles[t * n_];
        for (std::size_t k = 3; k < n_; ++k) use[index(net[k])] = std::max(use[index(net[k])], char{control_point});
        for (std::size_t k = 0; k < 3; ++k) use[index(net[k])] = vertex;
      }
      return use;
    };
    std::vector<char> use = uses_in([](TriangleId) { return true; });
    report_.unused_points = std::ranges::count(use, char{unused});
    // If no two elements overlap, no two vertices are at one place.
    const bool is_injective = is_sound && report_.overlaps == 0 && report_.invalid == 0 && report_.degenerate == 0 &&
                              chosen_.size() == data_.triangle_faces.size();
    report_.duplicate_points = is_injective ? 0 : count_duplicates(data_.points, use, char{vertex});
    if (chosen_.size() < data_.triangle_faces.size()) use = uses_in([this](TriangleId t) { return is_chosen(t); });
    report_.vertices = std::ranges::count(use, char{vertex});
    report_.control_points = std::ssize(use) - std::ranges::count(use, char{unused});
  }

  /// What the length of a half-edge counts for: as an edge of the mesh, and in the perimeter of a face.
  enum EdgeRole : char { no_role = 0, of_edge = 1, of_perimeter = 2 };

  /// Gives each half-edge of a chosen triangle its role, and returns the number of edges. Every edge counts once, at
  /// the first chosen triangle that has it. An edge counts in the perimeter of a face if only one triangle of the face
  /// has it.
  std::size_t assign_edges(const HalfEdges& half_edges) {
    roles_.resize(3 * data_.triangle_faces.size());
    std::size_t count = 0;
    for (const TriangleId t : chosen_) {
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(t, e), g = half_edges.twin(h);
        const bool is_border = half_edges.is_border(h);
        const bool is_first = g == none || h < g || (is_border && !is_chosen(triangle_of(g)));
        roles_[index(h)] = static_cast<char>((is_first ? of_edge : no_role) | (is_border ? of_perimeter : no_role));
        count += is_first ? 1 : 0;
      }
    }
    return count;
  }

  /// The triangle at which the edge with this number was counted.
  TriangleId triangle_of_edge(std::size_t edge) const {
    std::size_t before = 0;
    for (const TriangleId t : chosen_) {
      for (int e = 0; e < 3; ++e) before += (roles_[index(half_edge(t, e))] & of_edge) != 0 ? 1 : 0;
      if (before > edge) return t;
    }
    return none;
  }

  void measure_elements(const HalfEdges& half_edges, bool lists_elements) {
    const std::size_t edges = assign_edges(half_edges);
    for (const Face& face : data_.boundary.faces) figures_.push_back({face.name});
    for (const Metric* metric : report_metrics())
      metrics_.emplace_back(*metric, options_.bins, options_.worst, lists_elements,
                            metric->per == Metric::Per::edge ? edges : chosen_.size());
    if (lists_elements) {
      validity_.reserve(chosen_.size());
      columns_.resize(all_metrics().size());
    }
    std::vector<double> column;
    const auto take = [&](std::size_t first, std::span<const ElementMeasures> measures) {
      lengths_.clear();
      for (std::size_t k = 0; k < measures.size(); ++k) take_element(chosen_[first + k], measures[k], lists_elements);
      std::size_t summarised = 0;
      for (std::size_t m = 0; m < all_metrics().size(); ++m) {
        const Metric& metric = all_metrics()[m];
        const bool is_of_elements = metric.per == Metric::Per::element;
        if (is_of_elements || lists_elements) {
          column.clear();
          for (const ElementMeasures& of_element : measures) column.push_back(of_element.*metric.value);
        }
        if (metric.per != Metric::Per::table_entry) metrics_[summarised++].add(is_of_elements ? column : lengths_);
        if (!is_of_elements && lists_elements) columns_[m].insert(columns_[m].end(), column.begin(), column.end());
      }
    };
    pliant::measure_elements(data_, chosen_, options_.jacobian_width, take);
    report_.triangles = std::ssize(chosen_);
  }

  void take_element(TriangleId t, const ElementMeasures& measures, bool lists_elements) {
    if (measures.validity == Validity::invalid) list(t, report_.invalid, report_.invalid_elements);
    if (measures.validity == Validity::degenerate) list(t, report_.degenerate, report_.degenerate_elements);
    FaceFigures& figures = figures_[index(data_.triangle_faces[index(t)])];
    ++figures.triangles;
    figures.area += measures.area;
    report_.area += measures.area;
    for (int e = 0; e < 3; ++e) {
      const char role = roles_[index(half_edge(t, e))];
      const double length = measures.edge_length[index(e)];
      if ((role & of_perimeter) != 0) figures.perimeter += length;
      if ((role & of_edge) != 0) lengths_.push_back(length);
    }
    if (lists_elements) validity_.push_back(measures.validity);
  }

  void list(TriangleId t, std::int64_t& count, std::vector<BadElement>& listed) {
    if (count++ < std::max(options_.worst, 100)) listed.push_back({t, barycentre(t)});
  }

  ElementFigures list_elements() {
    ElementFigures elements{chosen_, validity_, {}};
    std::size_t summarised = 0;
    for (std::size_t m = 0; m < all_metrics().size(); ++m) {
      const Metric& metric = all_metrics()[m];
      std::vector<double>& values = metric.per == Metric::Per::element ? metrics_[summarised].values() : columns_[m];
      if (metric.per != Metric::Per::table_entry) ++summarised;
      elements.columns.push_back({std::string(metric.name), metric.worst_is_least, std::move(values)});
    }
    return elements;
  }

  Point barycentre(TriangleId t) {
    const std::span<const Point> net = gather(t);
    const NetLayout& layout = NetLayout::of(data_.degree);
    Point sum;
    for (int k = 0; k < layout.size(); ++k) sum += layout.multinomial(k) * net[index(k)];
    return sum / std::pow(3, data_.degree);
  }

  const MeshData& data_;
  const QualityOptions& options_;
  std::size_t n_;
  std::vector<bool> is_face_chosen_;
  std::vector<TriangleId> chosen_;
  std::vector<FaceFigures> figures_;
  std::vector<Summariser> metrics_;  // edge lengths have a value for each edge, all others one for each element
  std::vector<char> roles_;          // the EdgeRole of each half-edge
  std::vector<double> lengths_;      // scratch
  // For each chosen element, if single elements are asked for.
  std::vector<Validity> validity_;
  std::vector<std::vector<double>> columns_;  // values of the metrics whose summary is not over elements
  std::array<Point, net_size(max_degree)> net_;
  QualityReport report_;
};

}  // namespace

QualityReport report_quality(const MeshData& data, const QualityOptions& options, ElementFigures* elements) {
  return Reporter(data, options).run(elements);
}

}  // namespace pliant
