// tests/mesh/curved_samples.h: strongly curved meshes of many shapes, and checks of what is located in them.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/locate.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"
#include "support/triangles.h"

namespace pliant::samples {

inline Point image(const Mesh& mesh, TriangleId t, const Barycentric& xi) {
  std::vector<Point> net(index(mesh.net_size()));
  mesh.gather_points(t, net);
  Point value;
  evaluate_net(mesh.degree(), 2, {&net[0].x, 2 * net.size()}, xi, {&value.x, 2});
  return value;
}

/// A band along two turns of a spiral.
inline BoundaryComplex spiral(int degree) {
  std::vector<Point> points;
  const auto add = [&](double angle, double off) {
    points.push_back((0.3 + 0.12 * angle / std::numbers::pi + off) * Point{std::cos(angle), std::sin(angle)});
  };
  for (int k = 0; k <= 40; ++k) add(0.1 * k * std::numbers::pi, 0.05);
  for (int k = 40; k >= 0; --k) add(0.1 * k * std::numbers::pi, -0.05);
  BoundaryComplex b = with_faces({"band"});
  b.curves.push_back(closed_curve("outline", closed_spline(degree, points), 0));
  return b;
}

/// A channel with an obstacle in it, which is a hole.
inline BoundaryComplex channel(int degree) {
  BoundaryComplex b = with_faces({"fluid"});
  b.vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "wall", i, (i + 1) % 4, {}, 0));
  b.curves.push_back(closed_curve("obstacle", circle(degree, {1, 0.5}, 0.35), outside, 0));
  return b;
}

struct Sample {
  std::string name;
  Mesh mesh;
};

inline Mesh meshed(const BoundaryComplex& boundary, int degree, double area = 0) {
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, {degree}, mesh);
  CAPTURE(outcome.failure);
  REQUIRE(outcome.ok);
  if (area > 0) {
    RefineOptions options;
    options.goals.emplace().max_area = area;
    refine(mesh, options);
  }
  return mesh;
}

/// Makes elements strongly curved: moves inner control points and inner vertices at random, if elements stay valid.
inline void shake(Mesh& mesh, int moves, int seed) {
  std::vector<std::vector<TriangleId>> users(index(mesh.point_slots()));
  std::vector<bool> is_fixed(index(mesh.point_slots()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    for (const PointId p : mesh.net(t)) users[index(p)].push_back(t);
    for (int e = 0; e < 3; ++e)
      for (int k = 0; k <= mesh.degree() && mesh.twin(half_edge(t, e)) == none; ++k)
        is_fixed[index(mesh.edge_point(half_edge(t, e), k))] = true;
  }
  Random random(seed);
  for (int move = 0; move < moves; ++move) {
    const PointId p = random.integer(0, mesh.point_slots() - 1);
    if (is_fixed[index(p)]) continue;
    const Point before = mesh.point(p);
    const TriangleId first = users[index(p)].front();
    const double length = distance(mesh.point(mesh.corner(first, 0)), mesh.point(mesh.corner(first, 1)));
    mesh.set_point(p, before + length * random.point(-0.6, 0.6));
    if (!std::ranges::all_of(users[index(p)],
                             [&](TriangleId t) { return certify_element(mesh, t) == Validity::valid; }))
      mesh.set_point(p, before);
  }
}

inline std::vector<Sample> sample_meshes(int degree) {
  std::vector<Sample> all{{"cell", meshed(one_cell(degree), degree, 0.01)},
                          {"annulus", meshed(annulus(degree), degree)},
                          {"gear", meshed(gear(12), degree)},
                          {"channel", meshed(channel(degree), degree, 0.02)},
                          {"three cells", meshed(three_cells(degree), degree)},
                          {"spiral", meshed(spiral(degree), degree)}};
  if (degree >= 2) all.push_back({"glyph", meshed(glyph(), degree)});
  if (degree >= 3) all.push_back({"crescent", meshed(crescent(0.6), degree)});
  if (degree >= 3) all.push_back({"crescent with a cusp", meshed(crescent(0), degree)});
  if (degree >= 2)
    for (Sample& sample : all) {
      shake(sample.mesh, 30000 / degree / degree, degree);
      REQUIRE(find_invalid(sample.mesh).empty());
    }
  return all;
}

/// All elements that contain p, one by one.
inline std::vector<TriangleId> containing(const Mesh& mesh, const Point& p) {
  std::vector<TriangleId> found;
  std::vector<Point> net(index(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    const ElementSearch search = find_in_element(mesh.degree(), net, p, 1e-14 * mesh.size());
    REQUIRE(search.answer != SearchAnswer::undecided);
    if (search.answer == SearchAnswer::found) found.push_back(t);
  }
  return found;
}

inline bool is_same(const std::optional<Location>& a, const std::optional<Location>& b) {
  return a.has_value() == b.has_value() && (!a || (a->triangle == b->triangle && a->xi == b->xi));
}

inline void check_location(const Mesh& mesh, const Point& p, const std::optional<Location>& found) {
  REQUIRE(found);
  REQUIRE(mesh.is_alive(found->triangle));
  CHECK(std::ranges::min(found->xi) >= -1e-12);
  CHECK(distance(image(mesh, found->triangle, found->xi), p) <= 1e-12 * mesh.size());
}

}  // namespace pliant::samples
