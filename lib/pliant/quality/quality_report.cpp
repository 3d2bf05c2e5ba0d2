#include "pliant/quality/quality_report.h"  // lib/pliant/quality/quality_report.cpp: gathers the figures

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <stdexcept>

#include "pliant/geometry/jacobian.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/crossing_edges.h"
#include "pliant/quality/edge_table.h"
#include "pliant/quality/element_forms.h"
#include "pliant/quality/element_quality.h"
#include "pliant/quality/field_figures.h"
#include "pliant/quality/metric_summary.h"
#include "pliant/quality/tangent_jump.h"

namespace pliant {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

template <class I>
constexpr std::size_t at(I i) {
  return static_cast<std::size_t>(i);
}

std::vector<bool> chosen_faces(const BoundaryComplex& boundary, const std::vector<std::string>& names) {
  std::vector<bool> chosen(boundary.faces.size(), names.empty());
  for (const std::string& name : names) {
    const int face = find_face(boundary, name);
    if (face == outside) throw std::invalid_argument("there is no face named \"" + name + "\"");
    chosen[at(face)] = true;
  }
  return chosen;
}

class Reporter {
 public:
  Reporter(const MeshData& data, const QualityOptions& options)
      : data_(data),
        options_(options),
        n_(at(net_size(data.degree))),
        is_face_chosen_(chosen_faces(data.boundary, options.faces)),
        is_chosen_(data.triangle_faces.size()),
        columns_(metric_count),
        net_(n_) {
    for (std::size_t t = 0; t < is_chosen_.size(); ++t) is_chosen_[t] = is_face_chosen_[at(data.triangle_faces[t])];
  }

  QualityReport run(ElementFigures* elements) {
    report_.degree = data_.degree;
    report_.time = data_.time;
    report_.faults = check_structure(data_);
    report_.tangent_jump = tangent_jump(data_);
    report_.overlaps = count_overlaps();
    count_points();
    list_invalid();
    measure_elements();
    measure_edges();
    if (elements != nullptr) list_elements(*elements);
    report_.fields = field_figures(data_, is_chosen_);
    for (int m = 0; m < metric_count; ++m) {
      report_.metrics.push_back(summarise(metric_spec(m), columns_[at(m)], options_.bins, options_.worst));
      for (WorstElement& worst : report_.metrics.back().worst) worst.centroid = barycentre(worst.triangle);
    }
    for (std::size_t f = 0; f < figures_.size(); ++f)
      if (is_face_chosen_[f]) report_.faces.push_back(figures_[f]);
    return std::move(report_);
  }

 private:
  void gather(std::size_t t) {
    for (std::size_t k = 0; k < n_; ++k) net_[k] = data_.points[at(data_.triangles[t * n_ + k])];
  }

  void count_points() {
    enum : char { unused, control_point, vertex };
    std::vector<char> use(data_.points.size(), unused);
    for (std::size_t t = 0; t < is_chosen_.size(); ++t) {
      for (std::size_t k = 0; is_chosen_[t] && k < n_; ++k) {
        char& of_point = use[at(data_.triangles[t * n_ + k])];
        of_point = std::max(of_point, k < 3 ? char{vertex} : char{control_point});
      }
    }
    report_.vertices = std::ranges::count(use, char{vertex});
    report_.control_points = std::ranges::count_if(use, [](char u) { return u != unused; });
  }

  void list_invalid() {
    const InvalidElements found = find_invalid(data_);
    const auto list = [this](const std::vector<TriangleId>& all, std::int64_t& count, std::vector<TriangleId>& shown) {
      for (const TriangleId t : all)
        if (is_chosen_[at(t)] && ++count <= options_.worst) shown.push_back(t);
    };
    list(found.invalid, report_.invalid, report_.invalid_elements);
    list(found.degenerate, report_.degenerate, report_.degenerate_elements);
  }

  void measure_elements() {
    for (const Face& face : data_.boundary.faces) figures_.push_back({face.name});
    ElementForms forms;
    for (std::size_t t = 0; t < is_chosen_.size(); ++t) {
      if (!is_chosen_[t]) continue;
      gather(t);
      const auto id = static_cast<TriangleId>(t);
      const auto add = [&](Metric metric, double value) { columns_[metric].add(id, value); };
      element_forms(data_.degree, net_, forms);
      double least_jacobian = 0;
      const double scaled = scaled_jacobian(data_.degree, net_, forms, least_jacobian);
      const double area = element_area(data_.degree, net_);
      add(jacobian_metric, least_jacobian);
      add(scaled_jacobian_metric, scaled);
      add(shape_metric, curved_shape(forms));
      add(logical_tau_metric, triangle_shape(net_[0], net_[1], net_[2]));
      add(control_tau_metric, control_shape(data_.degree, net_));
      add(distortion_metric, distortion(forms));
      add(logical_angle_metric, degrees * least_angle(net_[0], net_[1], net_[2]));
      add(turning_angle_metric, degrees * element_turning(data_.degree, net_));
      add(element_area_metric, area);
      FaceFigures& figures = figures_[at(data_.triangle_faces[t])];
      ++figures.triangles;
      figures.area += area;
      ++report_.triangles;
      report_.area += area;
    }
  }

