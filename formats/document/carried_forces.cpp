// formats/document/carried_forces.cpp: looks into the member `navierstokes` of a mesh document.
#include "formats/document/carried_forces.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/document/document_value.h"
#include "formats/problem/names.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

/// Null where the document has no forces.
const Json* find_forces(const ExtraMembers& extra) {
  const auto member = std::ranges::find(extra, "navierstokes", &ExtraMembers::value_type::first);
  if (member == extra.end()) return nullptr;
  const Json& flow = to_json(*member->second);
  if (!flow.is_object()) throw InputError("/navierstokes", "should be an object");
  const auto forces = flow.find("forces");
  if (forces == flow.end()) return nullptr;
  if (!forces->is_object()) throw InputError("/navierstokes/forces", "should be an object");
  return &*forces;
}

}  // namespace

std::optional<Vector> carried_force(const ExtraMembers& extra, const std::string& curve) {
  const Json* const forces = find_forces(extra);
  if (forces == nullptr) return {};
  const auto force = forces->find(curve);
  if (force == forces->end()) return {};
  if (!force->is_array() || force->size() != 2 || !(*force)[0].is_number() || !(*force)[1].is_number())
    throw InputError("/navierstokes/forces" + pointer_step(curve), "should be two numbers");
  return Vector{(*force)[0].get<double>(), (*force)[1].get<double>()};
}

std::vector<std::string> curves_with_force(const ExtraMembers& extra) {
  std::vector<std::string> names;
  if (const Json* const forces = find_forces(extra))
    for (const auto& [name, force] : forces->items()) names.push_back(name);
  return names;
}

}  // namespace pliant
