// formats/picture/gltf_extras.cpp: members of a glTF file that only programs which know Pliant look at.
#include "formats/picture/gltf_extras.h"

#include <nlohmann/json.hpp>
#include <utility>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace pliant {

using tinygltf::Value;

tinygltf::Value extras_of(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      Value::Object members;
      for (const auto& [name, member] : json.get_ref<const Json::object_t&>()) members[name] = extras_of(member);
      return Value(std::move(members));
    }
    case Json::value_t::array: {
      Value::Array elements;
      for (const Json& element : json) elements.push_back(extras_of(element));
      return Value(std::move(elements));
    }
    case Json::value_t::string:
      return Value(json.get<std::string>());
    case Json::value_t::boolean:
      return Value(json.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      // Its integers have 32 bits.
      if (json == json.get<int>()) return Value(json.get<int>());
      return Value(json.get<double>());
    case Json::value_t::number_float:
      return Value(json.get<double>());
    default:
      return {};
  }
}

const Json* history_of(const MeshData& mesh) {
  for (const auto& [name, value] : mesh.extra)
    if (name == "history") return &to_json(*value);
  return nullptr;
}

}  // namespace pliant
