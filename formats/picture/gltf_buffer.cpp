// formats/picture/gltf_buffer.cpp: the binary part of a glTF file: vertices, indices, colours and animation keys.
#include "formats/picture/gltf_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace pliant {
namespace {

using Bytes = std::vector<unsigned char>;

template <class T>
void append(Bytes& bytes, const T& value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// The greatest number of an index type means "restart", and must not be used as an index.
bool fits_short(std::size_t vertices) { return vertices <= std::numeric_limits<std::uint16_t>::max(); }

void append_indices(Bytes& bytes, const std::vector<std::uint32_t>& indices, bool is_short) {
  for (const std::uint32_t i : indices)
    if (is_short)
      append(bytes, static_cast<std::uint16_t>(i));
    else
      append(bytes, i);
}

}  // namespace

GltfBuffer::GltfBuffer(bool quantize) : quantize_(quantize) {}

int GltfBuffer::add_accessor(Accessor accessor) {
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add_positions(std::span<const Point> points, std::span<const double> heights, const GltfBox& box) {
  Bytes& out = bytes_[positions_view];
  const std::size_t offset = out.size();
  std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  const auto put = [&](std::size_t axis, auto number) {
    append(out, number);
    low[axis] = std::min(low[axis], double(number));
    high[axis] = std::max(high[axis], double(number));
  };
  const auto step = [](double value, double from, double to) {
    return static_cast<std::uint16_t>(to > from ? std::lround((value - from) / (to - from) * 65535) : 0);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const double z = heights.empty() ? 0 : box.place(heights[i]);
    if (quantize_) {
      put(0, step(p.x, box.plane.low.x, box.plane.high.x));
      put(1, step(p.y, box.plane.low.y, box.plane.high.y));
      put(2, step(z, 0, 1));
      append(out, std::uint16_t{0});  // aligns the next vertex
    } else {
      put(0, static_cast<float>(p.x));
      put(1, static_cast<float>(p.y));
      put(2, static_cast<float>(z));
    }
  }
  const int component = quantize_ ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_FLOAT;
  return add_accessor({positions_view,
                       offset,
                       points.size(),
                       component,
                       TINYGLTF_TYPE_VEC3,
                       quantize_,
                       {low.begin(), low.end()},
                       {high.begin(), high.end()}});
}

int GltfBuffer::add_normals(const std::vector<std::array<float, 3>>& normals) {
  Bytes& out = bytes_[normals_view];
  const std::size_t offset = out.size();
  for (const std::array<float, 3>& normal : normals) {
    for (const float part : normal)
      if (quantize_)
        append(out, static_cast<std::int16_t>(std::lround(part * 32767)));
      else
        append(out, part);
    if (quantize_) append(out, std::int16_t{0});
  }
  const int component = quantize_ ? TINYGLTF_COMPONENT_TYPE_SHORT : TINYGLTF_COMPONENT_TYPE_FLOAT;
  return add_accessor({normals_view, offset, normals.size(), component, TINYGLTF_TYPE_VEC3, quantize_});
}

int GltfBuffer::add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  Bytes& out = bytes_[indices_view];
  const std::size_t offset = out.size();
  const bool is_short = fits_short(vertices);
  append_indices(out, indices, is_short);
  const std::size_t size = out.size() - offset;
  const std::size_t hash =
      std::hash<std::string_view>()({reinterpret_cast<const char*>(out.data()) + offset, size}) ^ (is_short ? 0 : 1);
  const int component = is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  const auto [first, last] = known_indices_.equal_range(hash);
  for (auto known = first; known != last; ++known) {
    const Accessor& other = accessors_[static_cast<std::size_t>(known->second)];
    if (other.count != indices.size() || other.component != component) continue;
    if (std::memcmp(out.data() + other.offset, out.data() + offset, size) != 0) continue;
    out.resize(offset);
    return known->second;
  }
  out.resize((out.size() + 3) / 4 * 4);
  const int added = add_accessor({indices_view, offset, indices.size(), component, TINYGLTF_TYPE_SCALAR});
  known_indices_.emplace(hash, added);
  return added;
}

int GltfBuffer::add_band_indices(std::size_t points) {
  const std::size_t count = points < 4 ? 0 : 3 * (points - 2);
  const bool is_short = fits_short(points);
  const View view = is_short ? band_view : wide_band_view;
  for (std::size_t a = 0; a < accessors_.size(); ++a)
    if (accessors_[a].view == view && accessors_[a].count == count) return static_cast<int>(a);
  Bytes& out = bytes_[view];
  for (auto at = static_cast<std::uint32_t>(out.size() / (is_short ? 2 : 4) / 3); at + 3 < points; at += 2)
    append_indices(out, {at, at + 2, at + 1, at + 1, at + 2, at + 3}, is_short);
  const int component = is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  return add_accessor({view, 0, count, component, TINYGLTF_TYPE_SCALAR});
}

int GltfBuffer::reserve_colors(std::size_t count) {
  const std::size_t offset = 4 * colors_;
  colors_ += count;
  return add_accessor({colors_view, offset, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4, true});
}

void GltfBuffer::append_color(const Rgb& linear) {
  for (const double part : linear)
    append(bytes_[colors_view], static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255)));
  append(bytes_[colors_view], std::uint8_t{255});
}

