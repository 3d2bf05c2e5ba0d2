// lib/pliant/mesh/location/nearest_boundary.h: the point of a mesh's boundary that is nearest to a place outside.
#pragma once
#include <vector>

#include "pliant/mesh/locate.h"

namespace pliant {

struct NearestPlace {
  Location location;  ///< in the element inside the nearest edge
  double distance;
};

/// The outer edges of a mesh, with their boxes. It shows the mesh as it was when it was made, and refers to it.
class NearestBoundary {
 public:
  explicit NearestBoundary(const Mesh& mesh);
  /// The nearest point on the outer edges; places that are nearer by rounding only count as equally near. The same
  /// question always has the same answer.
  ///
  /// Requires    a mesh with triangles; p finite
  /// Complexity  O(outer edges) for their boxes, and O(degree^2) for each bisection of the few edges that come near
  NearestPlace find(const Point& p) const;

 private:
  const Mesh& mesh_;
  std::vector<HalfEdgeId> edges_;
  std::vector<Box> boxes_;
};

}  // namespace pliant
