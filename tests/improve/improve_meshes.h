// tests/improve/improve_meshes.h: meshes of many boundaries with fields, straight meshes, and what passes must leave.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "formats/document/mesh_document.h"
#include "ops/random_operations.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_boundaries.h"

namespace pliant::improve_meshes {

/// Adds two fields: field 0 is the linear function x + 2y - 3, field 1 is noise of two components, with values of its
/// own on each face if `by_face`.
inline void add_fields(MeshData& data, bool by_face = false) {
  samples::add_field(data, "linear", 1, [](const Point& p) { return std::vector<double>{p.x + 2 * p.y - 3}; });
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> noise(-1, 1);
  if (!by_face) {
    samples::add_field(data, "noise", 2, [&](const Point&) {
      return std::vector<double>{noise(random), noise(random)};
    });
    return;
  }
  Field field;
  field.name = "noise";
  field.components = 2;
  field.by_face = true;
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    field.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::sort(field.places.begin(), field.places.end());
  field.places.erase(std::unique(field.places.begin(), field.places.end()), field.places.end());
  for (std::size_t k = 0; k < 2 * field.places.size(); ++k) field.values.push_back(noise(random));
  data.fields.push_back(std::move(field));
}

struct Sample {
  std::string name;
  BoundaryComplex boundary;
};
/// Boundaries that can be meshed at this degree.
inline std::vector<Sample> boundaries(int degree) {
  using namespace samples;
  std::vector<Sample> all{{"one cell", one_cell(degree)},
                          {"biconcave cell", biconcave_cell(degree)},
                          {"three cells", three_cells(degree)},
                          {"annulus", annulus(degree)},
                          {"cells in a channel", samples::interface(degree)},
                          {"gear", gear(12)}};
  if (degree >= 2) {
    all.push_back({"divided square", divided_square()});
    all.push_back({"glyph", glyph()});
  }
  if (degree >= 3) all.push_back({"crescent", crescent(0.3)});
  return all;
}

/// A mesh of the boundary that carries the two fields.
inline Mesh mesh_of(const BoundaryComplex& boundary, int degree, bool by_face = false) {
  Mesh mesh;
  GenerateOptions options;
  options.degree = degree;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, options, mesh);
  INFO(outcome.failure);
  REQUIRE(outcome.ok);
  MeshData data = mesh.to_data();
  add_fields(data, by_face);
  return Mesh(std::move(data));
}

/// A straight curve of equal spans from one vertex of the boundary to another.
inline Curve straight_curve(const BoundaryComplex& boundary, int degree, int spans, int start, int end, int left,
                            int right = outside) {
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (int k = 0; k <= spans; ++k) knots.push_back(k);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), static_cast<double>(spans));
  const Point a = boundary.vertices[static_cast<std::size_t>(start)];
  const Point b = boundary.vertices[static_cast<std::size_t>(end)];
  const int count = spans + degree;
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    double greville = 0;
    for (int k = 1; k <= degree; ++k) greville += knots[static_cast<std::size_t>(i + k)] / degree;
    points.push_back(i == 0 ? a : i == count - 1 ? b : a + (greville / spans) * (b - a));
  }
  Curve curve;
  curve.name = "side " + std::to_string(boundary.curves.size());
  curve.spline = BSpline(degree, false, std::move(knots), std::move(points));
  curve.start = start;
  curve.end = end;
  curve.left = left;
  curve.right = right;
  return curve;
}

/// The square [0, n]², cut into n² cells with a diagonal each, so that many vertices lie on one line or one circle.
inline Mesh grid(int degree, int n, std::uint64_t seed) {
  samples::MeshBuilder builder(degree);
  MeshData& data = builder.data();
  data.boundary = samples::with_faces({"grid"});
  const double side = n;
  data.boundary.vertices = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) builder.add_vertex({double(x), double(y)});
  const auto at = [n](int x, int y) { return static_cast<PointId>(y * (n + 1) + x); };
  for (int c = 0; c < 4; ++c) {
    data.boundary.curves.push_back(straight_curve(data.boundary, degree, n, c, (c + 1) % 4, 0));
    const auto place = [&](int k) {
      return c == 0 ? at(k, 0) : c == 1 ? at(n, k) : c == 2 ? at(n - k, n) : at(0, n - k);
    };
    for (int k = 0; k < n; ++k) data.constrained_edges.push_back({c, k, builder.edge(place(k), place(k + 1))});
  }
  std::mt19937_64 random(seed);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const PointId a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
      if (random() % 2) {
        builder.add_triangle(a, b, c, 0);
        builder.add_triangle(a, c, d, 0);
      } else {
        builder.add_triangle(a, b, d, 0);
        builder.add_triangle(b, c, d, 0);
      }
    }
  MeshData out = std::move(data);
  add_fields(out);
  return Mesh(std::move(out));
}

