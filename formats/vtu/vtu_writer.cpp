// formats/vtu/vtu_writer.cpp: writes a mesh as a VTK XML UnstructuredGrid.
#include "formats/vtu/vtu_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "formats/vtu/vtu_file.h"
#include "formats/vtu/vtu_points.h"
#include "formats/vtu/xml_text.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/quality/metrics.h"

namespace pliant {
namespace {

/// VTK's numbers of cell types.
constexpr unsigned char lagrange_curve = 68, lagrange_triangle = 69, bezier_curve = 75, bezier_triangle = 76;

/// What VTK's filters and ParaView's ranges cannot do with: not a number becomes 0, infinity the greatest double.
double finite(double value) {
  constexpr double greatest = std::numeric_limits<double>::max();
  return std::isnan(value) ? 0 : std::clamp(value, -greatest, greatest);
}

/// For each constrained edge the triangle on its left, or on its right if there is none on the left.
std::vector<TriangleId> triangles_beside(const MeshData& mesh) {
  const auto key = [](PointId from, PointId to) {
    return std::uint64_t(std::uint32_t(from)) << 32 | std::uint32_t(to);
  };
  std::unordered_map<std::uint64_t, std::size_t> edges;
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    const std::vector<PointId>& points = mesh.constrained_edges[e].points;
    edges.emplace(key(points.front(), points.back()), e);
  }
  std::vector<TriangleId> beside(mesh.constrained_edges.size(), none);
  const auto size = index(net_size(mesh.degree));
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t) {
    const PointId* corners = &mesh.triangles[t * size];
    for (std::size_t e = 0; e < 3; ++e) {
      const PointId from = corners[e], to = corners[(e + 1) % 3];
      if (const auto left = edges.find(key(from, to)); left != edges.end())
        beside[left->second] = static_cast<TriangleId>(t);
      else if (const auto right = edges.find(key(to, from)); right != edges.end() && beside[right->second] == none)
        beside[right->second] = static_cast<TriangleId>(t);
    }
  }
  return beside;
}

class VtuWriter {
 public:
  VtuWriter(const MeshData& mesh, const VtuOptions& options)
      : mesh_(mesh), options_(options), points_(mesh), nodes_(mesh, points_, options.lagrange) {
    if (options.curves) beside_ = triangles_beside(mesh);
  }

  void run(const std::function<void(std::string_view)>& write) {
    file_.tag("<UnstructuredGrid>");
    write_field_data();
    file_.tag("<Piece NumberOfPoints=\"" + std::to_string(points_.size()) + "\" NumberOfCells=\"" +
              std::to_string(mesh_.triangle_faces.size() + beside_.size()) + "\">");
    write_fields();
    write_cell_data();
    write_positions();
    write_cells();
    file_.tag("</Piece>\n</UnstructuredGrid>");
    file_.write(write);
  }

 private:
  VtuArray new_array() { return VtuArray(file_.compressor()); }

  void write_field_data() {
    file_.tag("<FieldData>");
    VtuArray time = new_array();
    time.put(mesh_.time);
    file_.field_array("Float64", "TimeValue", 1, std::move(time));
    write_names("face_names", mesh_.boundary.faces);
    if (options_.curves) write_names("curve_names", mesh_.boundary.curves);
    file_.tag("</FieldData>");
  }

  template <class Named>
  void write_names(const char* title, const std::vector<Named>& named) {
    VtuArray names = new_array();
    for (const Named& each : named) {
      std::string name = each.name;
      // A zero would end the name.
      std::ranges::replace(name, '\0', ' ');
      names.put_string(name);
    }
    file_.field_array("String", title, named.size(), std::move(names));
  }

  void write_fields() {
    std::vector<std::string> names;
    for (const Field& field : mesh_.fields) names.push_back(field.name);
    names = distinct_names(names);
    // Filters that need a scalar or a vector begin with the first one.
    std::string tag = "<PointData";
    const auto note_first = [&](const char* what, auto&& fits) {
      const auto found = std::ranges::find_if(mesh_.fields, fits, &Field::components);
      if (found != mesh_.fields.end())
        tag += std::string(" ") + what + "=\"" + escape_attribute(names[index(found - mesh_.fields.begin())]) + "\"";
    };
    note_first("Scalars", [](int components) { return components == 1; });
    note_first("Vectors", [](int components) { return components == 2 || components == 3; });
    file_.tag(tag + ">");
    for (std::size_t f = 0; f < mesh_.fields.size(); ++f) {
      const Field& field = mesh_.fields[f];
      write_rows(names[f], {field.components, field.values, field.by_face}, 1);
    }
    file_.tag("</PointData>");
  }

  /// Rows of two numbers get a third one, since VTK's vectors have three.
  void write_rows(const std::string& name, const VtuRows& control, double factor) {
    const auto width = index(control.width);
    VtuArray numbers = new_array();
    std::vector<double> storage;
    const std::span<const double> rows = nodes_.rows(control, storage);
    for (std::size_t k = 0; k < rows.size(); k += width) {
      for (std::size_t c = 0; c < width; ++c) numbers.put(rows[k + c] * factor);
      if (width == 2) numbers.put(0.0);
    }
    file_.array("Float64", name, width == 2 ? 3 : control.width, std::move(numbers));
  }

