// lib/pliant/mesh/override_criteria.cpp: criteria that replace entries of a document's.
#include "pliant/mesh/override_criteria.h"

#include <algorithm>
#include <stdexcept>

namespace pliant {
namespace {

template <class Value>
void override_entry(std::optional<Value>& entry, const std::optional<Value>& given) {
  if (given) entry = given;
}

}  // namespace

void override_criteria(Criteria& criteria, const Criteria& given, const BoundaryComplex& boundary) {
  for (const auto& bound : given.face_area)
    if (find_face(boundary, bound.first) == outside)
      throw std::invalid_argument("the mesh has no face '" + bound.first + "'");
  for (const auto& bound : given.face_area) {
    const auto old = std::ranges::find(criteria.face_area, bound.first, &std::pair<std::string, double>::first);
    if (old == criteria.face_area.end())
      criteria.face_area.push_back(bound);
    else
      old->second = bound.second;
  }
  override_entry(criteria.min_angle, given.min_angle);
  override_entry(criteria.max_area, given.max_area);
  override_entry(criteria.size, given.size);
  override_entry(criteria.size_field, given.size_field);
  override_entry(criteria.max_turning, given.max_turning);
  override_entry(criteria.accuracy, given.accuracy);
  override_entry(criteria.min_size, given.min_size);
  override_entry(criteria.keeps_thin, given.keeps_thin);
}

}  // namespace pliant
