// tests/formats/gltf_reading.h: glTF files read back by tinygltf, and what they draw.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <set>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "formats/picture/gltf.h"
#include "formats/picture/mesh_edges.h"
#include "formats/picture/tessellation.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_meshes.h"

namespace pliant {

inline tinygltf::Model read_back(const std::string& file, bool binary) {
  tinygltf::Model model;
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  const auto size = static_cast<unsigned>(file.size());
  const bool good = binary ? reader.LoadBinaryFromMemory(&model, &error, &warning,
                                                         reinterpret_cast<const unsigned char*>(file.data()), size)
                           : reader.LoadASCIIFromString(&model, &error, &warning, file.data(), size, "");
  CHECK(error == "");
  CHECK(warning == "");
  REQUIRE(good);
  return model;
}

inline MeshData colorful(MeshData mesh) {
  samples::add_field(mesh, "wave", 1, [](const Point& p) { return std::vector<double>{std::sin(3 * p.x) * p.y}; });
  return mesh;
}

inline tinygltf::Model model_of(const std::vector<MeshData>& series, GltfOptions options, bool binary = true) {
  GltfWriter writer(std::move(options));
  for (const MeshData& mesh : series) writer.add(mesh);
  return read_back(writer.finish(binary), binary);
}

inline GltfOptions colored_by(const std::string& color) {
  GltfOptions options;
  options.color = parse_color_by(color);
  options.quantize = false;  // numbers as they are
  return options;
}

/// The numbers of an accessor, as stored.
inline std::vector<double> numbers(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
  std::vector<double> result;
  for (std::size_t i = 0; i < accessor.count; ++i)
    for (int c = 0; c < components; ++c) {
      const std::size_t at = view.byteOffset + accessor.byteOffset + i * stride + static_cast<std::size_t>(c * size);
      REQUIRE(at + static_cast<std::size_t>(size) <= view.byteOffset + view.byteLength);
      const unsigned char* bytes = model.buffers.front().data.data() + at;
      const auto read = [bytes](auto value) {
        std::memcpy(&value, bytes, sizeof value);
        return double(value);
      };
      switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
          result.push_back(read(0.0F));
          break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
          result.push_back(read(std::uint8_t{}));
          break;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
          result.push_back(read(std::int16_t{}));
          break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
          result.push_back(read(std::uint16_t{}));
          break;
        default:
          result.push_back(read(std::uint32_t{}));
      }
    }
  return result;
}

inline const tinygltf::Primitive* find_primitive(const tinygltf::Model& model, const std::string& mesh) {
  for (const tinygltf::Mesh& each : model.meshes)
    if (each.name == mesh) return each.primitives.data();
  return nullptr;
}

inline double curved_area(const MeshData& mesh) {
  double sum = 0;
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
    sum += element_area(mesh.degree, element_net(mesh, t));
  return sum;
}

inline double drawn_area(const tinygltf::Model& model) {
  const tinygltf::Primitive* fill = find_primitive(model, "elements");
  REQUIRE(fill != nullptr);
  const std::vector<double> at = numbers(model, fill->attributes.at("POSITION"));
  const std::vector<double> index = numbers(model, fill->indices);
  double sum = 0;
  for (std::size_t i = 0; i < index.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      const auto v = static_cast<std::size_t>(index[i + k]);
      return Point{at[3 * v], at[3 * v + 1]};
    };
    sum += cross(corner(1) - corner(0), corner(2) - corner(0)) / 2;
  }
  return sum;
}

}  // namespace pliant
