// lib/pliant/mesh/ids.h: indices into a mesh.
#pragma once
#include <cstddef>
#include <cstdint>

namespace pliant {

using PointId = std::int32_t;       ///< a control point; a *vertex* is a control point at a corner
using TriangleId = std::int32_t;    ///< an element
using ConstraintId = std::int32_t;  ///< a constrained edge
using FaceId = std::int32_t;        ///< a face of the boundary complex
using CurveId = std::int32_t;       ///< a curve of the boundary complex

/// Edge e of a triangle t, from corner e to corner (e + 1) % 3. A type of its own, so that nobody takes it for a
/// triangle; its number is 3 * t + e.
enum class HalfEdgeId : std::int32_t {};

/// No such point, triangle, half-edge and so on: -1, whatever it is compared with or assigned to.
struct None {
  constexpr operator std::int32_t() const { return -1; }
  constexpr operator HalfEdgeId() const { return HalfEdgeId{-1}; }
};
inline constexpr None none{};

constexpr std::int32_t as_int(HalfEdgeId h) { return static_cast<std::int32_t>(h); }
/// Where an array over all half-edges has the entry of this one.   Requires    h is not none
constexpr std::size_t index(HalfEdgeId h) { return static_cast<std::size_t>(h); }

constexpr HalfEdgeId half_edge(TriangleId t, int e) { return HalfEdgeId{3 * t + e}; }
constexpr TriangleId triangle_of(HalfEdgeId h) { return as_int(h) / 3; }
constexpr int edge_of(HalfEdgeId h) { return as_int(h) % 3; }
/// The next and the previous half-edge of the same triangle, counter-clockwise.
constexpr HalfEdgeId next(HalfEdgeId h) { return HalfEdgeId{as_int(h) + (edge_of(h) == 2 ? -2 : 1)}; }
constexpr HalfEdgeId previous(HalfEdgeId h) { return HalfEdgeId{as_int(h) + (edge_of(h) == 0 ? 2 : -1)}; }

/// The half-edges of triangles 0 to `triangles` - 1, in order, for loops.
class HalfEdgeRange {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(HalfEdgeId h) : h_(h) {}
    constexpr HalfEdgeId operator*() const { return h_; }
    constexpr Iterator& operator++() {
      h_ = HalfEdgeId{as_int(h_) + 1};
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    HalfEdgeId h_;
  };
  constexpr explicit HalfEdgeRange(TriangleId triangles) : triangles_(triangles) {}
  constexpr Iterator begin() const { return Iterator(half_edge(0, 0)); }
  constexpr Iterator end() const { return Iterator(half_edge(triangles_, 0)); }

 private:
  TriangleId triangles_;
};

}  // namespace pliant
