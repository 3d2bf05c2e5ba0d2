// tests/support/sample_meshes.h: structurally correct meshes (M1–M6) made without any other layer.
#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant::samples {

/// A closed B-spline of `spans` uniform spans whose control points lie on a circle. It is round, but no circle.
inline BSpline round_spline(int degree, int spans, const Point& center, double radius) {
  std::vector<double> knots;
  std::vector<Point> points;
  for (int i = 0; i <= spans; ++i) knots.push_back(i);
  for (int i = 0; i < spans; ++i) {
    const double angle = 2 * std::numbers::pi * i / spans;
    points.push_back(center + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return BSpline(degree, true, std::move(knots), std::move(points));
}

/// Builds elements that share the control points of common edges. Inner control points blend the displacements of the
/// edges from straight ones, so that an element with straight edges is affine.
class MeshBuilder {
 public:
  explicit MeshBuilder(int degree) : layout_(NetLayout::of(degree)) { data_.degree = degree; }

  PointId add_vertex(const Point& p) {
    data_.points.push_back(p);
    return static_cast<PointId>(data_.points.size()) - 1;
  }
  const Point& at(PointId p) const { return data_.points[static_cast<std::size_t>(p)]; }

  /// The control points of the edge from a to b, made straight if the edge is new.
  std::vector<PointId> edge(PointId a, PointId b) {
    if (const auto found = edges_.find({b, a}); found != edges_.end())
      return {found->second.rbegin(), found->second.rend()};
    std::vector<PointId>& edge = edges_[{a, b}];
    if (edge.empty()) {
      const int p = data_.degree;
      edge.push_back(a);
      for (int k = 1; k < p; ++k) edge.push_back(add_vertex(at(a) + (at(b) - at(a)) * (double(k) / p)));
      edge.push_back(b);
    }
    return edge;
  }

  /// Gives the edge from points.front() to points.back(), whose ends are the vertices a and b, its shape.
  std::vector<PointId> curved_edge(PointId a, PointId b, const std::vector<Point>& points) {
    std::vector<PointId> ids = edge(a, b);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) data_.points[static_cast<std::size_t>(ids[k])] = points[k];
    return ids;
  }

  void add_triangle(PointId a, PointId b, PointId c, FaceId face) {
    const int p = data_.degree;
    const std::array<PointId, 3> corners{a, b, c};
    std::array<std::vector<PointId>, 3> edges;
    std::vector<PointId> net{a, b, c};
    for (std::size_t e = 0; e < 3; ++e) {
      edges[e] = edge(corners[e], corners[(e + 1) % 3]);
      net.insert(net.end(), edges[e].begin() + 1, edges[e].end() - 1);
    }
    for (int n = layout_.first_interior(); n < layout_.size(); ++n) {
      const std::array<int, 3>& ijk = layout_.exponents(n);
      Point inner = (at(a) * ijk[0] + at(b) * ijk[1] + at(c) * ijk[2]) / p;
      for (std::size_t e = 0; e < 3; ++e) {
        // The edge's displacement at the foot of this point, fading towards the opposite corner.
        const int from = ijk[e], to = ijk[(e + 1) % 3];
        const double s = double(p) * to / (from + to);
        const auto k = static_cast<std::size_t>(std::min(p - 1, int(s)));
        const auto bend = [&](std::size_t m) {
          const double w = double(m) / p;
          return at(edges[e][m]) - (at(edges[e].front()) * (1 - w) + at(edges[e].back()) * w);
        };
        const double fade = double(from + to) / p, f = s - double(k);
        inner += (bend(k) * (1 - f) + bend(k + 1) * f) * (fade * fade);
      }
      net.push_back(add_vertex(inner));
    }
    data_.triangles.insert(data_.triangles.end(), net.begin(), net.end());
    data_.triangle_faces.push_back(face);
  }

  MeshData& data() { return data_; }

 private:
  const NetLayout& layout_;
  MeshData data_;
  std::map<std::pair<PointId, PointId>, std::vector<PointId>> edges_;
};

/// Adds a round cell of 3 * spans elements: `spans` constrained edges on a closed B-spline, with a curved ring inside.
inline void add_disk(MeshBuilder& builder, int spans, const Point& center, double radius, const std::string& name) {
  MeshData& data = builder.data();
  const auto face = static_cast<FaceId>(data.boundary.faces.size());
  const auto curve = static_cast<CurveId>(data.boundary.curves.size());
  const auto count = static_cast<std::size_t>(data.degree) + 1;
  Curve outline;
  outline.name = name;
  outline.spline = round_spline(data.degree, spans, center, radius);
  outline.left = face;
  const std::vector<double> breaks = outline.spline.breaks();
  const auto n = static_cast<std::size_t>(spans);
  std::vector<std::vector<Point>> outer(n, std::vector<Point>(count)), inner;
  for (std::size_t s = 0; s < n; ++s) outline.spline.extract(breaks[s], outer[s]);
  inner = outer;
  for (std::vector<Point>& edge : inner)
    for (Point& p : edge) p = center + (p - center) * 0.5;

  const PointId middle = builder.add_vertex(center);
  std::vector<PointId> rim, ring;
  for (std::size_t s = 0; s < n; ++s) rim.push_back(builder.add_vertex(outer[s].front()));
  for (std::size_t s = 0; s < n; ++s) ring.push_back(builder.add_vertex(inner[s].front()));
  for (std::size_t s = 0; s < n; ++s) {
    const std::size_t t = (s + 1) % n;
    data.constrained_edges.push_back({curve, static_cast<int>(s), builder.curved_edge(rim[s], rim[t], outer[s])});
    builder.curved_edge(ring[s], ring[t], inner[s]);
  }
  for (std::size_t s = 0; s < n; ++s) {
    const std::size_t t = (s + 1) % n;
    builder.add_triangle(middle, ring[s], ring[t], face);
    builder.add_triangle(ring[s], rim[s], rim[t], face);
    builder.add_triangle(ring[s], rim[t], ring[t], face);
  }
  data.boundary.faces.push_back({name, {}});
  data.boundary.curves.push_back(std::move(outline));
}

/// One round cell of any degree; `spans` at least 8 (with fewer, curved edges make some elements invalid).
inline MeshData disk(int degree, int spans = 8, const Point& center = {0, 0}, double radius = 1) {
  MeshBuilder builder(degree);
  add_disk(builder, spans, center, radius, "cell");
  return std::move(builder.data());
}

/// Three disjoint round cells, each a face of its own.
inline MeshData three_disks(int degree, int spans = 8) {
  MeshBuilder builder(degree);
  add_disk(builder, spans, {0, 1.5}, 1, "upper");
  add_disk(builder, spans, {0.5, -1}, 1, "lower");
  add_disk(builder, spans, {3, 0.25}, 1.25, "right");
  return std::move(builder.data());
}

/// Adds a field whose control values are `values` at the control points; this is exact for linear functions.
inline void add_field(MeshData& data, const std::string& name, int components,
                      const std::function<std::vector<double>(const Point&)>& values) {
  Field field;
  field.name = name;
  field.components = components;
  for (const Point& p : data.points) {
    const std::vector<double> row = values(p);
    field.values.insert(field.values.end(), row.begin(), row.end());
  }
  data.fields.push_back(std::move(field));
}

}  // namespace pliant::samples
