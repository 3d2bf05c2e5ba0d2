// lib/pliant/improve/edge_bend.cpp: how far is an edge from straight?
#include "pliant/improve/edge_bend.h"

#include <algorithm>

namespace pliant {

double squared_bend(const Mesh& mesh, HalfEdgeId h) {
  const int p = mesh.degree();
  const Point& a = mesh.point(mesh.origin(h));
  const Vector along = mesh.point(mesh.target(h)) - a;
  double most = 0;
  for (int k = 1; k < p; ++k) {
    const Point straight = a + (static_cast<double>(k) / p) * along;
    most = std::max(most, squared_length(mesh.point(mesh.edge_point(h, k)) - straight));
  }
  return most;
}

}  // namespace pliant
