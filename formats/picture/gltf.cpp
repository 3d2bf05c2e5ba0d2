// formats/picture/gltf.cpp: a mesh, or a series as an animation, as glTF 2.0 (formats/gltf.md).
#include "formats/picture/gltf.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "formats/document/document_value.h"
#include "formats/picture/gltf_animation.h"
#include "formats/picture/gltf_buffer.h"
#include "formats/picture/gltf_extras.h"
#include "formats/picture/gltf_height.h"
#include "formats/picture/gltf_place.h"
#include "formats/picture/gltf_surface.h"
#include "formats/picture/mesh_edges.h"
#include "formats/picture/tessellation.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

using tinygltf::Value;

constexpr double vertex_color_tolerance = 0.01;  // how far a field's colour may be off, as a part of the frame's range
constexpr double color_spread = 0.15;  // how much a piece's corners may differ, likewise: viewers mix their colours
constexpr double layer = 5e-4;         // from obstacles to the fill, lines, and outlines, as a part of the mesh's size
constexpr double height_tolerance = 0.005;  // how far heights may be off, as a part of the frame's range
constexpr double least_height = 1e-15;      // of a lifted box, as a part of the mesh's size: viewers square its inverse
constexpr Rgb ink{0.078, 0.137, 0.18}, plain{0.86, 0.89, 0.92};

tinygltf::Primitive primitive(int positions, int indices, int material, int mode) {
  tinygltf::Primitive result;
  result.attributes["POSITION"] = positions;
  result.indices = indices;
  result.material = material;
  result.mode = mode;
  return result;
}

}  // namespace

struct GltfWriter::State {
  /// A box of positions, with the node that places it and, for each part in it, the node and its layer.
  struct PlacedBox {
    int node;
    GltfBox box;
    std::vector<std::pair<int, int>> parts;
    int layer_number;  // of all of it
  };

  explicit State(GltfOptions given) : options(std::move(given)), buffer(options.quantize) {}

  int add_colors(const Tessellation& pieces);
  int material(int& slot, const char* name, const Rgb& color, double opacity, bool lit = false);
  int add_node(const char* name, const tinygltf::Primitive& primitive);
  TessellationOptions cut_options(const ValueRange& own_range, const ElementValues* heights,
                                  const std::vector<TriangleId>& without) const;
  /// Gives a frame's node its children: elements, invalid ones, edges, and curves as a band of triangles.
  void add_parts(const Tessellation& pieces, const GltfBand& band, const GltfBox& box, tinygltf::Node& frame);
  void place_boxes();
  tinygltf::Value asset_extras() const;
  void add_circles();
  void color_vertices();

  GltfOptions options;
  GltfBuffer buffer;
  tinygltf::Model model;
  std::vector<double> values;  // the values of all coloured vertices of all frames; their faces if these colour
  ValueRange range;
  std::string title, height_title;
  std::vector<int> frames;  // the node of each frame
  std::vector<int> circle_nodes;
  std::vector<PlacedBox> boxes;
  GltfHeights heights;
  Json history;  // of the first mesh
  GltfPlace place;
  double size = 0;  // size of the first mesh, in the place's unit
  int fill = -1, lines = -1, outline = -1, invalid = -1, obstacle = -1;
};

/// Keeps the values. Their colours are known only when the range of all frames is.
int GltfWriter::State::add_colors(const Tessellation& pieces) {
  values.insert(values.end(), pieces.values.begin(), pieces.values.end());
  if (options.color.kind == ColorBy::Kind::face)
    for (const FaceId face : pieces.vertex_faces) values.push_back(face);
  return buffer.reserve_colors(pieces.vertices.size());
}

