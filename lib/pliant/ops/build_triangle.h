// lib/pliant/ops/build_triangle.h: the parts from which operations build a triangle: edges, sides, inner points.
#pragma once
#include <array>
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The degree + 1 control points along an edge.
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

/// An edge from a to b, with new points inside or with the degree - 1 points `reused`.
EdgePoints new_edge(Mesh& mesh, PointId a, PointId b);
EdgePoints new_edge(PointId a, PointId b, std::span<const PointId> reused, int degree);

/// The points of a triangle that are on none of its edges; `new_inner_points` makes those of a new triangle.
using InnerPoints = std::array<PointId, interior_size(max_degree)>;
InnerPoints inner_points(const Mesh& mesh, TriangleId t);
InnerPoints new_inner_points(Mesh& mesh);
void free_inner_points(Mesh& mesh, const InnerPoints& inner);
void free_edge_points(Mesh& mesh, const EdgePoints& edge);

/// Writes the net of t, whose border is e0, e1, e2; e0 becomes local edge `rotation`. The half-edges of t become the
/// vertex half-edges of its corners.
///
/// Requires    each edge ends where the next one starts: e0.back() == e1.front(), and so on around
void build_triangle(Mesh& mesh, TriangleId t, const EdgePoints& e0, const EdgePoints& e1, const EdgePoints& e2,
                    const InnerPoints& inner, int rotation = 0);

/// Gives half-edge h the twin and constraint that `side` had.
void attach(Mesh& mesh, HalfEdgeId h, const Side& side);

/// True if two edges of the triangle are spans of one curve that meet where it is smooth. There det J is 0 in exact
/// arithmetic, so the triangle breaks M3 even if rounding makes it positive.
bool covers_smooth_corner(const Mesh& mesh, TriangleId t);

/// True if the triangle (each of the triangles) is certified valid and covers no smooth corner.
bool is_valid(const Mesh& mesh, TriangleId t);
bool all_valid(const Mesh& mesh, std::span<const TriangleId> triangles);

}  // namespace pliant