  void write_positions() {
    file_.tag("<Points>");
    static_assert(sizeof(Point) == 2 * sizeof(double));
    write_rows("Points", {2, {reinterpret_cast<const double*>(mesh_.points.data()), 2 * mesh_.points.size()}, false},
               mesh_.boundary.unit);
    file_.tag("</Points>");
  }

  /// Data of cells: for each triangle `of_triangle(t)`, then for each curve's cell `of_curve(e)`.
  template <class OfTriangle, class OfCurve>
  void write_cell_array(const char* type, const char* name, OfTriangle&& of_triangle, OfCurve&& of_curve) {
    VtuArray numbers = new_array();
    for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t) numbers.put(of_triangle(t));
    for (std::size_t e = 0; e < beside_.size(); ++e) numbers.put(of_curve(e));
    file_.array(type, name, 1, std::move(numbers));
  }

  void write_cell_data() {
    file_.tag(options_.metrics.empty() ? "<CellData>"
                                       : "<CellData Scalars=\"" + std::string(options_.metrics[0]->name) + "\">");
    const auto face = [&](std::size_t t) { return mesh_.triangle_faces[t]; };
    write_cell_array("Int32", "face", face, [&](std::size_t e) { return face(index(beside_[e])); });
    if (options_.curves)
      write_cell_array(
          "Int32", "curve", [](std::size_t) { return std::int32_t{none}; },
          [&](std::size_t e) { return mesh_.constrained_edges[e].curve; });
    if (!options_.metrics.empty()) write_metrics();
    file_.tag("</CellData>");
  }

  /// A cell of a curve has the numbers of the triangle beside it, so that it changes no range of colours.
  void write_metrics() {
    const std::size_t count = options_.metrics.size();
    VtuArray validity = new_array();
    std::vector<VtuArray> columns(count, new_array());
    std::vector<double> factors;
    for (const Metric* metric : options_.metrics) factors.push_back(unit_factor(metric->unit, mesh_.boundary.unit));
    std::vector<std::size_t> by_triangle(beside_.size());
    for (std::size_t e = 0; e < by_triangle.size(); ++e) by_triangle[e] = e;
    std::ranges::sort(by_triangle, {}, [&](std::size_t e) { return std::pair(beside_[e], e); });
    std::vector<unsigned char> curve_validity(beside_.size());
    std::vector<double> curve_values(beside_.size() * count);
    auto next = by_triangle.begin();
    for_each_element(mesh_, options_.metrics, [&](TriangleId t, Validity certificate, std::span<const double> values) {
      const auto code = static_cast<unsigned char>(certificate);
      validity.put(code);
      for (std::size_t m = 0; m < count; ++m) columns[m].put(finite(values[m] * factors[m]));
      for (; next != by_triangle.end() && beside_[*next] == t; ++next) {
        curve_validity[*next] = code;
        for (std::size_t m = 0; m < count; ++m) curve_values[*next * count + m] = finite(values[m] * factors[m]);
      }
    });
    for (std::size_t e = 0; e < beside_.size(); ++e) {
      validity.put(curve_validity[e]);
      for (std::size_t m = 0; m < count; ++m) columns[m].put(curve_values[e * count + m]);
    }
    file_.array("UInt8", "validity", 1, std::move(validity));
    for (std::size_t m = 0; m < count; ++m) file_.array("Float64", options_.metrics[m]->name, 1, std::move(columns[m]));
  }

  void write_cells() {
    file_.tag("<Cells>");
    const std::vector<int> order = nested_net_order(mesh_.degree);
    VtuArray connectivity = new_array();
    for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t)
      for (const int n : order)
        connectivity.put(points_.number(mesh_.triangles[t * order.size() + index(n)], mesh_.triangle_faces[t]));
    const auto p = index(mesh_.degree);
    for (std::size_t e = 0; e < beside_.size(); ++e) {
      const auto put = [&](PointId point) {
        connectivity.put(points_.number(point, mesh_.triangle_faces[index(beside_[e])]));
      };
      const std::vector<PointId>& edge = mesh_.constrained_edges[e].points;
      put(edge.front());
      put(edge.back());
      for (std::size_t k = 1; k < p; ++k) put(edge[k]);
    }
    file_.array("Int32", "connectivity", 1, std::move(connectivity));
    VtuArray offsets = new_array();
    std::int64_t end = 0;
    for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t) offsets.put(end += std::ssize(order));
    for (std::size_t e = 0; e < beside_.size(); ++e) offsets.put(end += mesh_.degree + 1);
    file_.array("Int64", "offsets", 1, std::move(offsets));
    write_cell_array(
        "UInt8", "types", [&](std::size_t) { return options_.lagrange ? lagrange_triangle : bezier_triangle; },
        [&](std::size_t) { return options_.lagrange ? lagrange_curve : bezier_curve; });
    file_.tag("</Cells>");
  }

  const MeshData& mesh_;
  const VtuOptions& options_;
  VtuPoints points_;
  VtuNodes nodes_;
  std::vector<TriangleId> beside_;  // for each constrained edge that is a cell
  VtuFile file_;
};

}  // namespace

void write_vtu(const MeshData& mesh, const VtuOptions& options, const std::function<void(std::string_view)>& write) {
  VtuWriter(mesh, options).run(write);
}

}  // namespace pliant
