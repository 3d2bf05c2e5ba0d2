// tests/support/mapped_meshes.h: regular meshes of a square, curved by a smooth map, for orders of convergence.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant::samples {

using Map = std::function<Point(double x, double y)>;

/// The map of a square that stays as it is, and the names of its curves.
inline Point as_it_is(double x, double y) { return {x, y}; }
inline const std::vector<std::string> square_sides{"south", "east", "north", "west"};

/// The unit square divided into n x n cells of two triangles of degree p, each of which interpolates the map at its
/// nodes: a family in n whose second derivatives with respect to barycentric coordinates fall with 1 / n^2. With
/// `divided` (n even) there are two faces, "left" and "right" of the curve "middle", x = 1/2; else one, "domain". The
/// other curves are "south", "east", "north" and "west"; where the square is divided, two curves have the name "south",
/// and two "north". Every curve has knots of multiplicity p.
inline MeshData mapped_square(int p, int n, const Map& map, bool divided = false) {
  const int side = n * p + 1;
  MeshData data;
  data.degree = p;
  data.points.resize(index(side * side));
  const auto at = [side](int i, int j) { return static_cast<PointId>(j * side + i); };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      data.points[index(at(i, j))] = map(static_cast<double>(i) / (side - 1), static_cast<double>(j) / (side - 1));

  const NetLayout& layout = NetLayout::of(p);
  for (int cell = 0; cell < n * n; ++cell)
    for (const bool upper : {false, true}) {
      const int i0 = p * (cell % n), j0 = p * (cell / n);
      for (int k = 0; k < layout.size(); ++k) {
        const auto& exponents = layout.exponents(k);
        const int b = exponents[1], c = exponents[2];
        data.triangles.push_back(upper ? at(i0 + b, j0 + b + c) : at(i0 + b + c, j0 + c));
      }
      data.triangle_faces.push_back(divided && 2 * (cell % n) >= n ? 1 : 0);
    }
  // Values at nodes become control points: edges first, each once, then insides.
  std::vector<char> done(data.points.size(), 0);
  std::vector<double> polygon(2 * (index(p) + 1)), net(2 * index(layout.size()));
  const auto load = [&](std::vector<double>& to, std::size_t k, PointId q) {
    to[2 * k] = data.points[index(q)].x;
    to[2 * k + 1] = data.points[index(q)].y;
  };
  const auto store = [&](const std::vector<double>& from, std::size_t k, PointId q) {
    data.points[index(q)] = {from[2 * k], from[2 * k + 1]};
    done[index(q)] = 1;
  };
  for (const bool inside : {false, true})
    for (std::size_t t = 0; t < data.triangle_faces.size(); ++t) {
      const PointId* points = data.triangles.data() + t * index(layout.size());
      for (int e = 0; e < 3 && !inside && p > 1; ++e) {
        if (done[index(points[layout.edge_index(e, 1)])] != 0) continue;
        for (int k = 0; k <= p; ++k) load(polygon, index(k), points[layout.edge_index(e, k)]);
        interpolate_polygon(p, 2, polygon);
        for (int k = 1; k < p; ++k) store(polygon, index(k), points[layout.edge_index(e, k)]);
      }
      if (!inside || p < 3) continue;
      for (int k = 0; k < layout.size(); ++k) load(net, index(k), points[k]);
      interpolate_interior(p, 2, net);
      for (int k = layout.first_interior(); k < layout.size(); ++k) store(net, index(k), points[k]);
    }

  BoundaryComplex& boundary = data.boundary;
  for (const std::string& name :
       divided ? std::vector<std::string>{"left", "right"} : std::vector<std::string>{"domain"})
    boundary.faces.push_back({name, {}});
  std::vector<std::pair<int, int>> vertices;
  const auto vertex = [&](int i, int j) {
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (vertices[v] == std::pair(i, j)) return static_cast<int>(v);
    vertices.emplace_back(i, j);
    boundary.vertices.push_back(data.points[index(at(i, j))]);
    return static_cast<int>(vertices.size()) - 1;
  };
  const auto add_curve = [&](const std::string& name, int i, int j, int di, int dj, int spans, int left, int right) {
    Curve curve;
    curve.name = name;
    curve.start = vertex(i, j);
    curve.end = vertex(i + di * p * spans, j + dj * p * spans);
    curve.left = left;
    curve.right = right;
    std::vector<double> knots{0};
    std::vector<Point> points;
    for (int k = 0; k <= spans; ++k)
      for (int m = 0; m < p; ++m) knots.push_back(k);
    knots.push_back(spans);
    for (int k = 0; k <= spans * p; ++k) points.push_back(data.points[index(at(i + k * di, j + k * dj))]);
    curve.spline = BSpline(p, false, knots, points);
    for (int s = 0; s < spans; ++s) {
      ConstrainedEdge edge{static_cast<CurveId>(boundary.curves.size()), s, {}};
      for (int k = s * p; k <= (s + 1) * p; ++k) edge.points.push_back(at(i + k * di, j + k * dj));
      data.constrained_edges.push_back(edge);
    }
    boundary.curves.push_back(curve);
  };
  const int end = n * p, half = n / 2, middle = half * p, right = divided ? 1 : 0;
  if (divided) {
    add_curve("south", 0, 0, 1, 0, half, 0, outside);
    add_curve("south", middle, 0, 1, 0, n - half, 1, outside);
    add_curve("middle", middle, 0, 0, 1, n, 0, 1);
  } else {
    add_curve("south", 0, 0, 1, 0, n, 0, outside);
  }
  add_curve("east", end, 0, 0, 1, n, right, outside);
  if (divided) {
    add_curve("north", end, end, -1, 0, n - half, 1, outside);
    add_curve("north", middle, end, -1, 0, half, 0, outside);
  } else {
    add_curve("north", end, end, -1, 0, n, 0, outside);
  }
  add_curve("west", 0, end, 0, -1, n, 0, outside);
  return data;
}

/// A map of the square that bends everything, sides too.
inline Point bend(double x, double y) { return {x + 0.08 * std::sin(3 * x + 2 * y), y + 0.1 * std::cos(2.5 * x - y)}; }

}  // namespace pliant::samples
