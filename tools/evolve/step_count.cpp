// tools/evolve/step_count.cpp: the number of steps that a frame notes, where its time does not tell it.
#include "evolve/step_count.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "formats/document/mesh_document.h"

namespace pliant {
namespace {

constexpr const char* count_member = "evolve";

template <typename Members>
auto find_count(Members& members) {
  return std::ranges::find(members, count_member, [](const auto& each) { return each.first; });
}

}  // namespace

long noted_steps(const MeshData& mesh) {
  const auto member = find_count(mesh.extra);
  if (member == mesh.extra.end()) return 0;
  const std::string text = write_value(*member->second);  // {"steps":12}
  const std::size_t digits = text.find_first_of("0123456789");
  long steps = 0;
  if (digits != std::string::npos) std::from_chars(text.data() + digits, text.data() + text.size(), steps);
  return steps;
}

void note_steps(MeshData& mesh, long steps) {
  const auto value = read_value("{\"steps\":" + std::to_string(steps) + "}");
  const auto member = find_count(mesh.extra);
  if (member == mesh.extra.end())
    mesh.extra.emplace_back(count_member, value);
  else
    member->second = value;
}

}  // namespace pliant
