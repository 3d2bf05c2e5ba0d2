// formats/msh/msh_field_writer.cpp: writes the fields of a mesh as sections $NodeData and $ElementNodeData.
#include "formats/msh/msh_field_writer.h"

#include <algorithm>
#include <set>
#include <string>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// Evaluates the polynomials of a field at the nodes of its elements.
class NodeValues {
 public:
  NodeValues(const MeshData& mesh, const Field& field)
      : mesh_(mesh),
        field_(field),
        layout_(NetLayout::of(mesh.degree)),
        size_(index(layout_.size())),
        width_(index(field.components)),
        net_(size_ * width_),
        values_(size_ * width_),
        polygon_((index(mesh.degree) + 1) * width_) {
    if (!field.by_face) return;
    first_place_.assign(mesh.points.size() + 1, 0);
    for (const auto& [point, face] : field.places) ++first_place_[index(point) + 1];
    for (std::size_t p = 1; p < first_place_.size(); ++p) first_place_[p] += first_place_[p - 1];
  }

  /// The values at the nodes of triangle t, rows in the order of NetLayout, until the next call. Nodes inside an edge
  /// are computed from the edge alone and in one direction, so that both triangles have the same bits.
  const std::vector<double>& of_triangle(std::size_t t) {
    const PointId* own = &mesh_.triangles[t * size_];
    for (std::size_t k = 0; k < size_; ++k)
      std::copy_n(&field_.values[row_of(own[k], mesh_.triangle_faces[t]) * width_], width_, &net_[k * width_]);
    values_ = net_;
    const int p = mesh_.degree;
    for (int e = 0; e < 3; ++e) {
      const bool forward = own[e] < own[(e + 1) % 3];
      const auto place = [&](int k) { return index(layout_.edge_index(e, forward ? k : p - k)); };
      for (int k = 0; k <= p; ++k) std::copy_n(&net_[place(k) * width_], width_, &polygon_[index(k) * width_]);
      for (int k = 1; k < p; ++k)
        evaluate_polygon(p, field_.components, polygon_, double(k) / p, {&values_[place(k) * width_], width_});
    }
    for (int k = layout_.first_interior(); k < layout_.size(); ++k) {
      const auto& [i, j, l] = layout_.exponents(k);
      evaluate_net(p, field_.components, net_, {double(i) / p, double(j) / p, double(l) / p},
                   {&values_[index(k) * width_], width_});
    }
    return values_;
  }

 private:
  /// The row of `values` that the point has in a face.
  std::size_t row_of(PointId point, FaceId face) const {
    if (!field_.by_face) return index(point);
    std::size_t row = first_place_[index(point)];
    while (row + 1 < first_place_[index(point) + 1] && field_.places[row][1] != face) ++row;
    return row;
  }

  const MeshData& mesh_;
  const Field& field_;
  const NetLayout& layout_;
  std::size_t size_, width_;
  std::vector<double> net_, values_, polygon_;
  std::vector<std::size_t> first_place_;  ///< by face: where the places of each point begin
};

/// A view: some components of a field, perhaps with zeros behind them.
struct View {
  std::string name;  ///< in quotes
  std::size_t first = 0;
  std::size_t taken = 1;
  std::int32_t written = 1;
};

class FieldWriter {
 public:
  FieldWriter(const MeshData& mesh, const std::vector<int>& order, const std::vector<char>& used, MshRows& rows)
      : mesh_(mesh), order_(order), used_(used), rows_(rows), size_(index(net_size(mesh.degree))) {}

  void write(const Field& field) {
    for (const View& view : views_of(field)) field.by_face ? write_by_element(field, view) : write_by_node(field, view);
  }

 private:
  /// Gmsh draws one component as a scalar, three as a vector and nine as a tensor, and knows nothing else.
  std::vector<View> views_of(const Field& field) {
    if (field.components == 2) return {{unique(field.name), 0, 2, 3}};
    if (field.components == 1 || field.components == 3 || field.components == 9)
      return {{unique(field.name), 0, index(field.components), field.components}};
    std::vector<View> views;
    for (int c = 0; c < field.components; ++c)
      views.push_back({unique(field.name + " " + std::to_string(c + 1)), index(c), 1, 1});
    return views;
  }

