#include "pliant/improve/sizing.h"

#include <cmath>
#include <numbers>

namespace pliant {

double QualityGoals::area_bound(FaceId f) const {
  const auto k = static_cast<std::size_t>(f);
  return std::min(max_area, k < face_area.size() ? face_area[k] : HUGE_VAL);
}

QualityGoals goals_of(const Mesh& mesh, SizeFunction size) {
  const Criteria& criteria = mesh.criteria;
  QualityGoals goals;
  if (criteria.min_angle) goals.min_angle = *criteria.min_angle;
  if (criteria.max_area) goals.max_area = *criteria.max_area;
  goals.face_area.assign(mesh.boundary().faces.size(), HUGE_VAL);
  for (const auto& [name, area] : criteria.face_area) {
    const FaceId f = find_face(mesh.boundary(), name);
    if (f != outside) goals.face_area[static_cast<std::size_t>(f)] = area;
  }
  goals.size = std::move(size);
  if (criteria.max_turning) goals.max_turning = *criteria.max_turning * std::numbers::pi / 180;
  if (criteria.min_size) goals.min_size = *criteria.min_size;
  return goals;
}

}  // namespace pliant