int GltfWriter::State::material(int& slot, const char* name, const Rgb& color, double opacity, bool lit) {
  if (slot >= 0) return slot;
  tinygltf::Material material;
  material.name = name;
  const Rgb linear = linear_light(color);
  material.pbrMetallicRoughness.baseColorFactor = {linear[0], linear[1], linear[2], opacity};
  material.doubleSided = true;
  if (opacity < 1) material.alphaMode = "BLEND";
  if (lit) {
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.8;
  } else {
    material.extensions["KHR_materials_unlit"] = Value(Value::Object{});
  }
  model.materials.push_back(std::move(material));
  return slot = static_cast<int>(model.materials.size()) - 1;
}

int GltfWriter::State::add_node(const char* name, const tinygltf::Primitive& primitive) {
  tinygltf::Mesh mesh;
  mesh.name = name;
  mesh.primitives = {primitive};
  model.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model.meshes.size()) - 1;
  model.nodes.push_back(std::move(node));
  return static_cast<int>(model.nodes.size()) - 1;
}

void GltfWriter::State::add_circles() {
  for (const Circle& circle : options.circles) {
    const std::vector<Point> corners =
        corners_of({circle.center / place.scale - place.center, circle.radius / place.scale});
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t k = 2; k < corners.size(); ++k) triangles.insert(triangles.end(), {0, k - 1, k});
    GltfBox box;
    box.extend(corners, {});
    require_drawable(box.plane);
    const int at = buffer.add_positions(corners, {}, box);
    const auto disk = primitive(at, buffer.add_indices(triangles, corners.size()),
                                material(obstacle, "obstacle", obstacle_color, 1), TINYGLTF_MODE_TRIANGLES);
    circle_nodes.push_back(add_node("obstacle", disk));
    boxes.push_back({circle_nodes.back(), box, {}, -1});
  }
}

void GltfWriter::State::color_vertices() {
  const ValueRange shown = options.range.value_or(range);
  for (const double value : values) {
    Rgb color = missing_color;
    if (options.color.kind == ColorBy::Kind::face)
      color = face_color(static_cast<FaceId>(value));
    else if (std::isfinite(value))
      color = options.map->at(shown.place(value));
    buffer.append_color(linear_light(color));
  }
}

GltfWriter::GltfWriter(GltfOptions options) : state_(std::make_unique<State>(std::move(options))) {}
GltfWriter::~GltfWriter() = default;

void GltfWriter::State::add_parts(const Tessellation& pieces, const GltfBand& band, const GltfBox& box,
                                  tinygltf::Node& frame) {
  const int at = buffer.add_positions(pieces.vertices, pieces.heights, box);
  const std::size_t count = pieces.vertices.size();
  const bool colored = options.color.kind != ColorBy::Kind::nothing;
  const int colors = colored ? add_colors(pieces) : -1;
  const Vector unit = options.quantize ? positive_extent(box.plane) : Vector{1, 1};
  const int normals = options.lit ? buffer.add_normals(vertex_normals(pieces, box, unit)) : -1;
  PlacedBox placed{-1, box, {}, 0};
  const auto part = [&](const char* name, const tinygltf::Primitive& p, int layer_number) {
    placed.parts.emplace_back(add_node(name, p), layer_number);
  };
  const auto filled = [&](const std::vector<std::uint32_t>& triangles, int material) {
    auto result = primitive(at, buffer.add_indices(triangles, count), material, TINYGLTF_MODE_TRIANGLES);
    if (normals >= 0) result.attributes["NORMAL"] = normals;
    return result;
  };
  if (!pieces.triangles.empty()) {
    auto elements =
        filled(pieces.triangles, material(fill, "elements", colored ? Rgb{1, 1, 1} : plain, 1, options.lit));
    if (colored) elements.attributes["COLOR_0"] = colors;
    part("elements", elements, 0);
  }
  if (!pieces.marked.empty())
    part("invalid", filled(pieces.marked, material(invalid, "invalid", invalid_color, 1, options.lit)), 1);
  if (options.edges && !pieces.inner_lines.empty())
    part("edges",
         primitive(at, buffer.add_indices(pieces.inner_lines, count), material(lines, "edges", ink, 0.55),
                   TINYGLTF_MODE_LINE),
         2);
  if (!band.points.empty())
    part("curves",
         primitive(buffer.add_positions(band.points, band.heights, box), buffer.add_band_indices(band.points.size()),
                   material(outline, "curves", ink, 1), TINYGLTF_MODE_TRIANGLES),
         3);
  if (options.quantize || options.height) {
    tinygltf::Node node;
    node.name = "box";
    for (const auto& [child, layer_number] : placed.parts) node.children.push_back(child);
    model.nodes.push_back(std::move(node));
    placed.node = static_cast<int>(model.nodes.size()) - 1;
    frame.children = {placed.node};
  } else {
    for (const auto& [child, layer_number] : placed.parts) frame.children.push_back(child);
  }
  boxes.push_back(std::move(placed));
}