int GltfBuffer::add_keys(const std::vector<float>& keys) {
  Bytes& out = bytes_[animation_view];
  const std::size_t offset = out.size();
  for (const float key : keys) append(out, key);
  return add_accessor({animation_view,
                       offset,
                       keys.size(),
                       TINYGLTF_COMPONENT_TYPE_FLOAT,
                       TINYGLTF_TYPE_SCALAR,
                       false,
                       {double(keys.front())},
                       {double(keys.back())}});
}

int GltfBuffer::add_scales(const std::vector<float>& scales) {
  Bytes& out = bytes_[animation_view];
  const std::size_t offset = out.size();
  for (const float scale : scales)
    for (int axis = 0; axis < 3; ++axis) append(out, scale);
  return add_accessor({animation_view, offset, scales.size(), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3});
}

void GltfBuffer::move_to(tinygltf::Model& model) {
  struct Kind {
    const char* name;
    int target;
    std::size_t stride;
  };
  const std::array<Kind, view_count> kinds{
      {{"positions", TINYGLTF_TARGET_ARRAY_BUFFER, quantize_ ? std::size_t{8} : std::size_t{12}},
       {"normals", TINYGLTF_TARGET_ARRAY_BUFFER, quantize_ ? std::size_t{8} : std::size_t{12}},
       {"indices", TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0},
       {"band indices", TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0},
       {"wide band indices", TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0},
       {"colors", TINYGLTF_TARGET_ARRAY_BUFFER, 4},
       {"animation", 0, 0}}};
  tinygltf::Buffer buffer;
  std::array<int, view_count> number{};
  for (std::size_t v = 0; v < view_count; ++v) {
    if (bytes_[v].empty()) continue;
    bytes_[v].resize((bytes_[v].size() + 3) / 4 * 4);
    number[v] = static_cast<int>(model.bufferViews.size());
    tinygltf::BufferView view;
    view.name = kinds[v].name;
    view.buffer = 0;
    view.byteOffset = buffer.data.size();
    view.byteLength = bytes_[v].size();
    view.byteStride = kinds[v].stride;
    view.target = kinds[v].target;
    buffer.data.insert(buffer.data.end(), bytes_[v].begin(), bytes_[v].end());
    model.bufferViews.push_back(std::move(view));
    Bytes().swap(bytes_[v]);
  }
  for (const Accessor& each : accessors_) {
    tinygltf::Accessor accessor;
    accessor.bufferView = number[each.view];
    accessor.byteOffset = each.offset;
    accessor.count = each.count;
    accessor.componentType = each.component;
    accessor.type = each.type;
    accessor.normalized = each.normalized;
    accessor.minValues = each.low;
    accessor.maxValues = each.high;
    model.accessors.push_back(std::move(accessor));
  }
  model.buffers.push_back(std::move(buffer));
}

}  // namespace pliant
