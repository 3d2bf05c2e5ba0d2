// lib/pliant/mesh/documents/reread.cpp: compacts a mesh and chooses its unit of length anew, if all its numbers are
// finite.
#include "pliant/mesh/documents/reread.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pliant/mesh/documents/document_unit.h"

namespace pliant {
namespace {

void require_finite(const Mesh& mesh) {
  bool finite = std::isfinite(mesh.time);
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    finite = finite && (!mesh.is_point_alive(p) || is_finite(mesh.point(p)));
  for (const Field& field : mesh.fields())
    finite = finite && std::ranges::all_of(field.values, [](double value) { return std::isfinite(value); });
  for (const Curve& curve : mesh.boundary().curves) {
    finite = finite && std::isfinite(curve.removal_error);
    for (const Point& p : curve.spline.points()) finite = finite && is_finite(p);
  }
  for (const Point& p : mesh.boundary().vertices) finite = finite && is_finite(p);
  if (!finite) throw std::domain_error("a number of the result is not finite");
}

}  // namespace

void reread(Mesh& mesh) {
  mesh.compact();
  require_finite(mesh);
  if (mesh.boundary().unit == 1 && has_tame_size(mesh)) return;
  MeshData data = mesh.to_data();
  restore_unit(data);
  normalize_unit(data);
  mesh = Mesh(std::move(data));
}

}  // namespace pliant
