// tools/problem/flow_memory.cpp: reads and writes the member `navierstokes`.
#include "problem/flow_memory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/document/document_value.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr const char* member = "navierstokes";

}  // namespace

FlowMemory recall(const Mesh& mesh) {
  FlowMemory memory;
  const auto found = std::ranges::find(mesh.extra, member, &ExtraMembers::value_type::first);
  if (found == mesh.extra.end()) return memory;
  const Json& value = to_json(*found->second);
  const std::string pointer = std::string("/") + member;
  if (!value.is_object())
    throw InputError(pointer, "what the last step of a flow left must be an object with the member \"dt\"");
  if (const auto dt = value.find("dt"); dt != value.end()) {
    if (!dt->is_number() || !(dt->get<double>() > 0) || !std::isfinite(dt->get<double>()))
      throw InputError(pointer + "/dt", "the length of the last step must be a positive number");
    memory.dt = dt->get<double>();
  }
  return memory;  // forces are a result, which no step reads
}

void remember(Mesh& mesh, const FlowMemory& memory) {
  Json value = Json::object();
  if (memory.dt) value["dt"] = *memory.dt;
  Json forces = Json::object();
  for (const auto& [name, force] : memory.forces) forces[name] = Json::array({force.x, force.y});
  if (!memory.forces.empty()) value["forces"] = std::move(forces);
  const auto found = std::ranges::find(mesh.extra, member, &ExtraMembers::value_type::first);
  if (found == mesh.extra.end())
    mesh.extra.emplace_back(member, to_document(std::move(value)));
  else
    found->second = to_document(std::move(value));
}

}  // namespace pliant
