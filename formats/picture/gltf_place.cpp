// formats/picture/gltf_place.cpp: where the scene of a glTF file is, so that single precision is enough for its
// vertices.
#include "formats/picture/gltf_place.h"

#include <algorithm>
#include <cmath>

#include "pliant/boundary/fault.h"
#include "pliant/quality/metrics.h"

namespace pliant {

GltfPlace::GltfPlace(const Box& box) {
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  if (!std::isfinite(extent))
    throw InputError("/points", "the mesh is larger than the largest double, and cannot be drawn to scale");
  constexpr double comfortable = 1e6;  // viewers are made for sizes up to this and down to its inverse
  if (extent > comfortable || (extent > 0 && extent < 1 / comfortable)) scale = std::exp2(std::ilogb(extent));
  const Point low = box.low / scale, high = box.high / scale;
  size = distance(low, high);
  center = low + (high - low) / 2;
}

Point GltfPlace::origin_of(const Box& box) const {
  constexpr double least = 1e-30;
  if (size > 0 && box.size() < least * size)
    throw InputError("/points",
                     "the mesh is smaller than 1e-30 of the first one's size, beyond the single precision of "
                     "glTF");
  const Point own = box.low + (box.high - box.low) / 2;
  return distance(own, center) > 4 * std::min(size, box.size()) ? own : center;
}

bool has_unit(const ColorBy& color) {
  const Metric* metric = color.kind == ColorBy::Kind::metric ? find_metric(color.name) : nullptr;
  return metric != nullptr && unit_factor(metric->unit, 2) != 1;
}

MeshData moved(const MeshData& mesh, const Point& origin) {
  MeshData local;
  local.degree = mesh.degree;
  local.triangles = mesh.triangles;
  local.triangle_faces = mesh.triangle_faces;
  local.constrained_edges = mesh.constrained_edges;
  local.points.reserve(mesh.points.size());
  for (const Point& p : mesh.points) local.points.push_back(p - origin);
  return local;
}

void require_drawable(const Box& box) {
  constexpr double most = 1e30;  // products of longer lengths overflow in viewers
  for (const Point& corner : {box.low, box.high})
    if (!(std::abs(corner.x) <= most && std::abs(corner.y) <= most))
      throw InputError("/points",
                       "what is drawn reaches farther than 1e30 times the first mesh's size, beyond the "
                       "single precision of glTF");
}

}  // namespace pliant
