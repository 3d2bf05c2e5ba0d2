// tests/flow/flow_meshes.h: meshes for motion: closed cells, and two rooms with corners and an interface.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>

#include "pliant/geometry/control_net.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/mesh.h"
#include "support/sample_meshes.h"

namespace pliant::flow_meshes {

/// The greatest distance between control points of the two meshes.
inline double difference(const Mesh& a, const Mesh& b) {
  double greatest = 0;
  for (PointId p = 0; p < a.point_slots(); ++p) greatest = std::max(greatest, distance(a.point(p), b.point(p)));
  return greatest;
}

/// A straight open curve of two spans.
inline Curve straight_curve(int degree, const std::vector<Point>& vertices, int start, int end, int left, int right) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  knots.push_back(0.5);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  const Point a = vertices[static_cast<std::size_t>(start)];
  const Point b = vertices[static_cast<std::size_t>(end)];
  std::vector<Point> points;
  for (int i = 0; i < degree + 2; ++i) {
    double g = 0;
    for (int k = 1; k <= degree; ++k) g += knots[static_cast<std::size_t>(i + k)] / degree;
    points.push_back(i == 0 ? a : i == degree + 1 ? b : a + g * (b - a));
  }
  Curve curve;
  curve.spline = BSpline(degree, false, std::move(knots), std::move(points));
  curve.start = start;
  curve.end = end;
  curve.left = left;
  curve.right = right;
  return curve;
}

/// Two unit squares side by side, faces "west" and "east", with an interface between them: seven open curves.
inline MeshData two_rooms(int degree) {
  samples::MeshBuilder builder(degree);
  MeshData& data = builder.data();
  BoundaryComplex& boundary = data.boundary;
  boundary.vertices = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  boundary.faces = {{"west", {}}, {"east", {}}};
  const std::vector<std::array<int, 4>> sides{{0, 1, 0, outside}, {1, 2, 1, outside}, {2, 3, 1, outside},
                                              {3, 4, 1, outside}, {4, 5, 0, outside}, {5, 0, 0, outside},
                                              {1, 4, 0, 1}};
  std::vector<PointId> corners, middles;
  for (const Point& v : boundary.vertices) corners.push_back(builder.add_vertex(v));
  for (std::size_t c = 0; c < sides.size(); ++c) {
    const auto [start, end, left, right] = sides[c];
    boundary.curves.push_back(straight_curve(degree, boundary.vertices, start, end, left, right));
    boundary.curves.back().name = "side " + std::to_string(c);
    const BSpline& spline = boundary.curves.back().spline;
    middles.push_back(builder.add_vertex(spline.evaluate(0.5)));
    std::vector<Point> polygon(static_cast<std::size_t>(degree) + 1);
    for (int span = 0; span < 2; ++span) {
      const PointId a = span == 0 ? corners[static_cast<std::size_t>(start)] : middles.back();
      const PointId b = span == 0 ? middles.back() : corners[static_cast<std::size_t>(end)];
      spline.extract(0.5 * span, polygon);
      data.constrained_edges.push_back({static_cast<CurveId>(c), span, builder.curved_edge(a, b, polygon)});
    }
  }
  const auto fan = [&](const Point& center, const std::vector<PointId>& rim, FaceId face) {
    const PointId middle = builder.add_vertex(center);
    for (std::size_t i = 0; i < rim.size(); ++i) builder.add_triangle(middle, rim[i], rim[(i + 1) % rim.size()], face);
  };
  const auto& c = corners;
  const auto& m = middles;
  fan({0.5, 0.5}, {c[0], m[0], c[1], m[6], c[4], m[4], c[5], m[5]}, 0);
  fan({1.5, 0.5}, {c[1], m[1], c[2], m[2], c[3], m[3], c[4], m[6]}, 1);
  return std::move(data);
}

/// The mesh scaled about the origin by `factor`, then shifted.
inline MeshData scaled(MeshData data, double factor, const Vector& shift) {
  const auto move = [&](Point& x) { x = shift + factor * x; };
  for (Point& x : data.points) move(x);
  for (Point& x : data.boundary.vertices) move(x);
  for (Curve& curve : data.boundary.curves)
    for (std::size_t i = 0; i < curve.spline.points().size(); ++i)
      curve.spline.set_point(static_cast<int>(i), shift + factor * curve.spline.points()[i]);
  return data;
}

/// The sample meshes of one degree.
inline std::vector<MeshData> all(int degree) {
  return {samples::disk(degree), samples::three_disks(degree), two_rooms(degree)};
}

/// The area enclosed by all curves, by Green's theorem. Requires a boundary of closed curves with nothing on the right.
inline double enclosed_area(const Mesh& mesh) {
  double area = 0;
  for (const Curve& curve : mesh.boundary().curves) area += curve.spline.area();
  return area;
}

/// The greatest angle between the tangents on both sides of a break at which the curve should be smooth.
inline double tangent_jump(const Mesh& mesh) {
  double greatest = 0;
  for (const Curve& curve : mesh.boundary().curves) {
    const BSpline& spline = curve.spline;
    std::vector<double> breaks = spline.breaks();
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
      if (spline.multiplicity(breaks[i]) >= spline.degree()) continue;
      const Vector a = spline.derivative(breaks[i], true);
      const Vector b = spline.derivative(breaks[i], false);
      greatest = std::max(greatest, std::abs(std::atan2(cross(a, b), dot(a, b))));
    }
  }
  return greatest;
}

/// Checks M1 to M6.
inline void check_all(const Mesh& mesh) {
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
}

}  // namespace pliant::flow_meshes
