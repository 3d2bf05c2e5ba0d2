// lib/pliant/mesh/ids.h: indices into a mesh.
#pragma once
#include <cstdint>

namespace pliant {

using PointId = std::int32_t;       ///< a control point; a *vertex* is a control point at a corner
using TriangleId = std::int32_t;    ///< an element
using HalfEdgeId = std::int32_t;    ///< 3 * triangle + e: edge e of a triangle, from corner e to corner (e + 1) % 3
using ConstraintId = std::int32_t;  ///< a constrained edge
using FaceId = std::int32_t;        ///< a face of the boundary complex
using CurveId = std::int32_t;       ///< a curve of the boundary complex

inline constexpr std::int32_t none = -1;

constexpr TriangleId triangle_of(HalfEdgeId h) { return h / 3; }
constexpr int edge_of(HalfEdgeId h) { return h % 3; }
constexpr HalfEdgeId half_edge(TriangleId t, int e) { return 3 * t + e; }
/// The next and the previous half-edge of the same triangle, counter-clockwise.
constexpr HalfEdgeId next(HalfEdgeId h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr HalfEdgeId previous(HalfEdgeId h) { return h % 3 == 0 ? h + 2 : h - 1; }

}  // namespace pliant
