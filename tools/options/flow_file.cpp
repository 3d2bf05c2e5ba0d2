// tools/options/flow_file.cpp: reads the frames of a flow, and checks what the tools check of their input.
#include "options/flow_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include "pliant/geometry/describe.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/require_mesh.h"

namespace pliant {

bool is_flow_file(const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  if (std::ranges::find(named_flows(), name, &NamedFlow::name) != named_flows().end()) return false;
  std::error_code ignored;
  const auto ends = [&text](std::string_view end) { return has_ending(text, end); };
  return text.find('/') != std::string::npos ||
         std::ranges::any_of(std::array{".json", ".jsonl", ".cbor", ".msh", ".gz", ".zst"}, ends) ||
         std::filesystem::exists(text, ignored);
}

int find_vectors(const std::vector<Field>& fields, const std::string& name, const std::string& what,
                 bool may_be_by_face) {
  const auto named = std::ranges::find(fields, name, &Field::name);
  if (named == fields.end()) {
    std::string others;
    for (const Field& other : fields) others += (others.empty() ? "; there is \"" : ", \"") + other.name + "\"";
    throw InputError("/fields", "there is no field \"" + name + "\"" + others);
  }
  const std::string place = "/fields/" + std::to_string(named - fields.begin());
  if (named->components != 2)
    throw InputError(place + "/components", what + " has 2 components, not " + std::to_string(named->components));
  if (named->by_face && !may_be_by_face)
    throw InputError(place + "/by_face", what + " must be continuous, not by face");
  return static_cast<int>(named - fields.begin());
}

VelocityField read_flow(const ToolOptions& options, const std::string& field, MeshFlow::Outside policy) {
  const auto flow = std::make_shared<MeshFlow>(options.input, policy);
  for_each_mesh(options, [&](MeshData&& data, const Frame&) {
    normalize_unit(data);
    in_unit(data.boundary.unit, [&] { require_mesh(data, false); });
    if (data.triangle_faces.empty()) throw InputError("/triangles", "a flow needs a mesh with triangles");
    if (!flow->empty() && !(data.time > flow->last_time()))
      throw InputError("/time", "the times of a flow must increase: " + describe_number(data.time) + " comes after " +
                                    describe_number(flow->last_time()));
    const int index = find_vectors(data.fields, field, "a velocity", true);
    Field velocity = std::move(data.fields[static_cast<std::size_t>(index)]);
    data.fields.clear();  // only the velocity takes memory
    data.fields.push_back(std::move(velocity));
    flow->add(Mesh(std::move(data)), 0);
  });
  return [flow](const Point& place, double time) { return flow->velocity(place, time); };
}

}  // namespace pliant
