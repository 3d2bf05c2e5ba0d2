// lib/pliant/ops/refit/refit_field.cpp: refits fields in a new geometry, one group of components after the other.
#include <algorithm>

#include "pliant/ops/refit/field_fit.h"

namespace pliant {

bool Patch::fit_fields(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                       const RefitOptions& options, bool region_kept) const {
  if (width_ == 2) return true;
  thread_local FieldGroup continuous, by_face;
  continuous.components.clear();
  by_face.components.clear();
  by_face.by_face = true;
  int column = 2;
  for (std::size_t k = 0; k < mesh.fields().size(); ++k)
    for (int c = 0; c < mesh.fields()[k].components; ++c, ++column) {
      FieldGroup& group = mesh.fields()[k].by_face ? by_face : continuous;
      group.components.push_back({column, static_cast<int>(k), c});
    }
  thread_local FieldFit fit;
  if (!continuous.components.empty() && !fit.run(*this, mesh, now, free, continuous, options, region_kept))
    return false;
  if (by_face.components.empty()) return true;
  thread_local std::vector<FaceId> faces;
  faces.clear();
  for (const TriangleId t : now)
    if (std::find(faces.begin(), faces.end(), mesh.face(t)) == faces.end()) faces.push_back(mesh.face(t));
  for (const FaceId f : faces) {
    by_face.face = f;
    if (!fit.run(*this, mesh, now, free, by_face, options, region_kept)) return false;
  }
  return true;
}

}  // namespace pliant
