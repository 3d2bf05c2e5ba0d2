// lib/pliant/fem/configuration.h: where the control points of a mesh are at some time.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// Where the mesh is at some time: its control points, indexed by PointId, in the units of the mesh.
struct Configuration {
  std::span<const Point> points;
  double time = 0;
};

}  // namespace pliant
