// lib/pliant/ops/build_triangle.h: the net of a triangle from its edges and inner points.
#pragma once
#include <array>
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The degree + 1 points along an edge.
struct EdgePoints {
  std::array<PointId, max_degree + 1> ids;
  int degree = 0;

  PointId front() const { return ids[0]; }
  PointId back() const { return ids[static_cast<std::size_t>(degree)]; }
  PointId& operator[](int k) { return ids[static_cast<std::size_t>(k)]; }
  PointId operator[](int k) const { return ids[static_cast<std::size_t>(k)]; }
  EdgePoints reversed() const;
};

/// What surrounds a half-edge of a triangle that is about to be replaced: its points, its twin, its constraint.
struct Side {
  EdgePoints points;
  HalfEdgeId twin = none;
  ConstraintId constraint = none;
};
Side side_of(const Mesh& mesh, HalfEdgeId h);

/// An edge from a to b with new inner points (or `reused` ones, degree - 1 of them).
EdgePoints new_edge(Mesh& mesh, PointId a, PointId b);
EdgePoints new_edge(PointId a, PointId b, std::span<const PointId> reused, int degree);

/// Ids of the inner points of a triangle; for a new triangle they are made.
using InnerPoints = std::array<PointId, interior_size(max_degree)>;
InnerPoints inner_points(const Mesh& mesh, TriangleId t);
InnerPoints new_inner_points(Mesh& mesh);
void free_inner_points(Mesh& mesh, const InnerPoints& inner);
void free_edge_points(Mesh& mesh, const EdgePoints& edge);

/// Writes the net of t: edge k of it runs along edges[k] (edges[k].back() == edges[k + 1].front()), and makes t's
/// half-edges those of its corners. `rotation`: edges[0] becomes local edge `rotation`.
void build_triangle(Mesh& mesh, TriangleId t, const EdgePoints& e0, const EdgePoints& e1, const EdgePoints& e2,
                    const InnerPoints& inner, int rotation = 0);

/// Gives half-edge h the twin and constraint that `side` had.
void attach(Mesh& mesh, HalfEdgeId h, const Side& side);

/// True if two edges of the triangle are spans of one curve that meet where it is smooth: det J is 0 there in exact
/// arithmetic, whatever rounding makes of it (design: M3).
bool covers_smooth_corner(const Mesh& mesh, TriangleId t);

/// True if the triangle, or every one of them, is certified valid and covers no smooth corner.
bool is_valid(const Mesh& mesh, TriangleId t);
bool all_valid(const Mesh& mesh, std::span<const TriangleId> triangles);

}  // namespace pliant
