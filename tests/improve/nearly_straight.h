// tests/improve/nearly_straight.h: meshes of nearly straight elements that are not Delaunay.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"

namespace pliant::improve_meshes {

/// Least height of a logical triangle over its longest side; negative if it is turned over.
inline double thickness(const Mesh& mesh, TriangleId t) {
  const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
              &c = mesh.point(mesh.corner(t, 2));
  return cross(b - a, c - a) / std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
}

/// Bends inner edges by up to `bend` of their lengths (0: makes them straight), and puts the inner control points of
/// elements where those of the straight triangle are.
inline void lay_nearly_straight(Mesh& mesh, double bend, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-bend, bend);
  const int p = mesh.degree();
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (mesh.is_constrained(h) || mesh.twin(h) > h) continue;
    const Point a = mesh.point(mesh.origin(h)), along = mesh.point(mesh.target(h)) - a;
    const double side = uniform(random) < 0 ? -1 : 1;
    for (int k = 1; k < p; ++k)
      mesh.set_point(mesh.edge_point(h, k),
                     a + (double(k) / p) * along + side * std::abs(uniform(random)) * Vector{-along.y, along.x});
  }
  const NetLayout& layout = mesh.layout();
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int k = 3 * p; k < mesh.net_size(); ++k) {
      Point straight;
      for (int c = 0; c < 3; ++c)
        straight += (double(layout.exponents(k)[static_cast<std::size_t>(c)]) / p) * mesh.point(mesh.corner(t, c));
      mesh.set_point(mesh.net(t)[static_cast<std::size_t>(k)], straight);
    }
}

/// The square of `scattered`, with a notch in its side and a hole beside its interface. All curves are bent by up to
/// `bend` of their lengths. The mesh is refined; then vertices are moved and edges flipped at random, as far as
/// triangles do not become thin; at last inner edges are bent, too.
inline Mesh nearly_straight(int degree, double bend, std::uint64_t seed) {
  BoundaryComplex boundary = samples::with_faces({"west", "east"});
  boundary.vertices = {{0, 0},    {1, 0},     {1, 1},       {0, 1},      {0.35, 0},
                       {0.72, 1}, {0.7, 0.3}, {0.85, 0.45}, {0.72, 0.6}, {0.88, 0.7}};
  const int sides[11][4] = {{0, 4, 0, outside}, {4, 1, 1, outside}, {1, 9, 1, outside}, {9, 2, 1, outside},
                            {2, 5, 1, outside}, {5, 3, 0, outside}, {3, 0, 0, outside}, {4, 5, 0, 1},
                            {6, 8, 1, outside}, {8, 7, 1, outside}, {7, 6, 1, outside}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const auto& [start, end, left, right] : sides) {
    Curve curve = straight_curve(boundary, degree, 1, start, end, left, right);
    const Point a = curve.spline.points().front(), b = curve.spline.points().back();
    const double side = bend * uniform(random);
    for (int i = 1; i < degree; ++i)
      curve.spline.set_point(i,
                             curve.spline.points()[static_cast<std::size_t>(i)] + side * Vector{a.y - b.y, b.x - a.x});
    boundary.curves.push_back(std::move(curve));
  }
  Mesh mesh = mesh_of(boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = 0.01;
  refine(mesh, options);
  lay_nearly_straight(mesh, 0, random);
  constexpr double thin = 0.25;
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    if (!mesh.is_vertex(v)) continue;
    const Point old = mesh.point(v);
    mesh.set_point(v, old + 0.08 * Vector{uniform(random), uniform(random)});
    for (const HalfEdgeId h : mesh.half_edges()) {
      const bool is_at_v = mesh.origin(h) == v;
      if (is_at_v &&
          (thickness(mesh, triangle_of(h)) < thin || mesh.is_constrained(h) || mesh.is_constrained(previous(h))))
        mesh.set_point(v, old);
    }
  }
  lay_nearly_straight(mesh, 0, random);
  for (int k = 0; k < 300; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    Mesh flipped = mesh;
    if (flip_edge(flipped, h) == Outcome::done && thickness(flipped, triangle_of(h)) > thin &&
        thickness(flipped, triangle_of(flipped.twin(h))) > thin)
      mesh = std::move(flipped);
  }
  mesh.compact();
  lay_nearly_straight(mesh, bend, random);
  REQUIRE(find_invalid(mesh).empty());
  return mesh;
}

}  // namespace pliant::improve_meshes
