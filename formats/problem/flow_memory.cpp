// formats/problem/flow_memory.cpp: reads and writes the member `navierstokes`.
#include "formats/problem/flow_memory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/document/document_value.h"
#include "formats/problem/names.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr const char* memory_member = "navierstokes";

}  // namespace

FlowMemory recall_flow(const ExtraMembers& extra) {
  FlowMemory memory;
  const auto found = std::ranges::find(extra, memory_member, &ExtraMembers::value_type::first);
  if (found == extra.end()) return memory;
  const Json& value = to_json(*found->second);
  const std::string pointer = pointer_step(memory_member);
  if (!value.is_object()) throw InputError(pointer, "what the last step of a flow left must be an object");
  if (const auto dt = value.find("dt"); dt != value.end()) {
    if (!dt->is_number() || !(dt->get<double>() > 0) || !std::isfinite(dt->get<double>()))
      throw InputError(pointer + "/dt", "the length of the last step must be a positive number");
    memory.dt = dt->get<double>();
  }
  const auto forces = value.find("forces");
  if (forces == value.end()) return memory;
  if (!forces->is_object()) throw InputError(pointer + "/forces", "forces must be an object: by curve two numbers");
  for (const auto& [curve, force] : forces->items()) {
    if (!force.is_array() || force.size() != 2 || !force[0].is_number() || !force[1].is_number())
      throw InputError(pointer + "/forces" + pointer_step(curve), "a force must be two numbers");
    memory.forces[curve] = {force[0].get<double>(), force[1].get<double>()};
  }
  return memory;
}

void remember_flow(ExtraMembers& extra, const FlowMemory& memory) {
  Json value = Json::object();
  if (memory.dt) value["dt"] = *memory.dt;
  Json forces = Json::object();
  for (const auto& [name, force] : memory.forces) forces[name] = Json::array({force.x, force.y});
  if (!memory.forces.empty()) value["forces"] = std::move(forces);
  const auto found = std::ranges::find(extra, memory_member, &ExtraMembers::value_type::first);
  if (found == extra.end())
    extra.emplace_back(memory_member, to_document(std::move(value)));
  else
    found->second = to_document(std::move(value));
}

}  // namespace pliant
