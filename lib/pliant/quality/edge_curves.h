// lib/pliant/quality/edge_curves.h: the edges of a document as Bézier curves (private to this layer).
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The control points along a half-edge, in its direction.
std::vector<PointId> edge_ids(const MeshData& data, HalfEdgeId h);
/// Writes the positions of these points into `polygon`.   Shapes  polygon: degree + 1
void edge_polygon(const MeshData& data, HalfEdgeId h, std::span<Point> polygon);

/// The arc length of edge e of an element.
double edge_length(int degree, std::span<const Point> net, int e);

/// The arc length of a Bézier curve, to a relative error of 1e-9 (next to a cusp 1e-6).
double curve_length(std::span<const Point> polygon);

}  // namespace pliant