/// A square of two faces with a slanted line between them. Its elements are straight, made by inserting random points
/// and flipping random edges.
inline Mesh scattered(int degree, int points, std::uint64_t seed) {
  BoundaryComplex boundary = samples::with_faces({"west", "east"});
  boundary.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.35, 0}, {0.72, 1}};
  const int sides[7][4] = {{0, 4, 0, outside}, {4, 1, 1, outside}, {1, 2, 1, outside}, {2, 5, 1, outside},
                           {5, 3, 0, outside}, {3, 0, 0, outside}, {4, 5, 0, 1}};
  for (const auto& [start, end, left, right] : sides)
    boundary.curves.push_back(straight_curve(boundary, degree, 1, start, end, left, right));
  Mesh mesh = mesh_of(boundary, degree);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  for (int k = 0; k < points; ++k) {
    const auto t = static_cast<TriangleId>(random() % static_cast<unsigned>(mesh.triangle_slots()));
    Barycentric xi{uniform(random), uniform(random), uniform(random)};
    const double sum = xi[0] + xi[1] + xi[2];
    for (double& x : xi) x /= sum;
    if (k % 5 == 4) {
      const HalfEdgeId h = half_edge(t, static_cast<int>(random() % 3));
      split_edge(mesh, h, 0.25 + uniform(random) / 2);  // may be refused: some triangles are nearly flat
    } else {
      insert_point(mesh, t, xi);
    }
    flip_edge(mesh, static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots())));
  }
  mesh.compact();
  return mesh;
}

inline std::string text_of(const Mesh& mesh) {
  std::string text;
  write_mesh(mesh.to_data(), text);
  return text;
}

/// Checks what every pass must leave: M1 to M6, and a mesh that is numbered as its document is (so that a pipe equals
/// one process).
inline void check_left(const Mesh& mesh) {
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
  const std::string text = text_of(mesh);
  const bool is_own_document = text_of(Mesh(read_mesh(text))) == text;
  CHECK(is_own_document);
  CHECK(mesh.triangle_slots() == mesh.triangle_count());
}

inline double value_of(const PassReport& report, const std::string& name) {
  for (const auto& [known, value] : report.values)
    if (known == name) return value;
  FAIL("no value " << name);
  return 0;
}

/// Least angle of the logical triangle, in degrees, by arc tangents: the passes compare another measure.
inline double least_angle(const Mesh& mesh, TriangleId t) {
  double least = 180;
  for (int c = 0; c < 3; ++c) {
    const Point& a = mesh.point(mesh.corner(t, c));
    const Vector u = mesh.point(mesh.corner(t, (c + 1) % 3)) - a, v = mesh.point(mesh.corner(t, (c + 2) % 3)) - a;
    least = std::min(least, std::atan2(cross(u, v), dot(u, v)) * 180 / std::numbers::pi);
  }
  return least;
}

inline double area_at(const Mesh& mesh, TriangleId t) {
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  mesh.gather_points(t, net);
  return element_area(mesh.degree(), net);
}

/// Largest distance of points of one curve from a dense polygon of the other. It includes the distance of the polygon
/// from the curve that it stands for.
inline double distance_of_curves(const BSpline& from, const BSpline& to, int samples = 300) {
  const int dense = 1500;
  std::vector<Point> polygon;
  for (int k = 0; k <= dense; ++k) polygon.push_back(to.evaluate(to.first_parameter() + to.period() * k / dense));
  double worst = 0;
  for (int k = 0; k <= samples; ++k) {
    const Point p = from.evaluate(from.first_parameter() + from.period() * k / samples);
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const Vector along = polygon[i + 1] - polygon[i];
      const double s = std::clamp(dot(p - polygon[i], along) / std::max(1e-300, squared_length(along)), 0.0, 1.0);
      least = std::min(least, distance(p, polygon[i] + s * along));
    }
    worst = std::max(worst, least);
  }
  return worst;
}

}  // namespace pliant::improve_meshes
