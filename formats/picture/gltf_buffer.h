// formats/picture/gltf_buffer.h: the binary part of a glTF file: vertices, indices, colours and animation keys.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats/picture/coloring.h"
#include "formats/picture/gltf_surface.h"

namespace tinygltf {
class Model;
}

namespace pliant {

/// Collects arrays in any order. Each becomes an accessor, whose index is returned; arrays of one kind share a buffer
/// view, and equal indices an accessor.
class GltfBuffer {
 public:
  /// With `quantize` positions are stored in 16 bits, as parts of a box; otherwise in single precision.
  explicit GltfBuffer(bool quantize);

  /// Heights are stored as parts of the box in either precision; without heights z is 0.
  int add_positions(std::span<const Point> points, std::span<const double> heights, const GltfBox& box);
  int add_normals(const std::vector<std::array<float, 3>>& normals);
  /// Adds indices of `vertices` many vertices, in 16 bits where these suffice.
  int add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices);
  /// The triangles of a band of this many points. All bands use the beginning of one array of indices.
  int add_band_indices(std::size_t points);
  /// Reserves a place for `count` colours, which `append_color` adds later, in the order of the reservations.
  int reserve_colors(std::size_t count);
  /// Adds the next colour, in linear light.
  void append_color(const Rgb& linear);
  int add_keys(const std::vector<float>& keys);      ///< times, ascending
  int add_scales(const std::vector<float>& scales);  ///< each for all three axes

  /// Gives the model its buffer, the views that are used, and the accessors. To be called once.
  void move_to(tinygltf::Model& model);

 private:
  enum View : std::size_t {
    positions_view,
    normals_view,
    indices_view,
    band_view,       // 16 bits
    wide_band_view,  // 32 bits
    colors_view,
    animation_view,
    view_count
  };
  struct Accessor {
    View view;
    std::size_t offset, count;
    int component, type;
    bool normalized = false;
    std::vector<double> low{}, high{};
  };
  int add_accessor(Accessor accessor);

  bool quantize_;
  std::array<std::vector<unsigned char>, view_count> bytes_;
  std::vector<Accessor> accessors_;
  std::unordered_multimap<std::size_t, int> known_indices_;  // by hash, to find those that are equal
  std::size_t colors_ = 0;
};

}  // namespace pliant