  /// The name in quotes, with a number behind it if another view has it: Gmsh takes views of one name for one.
  std::string unique(const std::string& name) {
    std::string quoted = msh_quoted(name);
    for (int k = 2; !names_.insert(quoted).second; ++k) {
      const std::string suffix = " (" + std::to_string(k) + ")";
      quoted = msh_quoted(name, msh_longest_name - suffix.size());
      quoted.insert(quoted.size() - 1, suffix);
    }
    return quoted;
  }

  void begin(const Field& field, const View& view, const char* section, std::size_t entries) {
    rows_.line("$" + std::string(section));
    std::string mark;
    if (view.taken == 3) mark = "components=3";
    if (field.by_face) mark += mark.empty() ? "by_face" : " by_face";
    // The second string tag is the interpolation scheme: none, so that it is that of the elements.
    rows_.line(mark.empty() ? "1\n" + view.name : "3\n" + view.name + "\n\"\"\n\"" + mark + "\"");
    std::string time;
    append_number(time, mesh_.time);
    rows_.line("1\n" + time);
    rows_.line("3\n0\n" + std::to_string(view.written) + "\n" + std::to_string(entries));
  }
  void put(const double* row, const View& view) {
    for (std::size_t c = 0; c < index(view.written); ++c) rows_.put(c < view.taken ? row[view.first + c] : 0.0);
  }

  void write_by_node(const Field& field, const View& view) {
    const std::size_t width = index(field.components);
    // Control values are replaced by nodal ones; those of vertices are the same.
    std::vector<double> values = field.values;
    NodeValues nodes(mesh_, field);
    for (std::size_t t = 0; t < mesh_.triangle_faces.size() && mesh_.degree > 1; ++t) {
      const std::vector<double>& own = nodes.of_triangle(t);
      for (std::size_t k = 3; k < size_; ++k)
        std::copy_n(&own[k * width], width, &values[index(mesh_.triangles[t * size_ + k]) * width]);
    }
    begin(field, view, "NodeData", static_cast<std::size_t>(std::count(used_.begin(), used_.end(), 1)));
    for (std::size_t p = 0; p < mesh_.points.size(); ++p) {
      if (!used_[p]) continue;
      rows_.put(static_cast<std::int32_t>(p + 1));
      put(&values[p * width], view);
      rows_.end_row();
    }
    rows_.end_section("NodeData");
  }

  void write_by_element(const Field& field, const View& view) {
    const std::size_t width = index(field.components);
    NodeValues nodes(mesh_, field);
    begin(field, view, "ElementNodeData", mesh_.triangle_faces.size());
    for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t) {
      const std::vector<double>& own = nodes.of_triangle(t);
      rows_.put(static_cast<std::int32_t>(t + 1)).put(static_cast<std::int32_t>(size_));
      for (const int k : order_) put(&own[index(k) * width], view);
      rows_.end_row();
    }
    rows_.end_section("ElementNodeData");
  }

  const MeshData& mesh_;
  const std::vector<int>& order_;
  const std::vector<char>& used_;
  MshRows& rows_;
  std::size_t size_;
  std::set<std::string> names_;
};

}  // namespace

std::string msh_quoted(std::string name, std::size_t longest) {
  // Gmsh ends a name at a quote and at the end of the line.
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
    if (c == '"') c = '\'';
  }
  if (name.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;  // leave no half character
    name.resize(end);
  }
  return '"' + name + '"';
}

void write_msh_fields(const MeshData& mesh, const std::vector<int>& order, const std::vector<char>& used,
                      MshRows& rows) {
  FieldWriter writer(mesh, order, used, rows);
  for (const Field& field : mesh.fields) writer.write(field);
}

}  // namespace pliant