/// Gives the nodes their translations and scales, as soon as the heights of all frames are known.
void GltfWriter::State::place_boxes() {
  for (const PlacedBox& placed : boxes) {
    const ValueRange& values_here = placed.box.heights;
    const double low = values_here.is_empty() ? 0 : heights.height_of(values_here.low);
    const double tall = values_here.is_empty() ? 0 : heights.height_of(values_here.high) - low;
    const bool is_flat = placed.node < 0 || values_here.is_empty();
    const double scale = is_flat ? 1 : std::abs(tall) > least_height * size ? tall : least_height * size;
    if (placed.node >= 0) {
      tinygltf::Node& node = model.nodes[static_cast<std::size_t>(placed.node)];
      const Vector extent = options.quantize ? positive_extent(placed.box.plane) : Vector{1, 1};
      const Point corner = options.quantize ? placed.box.plane.low : Point{0, 0};
      if (const double z = low + placed.layer_number * layer * size; corner.x != 0 || corner.y != 0 || z != 0)
        node.translation = {corner.x, corner.y, z};
      if (extent.x != 1 || extent.y != 1 || scale != 1) node.scale = {extent.x, extent.y, scale};
    }
    for (const auto& [part, number] : placed.parts)
      if (number > 0) model.nodes[static_cast<std::size_t>(part)].translation = {0, 0, number * layer * size / scale};
  }
}

TessellationOptions GltfWriter::State::cut_options(const ValueRange& own_range, const ElementValues* lifted,
                                                   const std::vector<TriangleId>& without) const {
  TessellationOptions cut;
  cut.subdivide = options.subdivide;
  cut.tolerance = options.tolerance * size;
  const ValueRange& shown = options.range ? *options.range : own_range;
  cut.color_tolerance = vertex_color_tolerance * (shown.high - shown.low);
  cut.color_spread = color_spread * (shown.high - shown.low);
  if (lifted != nullptr) {
    cut.heights = lifted;
    const ValueRange lifts = lifted->range(without);
    cut.height_tolerance = height_tolerance * (lifts.high - lifts.low);
  }
  return cut;
}

