// lib/pliant/quality/edge_curves.h: the edges of a document as Bézier curves (private to this layer).
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The control points of a half-edge in its direction: ids, and places.
std::vector<PointId> edge_ids(const MeshData& data, HalfEdgeId h);
/// Into `polygon`, of degree + 1 points.
void edge_polygon(const MeshData& data, HalfEdgeId h, std::span<Point> polygon);

/// Arc length of edge e of an element.
double edge_length(int degree, std::span<const Point> net, int e);

/// Arc length of a Bézier curve, to 1e-9 relative (next to a cusp 1e-6).
double curve_length(std::span<const Point> polygon);

}  // namespace pliant
