// lib/pliant/improve/sizing.cpp: wanted lengths from areas, expressions and fields; units.
#include "pliant/improve/sizing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "pliant/geometry/describe.h"

namespace pliant {
namespace {

constexpr double bound_by_mean_area = 1.75;  // the bound on area over the mean area after refinement to that bound
/// The error that a span may have, as a share of the accuracy wanted: in a long run those of the meshes on the way add
/// up to 1 to 2.5 of them (measured in the reversed vortex, samples/vortex/README.md).
constexpr double resolution_share = 0.25;
/// Below so many tolerances of the mesh, rounding alone is taken for an error.
constexpr double least_resolution = 10;

int find_size_field(const Mesh& mesh, const std::string& name) {
  for (std::size_t k = 0; k < mesh.fields().size(); ++k) {
    const Field& field = mesh.fields()[k];
    if (field.name != name) continue;
    if (field.components != 1)
      throw std::invalid_argument("the field '" + name + "' has " + std::to_string(field.components) +
                                  " components; wanted lengths are one");
    return static_cast<int>(k);
  }
  throw std::invalid_argument("the mesh has no field '" + name + "'");
}

}  // namespace

double QualityGoals::area_bound(FaceId f) const {
  const auto k = static_cast<std::size_t>(f);
  return std::min(max_area, k < face_area.size() ? face_area[k] : HUGE_VAL);
}

bool QualityGoals::bounds_area() const {
  const auto is_bound = [](double area) { return area < HUGE_VAL; };
  return is_bound(max_area) || std::any_of(face_area.begin(), face_area.end(), is_bound);
}

double QualityGoals::length_for_area(FaceId f) const {
  return std::sqrt(area_bound(f) / bound_by_mean_area * 4 / std::numbers::sqrt3);
}

double QualityGoals::length_at(const Point& p, double time) const {
  const double wanted = size ? size(p, time) : HUGE_VAL;
  return wanted > 0 ? wanted : HUGE_VAL;
}

double QualityGoals::length_by_field(const Mesh& mesh, TriangleId t, int corner) const {
  return size_field == none ? HUGE_VAL : length_by_field_at(mesh, mesh.corner(t, corner), mesh.face(t));
}

double QualityGoals::length_by_field_at(const Mesh& mesh, PointId v, FaceId f) const {
  if (size_field == none) return HUGE_VAL;
  const std::ptrdiff_t index = mesh.value_index(size_field, v, f);
  const double wanted = mesh.fields()[static_cast<std::size_t>(size_field)].values[static_cast<std::size_t>(index)];
  return wanted > 0 ? wanted / mesh.boundary().unit : HUGE_VAL;
}

QualityGoals goals_of(const Mesh& mesh, SizeFunction size) {
  const Criteria& criteria = mesh.criteria;
  const double unit = mesh.boundary().unit;
  const auto area_here = [unit](double area) { return area / unit / unit; };
  if (size && unit != 1)
    size = [unit, in_document = std::move(size)](const Point& p, double time) {
      return in_document(unit * p, time) / unit;
    };
  QualityGoals goals;
  if (criteria.min_angle) goals.min_angle = *criteria.min_angle;
  if (criteria.max_area) goals.max_area = area_here(*criteria.max_area);
  goals.face_area.assign(mesh.boundary().faces.size(), HUGE_VAL);
  for (const auto& [name, area] : criteria.face_area) {
    const FaceId f = find_face(mesh.boundary(), name);
    if (f != outside) goals.face_area[static_cast<std::size_t>(f)] = area_here(area);
  }
  goals.size = std::move(size);
  if (criteria.size_field) goals.size_field = find_size_field(mesh, *criteria.size_field);
  if (criteria.max_turning) goals.max_turning = *criteria.max_turning * std::numbers::pi / 180;
  goals.keeps_thin = criteria.keeps_thin.value_or(goals.keeps_thin);
  if (criteria.accuracy)
    goals.resolution = std::max(resolution_share * *criteria.accuracy / unit, least_resolution * mesh.tolerance());
  if (criteria.min_size) goals.min_size = *criteria.min_size / unit;
  return goals;
}

QualityGoals goals_of(const Mesh& mesh) {
  if (mesh.criteria.size)
    throw std::invalid_argument("the criteria have a size expression; give the goals with its function");
  return goals_of(mesh, {});
}

void require_lengths(const Mesh& mesh, const SizeFunction& size) {
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    if (!mesh.is_vertex(v)) continue;
    const Point place = mesh.boundary().unit * mesh.point(v);  // in the document
    const double wanted = size(place, mesh.time);
    if (!(wanted > 0))
      throw std::invalid_argument("the wanted length is " +
                                  (std::isnan(wanted) ? "no number" : describe_number(wanted)) + " at " +
                                  describe_point(place) + "; it should be above zero");
  }
}

}  // namespace pliant
