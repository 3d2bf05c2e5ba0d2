// lib/pliant/mesh/interpolate_nodes.cpp: interpolation at vertices, then along edges, then inside triangles.
#include "pliant/mesh/interpolate_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

/// Interpolates at the three kinds of nodes, and holds the scratch space for them.
class NodeInterpolation {
 public:
  NodeInterpolation(const Mesh& mesh, int width, const NodeFunction& function, std::span<char> known,
                    std::span<double> rows)
      : mesh_(mesh),
        function_(function),
        known_(known),
        rows_(rows),
        degree_(mesh.degree()),
        width_(static_cast<std::size_t>(width)),
        positions_(2 * static_cast<std::size_t>(mesh.net_size())),
        values_(static_cast<std::size_t>(mesh.net_size()) * width_) {}

  void vertex(PointId v) {
    if (is_known(v)) return;
    mark(v);
    function_(mesh_.point(v), row(v));
  }

  /// Requires both end points to be known.
  void edge(HalfEdgeId h) {
    if (degree_ < 2 || is_known(mesh_.edge_point(h, 1))) return;
    for (int k = 0; k <= degree_; ++k) place(k, mesh_.edge_point(h, k));
    const std::size_t rows = static_cast<std::size_t>(degree_) + 1;
    copy_in(0, mesh_.edge_point(h, 0));
    copy_in(degree_, mesh_.edge_point(h, degree_));
    for (int k = 1; k < degree_; ++k) {
      std::array<double, 2> x;
      evaluate_polygon(degree_, 2, std::span(positions_).first(2 * rows), static_cast<double>(k) / degree_, x);
      function_({x[0], x[1]}, value(k));
    }
    interpolate_polygon(degree_, static_cast<int>(width_), std::span(values_).first(rows * width_));
    for (int k = 1; k < degree_; ++k) copy_out(k, mesh_.edge_point(h, k));
  }

  /// Requires the points of all three edges to be known.
  void interior(TriangleId t) {
    const NetLayout& layout = mesh_.layout();
    const auto net = mesh_.net(t);
    const int first = layout.first_interior();
    if (degree_ < 3 || is_known(net[static_cast<std::size_t>(first)])) return;
    for (int i = 0; i < layout.size(); ++i) place(i, net[static_cast<std::size_t>(i)]);
    for (int i = 0; i < first; ++i) copy_in(i, net[static_cast<std::size_t>(i)]);
    for (int i = first; i < layout.size(); ++i) {
      const auto& exponents = layout.exponents(i);
      Barycentric xi{};
      for (std::size_t c = 0; c < 3; ++c) xi[c] = static_cast<double>(exponents[c]) / degree_;
      std::array<double, 2> x;
      evaluate_net(degree_, 2, positions_, xi, x);
      function_({x[0], x[1]}, value(i));
    }
    interpolate_interior(degree_, static_cast<int>(width_), values_);
    for (int i = first; i < layout.size(); ++i) copy_out(i, net[static_cast<std::size_t>(i)]);
  }

 private:
  bool is_known(PointId p) const { return known_[static_cast<std::size_t>(p)] != 0; }
  void mark(PointId p) { known_[static_cast<std::size_t>(p)] = 1; }
  std::span<double> row(PointId p) { return rows_.subspan(static_cast<std::size_t>(p) * width_, width_); }
  std::span<double> value(int i) { return std::span(values_).subspan(static_cast<std::size_t>(i) * width_, width_); }
  void place(int i, PointId p) {
    positions_[2 * static_cast<std::size_t>(i)] = mesh_.point(p).x;
    positions_[2 * static_cast<std::size_t>(i) + 1] = mesh_.point(p).y;
  }
  void copy_in(int i, PointId p) { std::ranges::copy(row(p), value(i).begin()); }
  void copy_out(int i, PointId p) {
    mark(p);
    std::ranges::copy(value(i), row(p).begin());
  }

  const Mesh& mesh_;
  const NodeFunction& function_;
  std::span<char> known_;
  std::span<double> rows_;
  int degree_;
  std::size_t width_;
  std::vector<double> positions_;
  std::vector<double> values_;
};

bool is_selected(const Mesh& mesh, TriangleId t, FaceId face) {
  return mesh.is_alive(t) && (face == none || mesh.face(t) == face);
}

}  // namespace

void interpolate_nodes(const Mesh& mesh, FaceId face, int width, const NodeFunction& function, std::span<char> known,
                       std::span<double> rows) {
  NodeInterpolation nodes(mesh, width, function, known, rows);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!is_selected(mesh, t, face)) continue;
    for (int c = 0; c < 3; ++c) nodes.vertex(mesh.corner(t, c));
    for (int e = 0; e < 3; ++e) nodes.edge(half_edge(t, e));
    nodes.interior(t);
  }
}

int find_field(const Mesh& mesh, const std::string& name) {
  for (std::size_t f = 0; f < mesh.fields().size(); ++f)
    if (mesh.fields()[f].name == name) return static_cast<int>(f);
  return none;
}

std::vector<std::array<std::int32_t, 2>> field_places(const Mesh& mesh) {
  std::vector<std::array<std::int32_t, 2>> places;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t))
      for (const PointId p : mesh.net(t)) places.push_back({p, mesh.face(t)});
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

Field make_field(const Mesh& mesh, const std::string& name, int components, FaceId face, const NodeFunction& function,
                 std::string& why) {
  const auto width = static_cast<std::size_t>(components);
  const auto slots = static_cast<std::size_t>(mesh.point_slots());
  std::vector<char> known(slots, 0);
  std::vector<double> rows(slots * width, 0.0);
  why.clear();
  const NodeFunction checked = [&](const Point& place, std::span<double> value) {
    function(place, value);
    if (!why.empty() || std::ranges::all_of(value, [](double v) { return std::isfinite(v); })) return;
    std::ostringstream text;
    text.precision(17);
    text << "the field \"" << name << "\" is not finite at (" << place.x << ", " << place.y << ")";
    why = text.str();
  };
  interpolate_nodes(mesh, face, components, checked, known, rows);
  const int old = find_field(mesh, name);
  Field field;
  field.name = name;
  field.components = components;
  field.by_face = face != none;
  if (old != none) field.extra = mesh.fields()[static_cast<std::size_t>(old)].extra;
  if (face != none && old != none && mesh.fields()[static_cast<std::size_t>(old)].components != components)
    why = "the field \"" + name + "\" has another number of components on the other faces";
  if (!why.empty()) return field;
  if (face == none) {
    field.values = std::move(rows);
    return field;
  }
  field.places = field_places(mesh);
  field.values.reserve(field.places.size() * width);
  for (const auto& [p, f] : field.places) {
    const double* from = nullptr;
    if (f == face) {
      from = &rows[static_cast<std::size_t>(p) * width];
    } else if (old != none) {
      const std::ptrdiff_t index = mesh.value_index(old, p, f);
      if (index != none) from = &mesh.fields()[static_cast<std::size_t>(old)].values[static_cast<std::size_t>(index)];
    }
    for (std::size_t c = 0; c < width; ++c) field.values.push_back(from != nullptr ? from[c] : 0.0);
  }
  return field;
}

}  // namespace pliant