  void measure_edges() {
    const EdgeUses uses = edge_uses(data_, is_chosen_);
    for (std::size_t e = 0; e < uses.count(); ++e) {
      const auto half_edges = uses.of(e);
      const double length = curve_length(edge_polygon(data_, half_edges.front()));
      columns_[edge_length_metric].add(triangle_of(half_edges.front()), length);
      for (const HalfEdgeId h : half_edges) {
        const FaceId face = data_.triangle_faces[at(triangle_of(h))];
        const auto same = [&](HalfEdgeId g) { return data_.triangle_faces[at(triangle_of(g))] == face; };
        if (std::ranges::count_if(half_edges, same) == 1) figures_[at(face)].perimeter += length;
      }
    }
  }

  void list_elements(ElementFigures& elements) {
    elements = {};
    elements.triangles = columns_[element_area_metric].triangles;
    const InvalidElements found = find_invalid(data_);
    std::vector<Validity> validity(is_chosen_.size(), Validity::valid);
    for (const TriangleId t : found.invalid) validity[at(t)] = Validity::invalid;
    for (const TriangleId t : found.degenerate) validity[at(t)] = Validity::degenerate;
    std::vector<double> greatest, shortest, longest;
    for (const TriangleId t : elements.triangles) {
      elements.validity.push_back(validity[at(t)]);
      gather(at(t));
      greatest.push_back(jacobian_range(data_.degree, net_).greatest.upper);
      double least = HUGE_VAL, most = 0;
      for (int e = 0; e < 3; ++e) {
        const double length = curve_length(edge_polygon(data_, half_edge(t, e)));
        least = std::min(least, length);
        most = std::max(most, length);
      }
      shortest.push_back(least);
      longest.push_back(most);
    }
    for (int m = 0; m < metric_count; ++m) {
      const MetricSpec& spec = metric_spec(m);
      elements.columns.push_back(
          {spec.name, spec.worst_is_least, m == edge_length_metric ? shortest : columns_[at(m)].values});
      if (m == jacobian_metric) elements.columns.push_back({"jacobian_max", false, greatest});
      if (m == edge_length_metric) elements.columns.push_back({"edge_length_max", false, longest});
    }
  }

  /// Constrained edges, and what else has one triangle only.
  std::int64_t count_overlaps() const {
    EdgeCurves edges;
    edges.degree = data_.degree;
    std::set<std::pair<PointId, PointId>> seen;
    const auto add = [&](const std::vector<PointId>& ids) {
      if (!seen.insert(std::minmax(ids.front(), ids.back())).second) return;
      edges.ends.emplace_back(ids.front(), ids.back());
      for (const PointId p : ids) edges.points.push_back(data_.points[at(p)]);
    };
    for (const ConstrainedEdge& edge : data_.constrained_edges) add(edge.points);
    const EdgeUses uses = edge_uses(data_, std::vector<bool>(is_chosen_.size(), true));
    for (std::size_t e = 0; e < uses.count(); ++e)
      if (uses.of(e).size() == 1) add(edge_ids(data_, uses.of(e).front()));
    return count_crossings(edges);
  }

  Point barycentre(TriangleId t) {
    gather(at(t));
    const NetLayout& layout = NetLayout::of(data_.degree);
    Point sum;
    for (int k = 0; k < layout.size(); ++k) sum += layout.multinomial(k) * net_[at(k)];
    return sum / std::pow(3, data_.degree);
  }

  const MeshData& data_;
  const QualityOptions& options_;
  std::size_t n_;
  std::vector<bool> is_face_chosen_, is_chosen_;
  std::vector<FaceFigures> figures_;
  std::vector<MetricColumn> columns_;
  std::vector<Point> net_;
  QualityReport report_;
};

}  // namespace

QualityReport report_quality(const MeshData& data, const QualityOptions& options, ElementFigures* elements) {
  return Reporter(data, options).run(elements);
}

}  // namespace pliant
