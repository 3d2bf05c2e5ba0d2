// lib/pliant/evolve/courant.cpp: how long a velocity that the mesh carries takes to cross an element.
#include "pliant/evolve/courant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"

namespace pliant {
namespace {

double least_height(const Mesh& mesh, TriangleId t) {
  const Point a = mesh.point(mesh.corner(t, 0)), b = mesh.point(mesh.corner(t, 1)), c = mesh.point(mesh.corner(t, 2));
  return 2 * std::abs(triangle_area(a, b, c)) / std::max({distance(a, b), distance(b, c), distance(c, a)});
}

}  // namespace

double crossing_time(const Mesh& mesh, int field) {
  const std::vector<double>& values = mesh.fields()[index(field)].values;
  double least = std::numeric_limits<double>::infinity();
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    double speed = 0;
    for (const PointId p : mesh.net(t))
      speed = std::max(speed, std::hypot(values[2 * index(p)], values[2 * index(p) + 1]));
    if (speed > 0) least = std::min(least, mesh.boundary().unit * least_height(mesh, t) / speed);
  }
  return least;
}

}  // namespace pliant