void GltfWriter::add(const MeshData& mesh) {
  State& s = *state_;
  const GltfOptions& options = s.options;
  if (s.frames.empty()) {
    s.place = GltfPlace(bounding_box(mesh));
    s.size = s.place.size;
    s.heights = GltfHeights(options.height_scale, s.place);
    if (const Json* history = history_of(mesh)) s.history = *history;
    s.add_circles();
  }
  MeshData scaled;
  if (s.place.scale != 1) {
    scaled = mesh;
    for (Point& p : scaled.points) p = p / s.place.scale;
  }
  const MeshData& drawn = s.place.scale != 1 ? scaled : mesh;
  // Lengths and areas that colour are those of the mesh itself; other numbers are the same in any unit.
  const ElementValues values(has_unit(options.color) ? mesh : drawn, options.color);
  const InvalidElements bad = find_invalid(drawn);
  const ValueRange range = values.range(bad.invalid);
  s.range.extend(range.low);
  s.range.extend(range.high);
  s.title = values.title();
  const Point origin = s.place.origin_of(bounding_box(drawn));
  const MeshData local = moved(drawn, origin);
  const MeshEdges edges = find_edges(local);
  std::optional<ElementValues> heights;
  if (options.height) s.height_title = heights.emplace(drawn, *options.height).title();
  const ElementValues* lifted = heights ? &*heights : nullptr;
  const Tessellation pieces =
      tessellate(local, edges, values, options.color.kind, bad.invalid, s.cut_options(range, lifted, bad.invalid));
  const double width = options.outline_width ? *options.outline_width / s.place.scale : s.size / 400;
  const GltfBand band =
      outline_band(local, edges, lifted, pieces.cuts, {width / 2, options.tolerance * s.size, options.subdivide});
  GltfBox box;
  box.extend(pieces.vertices, pieces.heights);
  box.extend(band.points, band.heights);
  require_drawable(box.plane);
  s.heights.add(box.heights);

  tinygltf::Node frame;
  s.add_parts(pieces, band, box, frame);
  frame.name = "frame " + std::to_string(s.frames.size());
  if (const Vector shift = origin - s.place.center; shift.x != 0 || shift.y != 0)
    frame.translation = {shift.x, shift.y, 0};
  // A viewer that plays no animation shows the first frame.
  if (!s.frames.empty()) frame.scale = {0, 0, 0};
  Json extras{{"time", mesh.time},
              {"elements", mesh.triangle_faces.size()},
              {"invalid", bad.invalid.size()},
              {"degenerate", bad.degenerate.size()}};
  if (const Json* history = history_of(mesh); history != nullptr && *history != s.history) extras["history"] = *history;
  frame.extras = extras_of(extras);
  s.model.nodes.push_back(std::move(frame));
  s.frames.push_back(static_cast<int>(s.model.nodes.size()) - 1);
}

Value GltfWriter::State::asset_extras() const {
  Json extras = Json::object();
  const ValueRange shown = options.range.value_or(range);
  if (!title.empty() && !shown.is_empty())
    extras = {{"color", title}, {"low", shown.low}, {"high", shown.high}, {"colormap", options.map->name}};
  if (options.height)
    extras["height"] = {{"field", height_title}, {"scale", finite_or_null(heights.scale())}, {"zero", heights.zero()}};
  if (!history.is_null()) extras["history"] = history;
  return extras.empty() ? Value() : extras_of(extras);
}

std::string GltfWriter::finish(bool binary) {
  State& s = *state_;
  s.color_vertices();
  s.place_boxes();
  if (s.frames.size() > 1) animate_frames(s.model, s.buffer, s.frames, s.options.frames_per_second);
  s.buffer.move_to(s.model);

  tinygltf::Node root;
  root.name = "mesh";
  root.translation = {s.place.center.x * s.place.scale, s.place.center.y * s.place.scale, 0};
  if (s.place.scale != 1) root.scale.assign(3, s.place.scale);
  root.children = s.circle_nodes;
  root.children.insert(root.children.end(), s.frames.begin(), s.frames.end());
  s.model.nodes.push_back(std::move(root));
  tinygltf::Scene scene;
  scene.nodes = {static_cast<int>(s.model.nodes.size()) - 1};
  s.model.scenes.push_back(std::move(scene));
  s.model.defaultScene = 0;
  s.model.asset.version = "2.0";
  s.model.asset.generator = "Pliant export-gltf";
  s.model.asset.extras = s.asset_extras();
  const auto is_unlit = [](const tinygltf::Material& material) { return !material.extensions.empty(); };
  if (std::any_of(s.model.materials.begin(), s.model.materials.end(), is_unlit))
    s.model.extensionsUsed.emplace_back("KHR_materials_unlit");
  if (s.options.quantize) {
    s.model.extensionsUsed.emplace_back("KHR_mesh_quantization");
    s.model.extensionsRequired = {"KHR_mesh_quantization"};
  }
  std::ostringstream out;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&s.model, out, !binary, binary);
  s.model = {};
  return std::move(out).str();
}

}  // namespace pliant
