// formats/picture/gltf.cpp: a mesh, or a series as an animation, as glTF 2.0 (formats/gltf.md).
#include "formats/picture/gltf.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <utility>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "formats/document/document_value.h"
#include "formats/picture/gltf_buffer.h"
#include "formats/picture/gltf_place.h"
#include "formats/picture/mesh_edges.h"
#include "formats/picture/tessellation.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

using tinygltf::Value;

constexpr double color_tolerance = 0.01;  // how far a field's colour may be off, as a part of the frame's range
constexpr double color_spread = 0.15;     // how much a piece's corners may differ, as a part of the frame's range:
                                          // viewers mix their colours, and leave the map if these are far apart
constexpr double layer = 5e-4;            // height of lines above the fill, and of outlines above lines, as a part of
                                          // the mesh's size
constexpr int circle_corners = 128;
constexpr Rgb ink{0.078, 0.137, 0.18};
constexpr Rgb plain{0.86, 0.89, 0.92};

tinygltf::Primitive primitive(int positions, int indices, int material, int mode) {
  tinygltf::Primitive result;
  result.attributes["POSITION"] = positions;
  result.indices = indices;
  result.material = material;
  result.mode = mode;
  return result;
}

/// What other programs may read beside the scene: JSON, in the values of the writer of glTF, which sorts members.
Value extras_of(const Json& json) {
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

}  // namespace

struct GltfWriter::State {
  explicit State(GltfOptions given) : options(std::move(given)), buffer(options.quantize) {}

  int add_colors(const Tessellation& pieces);
  int material(int& slot, const char* name, const Rgb& color, double opacity);
  int add_node(const char* name, const std::vector<tinygltf::Primitive>& primitives, const Box& box, double height);
  void add_outlines(const MeshData& mesh, std::vector<Point>& vertices, std::vector<std::uint32_t>& triangles) const;
  /// Gives a frame's node its children: elements, invalid ones, edges, and curves as a strip of triangles.
  void add_parts(const Tessellation& pieces, const std::vector<Point>& curve_points,
                 const std::vector<std::uint32_t>& curve_triangles, const Box& box, tinygltf::Node& frame);
  void add_circles();
  void color_vertices();
  void animate();

  GltfOptions options;
  GltfBuffer buffer;
  tinygltf::Model model;
  std::vector<double> values;  // the values of all coloured vertices of all frames; their faces if these colour
  ValueRange range;
  std::string title;
  std::vector<int> frames;  // the node of each frame
  std::vector<int> circle_nodes;
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

int GltfWriter::State::material(int& slot, const char* name, const Rgb& color, double opacity) {
  if (slot >= 0) return slot;
  tinygltf::Material material;
  material.name = name;
  const Rgb linear = linear_light(color);
  material.pbrMetallicRoughness.baseColorFactor = {linear[0], linear[1], linear[2], opacity};
  material.doubleSided = true;
  if (opacity < 1) material.alphaMode = "BLEND";
  material.extensions["KHR_materials_unlit"] = Value(Value::Object{});
  model.materials.push_back(std::move(material));
  return slot = static_cast<int>(model.materials.size()) - 1;
}

int GltfWriter::State::add_node(const char* name, const std::vector<tinygltf::Primitive>& primitives, const Box& box,
                                double height) {
  tinygltf::Mesh mesh;
  mesh.name = name;
  mesh.primitives = primitives;
  model.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model.meshes.size()) - 1;
  if (options.quantize) {
    const Vector extent = box.high - box.low;
    node.translation = {box.low.x, box.low.y, height * layer * size};
    node.scale = {extent.x, extent.y, 1};
  } else if (height > 0) {
    node.translation = {0, 0, height * layer * size};
  }
  model.nodes.push_back(std::move(node));
  return static_cast<int>(model.nodes.size()) - 1;
}

/// Adds a band along each constrained edge: most viewers draw lines no wider than a pixel.
void GltfWriter::State::add_outlines(const MeshData& mesh, std::vector<Point>& vertices,
                                     std::vector<std::uint32_t>& triangles) const {
  const double half = (options.outline_width ? *options.outline_width / place.scale : size / 400) / 2;
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    const std::vector<Point> polygon = positions(mesh, edge.points);
    const int n = options.subdivide > 0 ? options.subdivide : edge_pieces(polygon, options.tolerance * size);
    const Polyline line = sample_edge(polygon, n);
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const Vector across = perpendicular(line.tangents[k]) * half;
      const auto at = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(line.points[k] - across);
      vertices.push_back(line.points[k] + across);
      if (k > 0) triangles.insert(triangles.end(), {at - 2, at, at - 1, at - 1, at, at + 1});
    }
  }
}

void GltfWriter::State::add_circles() {
  for (const Circle& circle : options.circles) {
    std::vector<Point> corners;
    std::vector<std::uint32_t> triangles;
    for (int k = 0; k < circle_corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / circle_corners;
      corners.push_back(circle.center / place.scale - place.center +
                        circle.radius / place.scale * Vector{std::cos(angle), std::sin(angle)});
      const auto i = static_cast<std::uint32_t>(k);
      if (k > 1) triangles.insert(triangles.end(), {0, i - 1, i});
    }
    Box box;
    for (const Point& p : corners) box.extend(p);
    require_drawable(box);
    const int at = buffer.add_positions(corners, box);
    const auto disk = primitive(at, buffer.add_indices(triangles, corners.size()),
                                material(obstacle, "obstacle", obstacle_color, 1), TINYGLTF_MODE_TRIANGLES);
    circle_nodes.push_back(add_node("obstacle", {disk}, box, 0));
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

/// Animates the frames' nodes: each is shown (scale 1) during its frame and hidden (scale 0) otherwise.
void GltfWriter::State::animate() {
  const auto key = [this](std::size_t i) { return static_cast<float>(double(i) / options.frames_per_second); };
  const std::size_t count = frames.size();
  tinygltf::Animation animation;
  animation.name = "series";
  const int first = buffer.add_scales({1, 0}), middle = count > 2 ? buffer.add_scales({0, 1, 0}) : -1,
            last = buffer.add_scales({0, 1, 1});
  for (std::size_t i = 0; i < count; ++i) {
    tinygltf::AnimationSampler sampler;
    sampler.interpolation = "STEP";
    // The last frame has a second key at its end, which gives it its time on the screen.
    sampler.input = i == 0 ? buffer.add_keys({0, key(1)}) : buffer.add_keys({0, key(i), key(i + 1)});
    sampler.output = i == 0 ? first : i + 1 == count ? last : middle;
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(i);
    channel.target_node = frames[i];
    channel.target_path = "scale";
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }
  model.animations.push_back(std::move(animation));
}

GltfWriter::GltfWriter(GltfOptions options) : state_(std::make_unique<State>(std::move(options))) {}
GltfWriter::~GltfWriter() = default;

void GltfWriter::State::add_parts(const Tessellation& pieces, const std::vector<Point>& curve_points,
                                  const std::vector<std::uint32_t>& curve_triangles, const Box& box,
                                  tinygltf::Node& frame) {
  const int at = buffer.add_positions(pieces.vertices, box);
  const std::size_t count = pieces.vertices.size();
  const bool colored = options.color.kind != ColorBy::Kind::nothing;
  const int colors = colored ? add_colors(pieces) : -1;
  const auto part = [&](const char* name, const tinygltf::Primitive& p, double height) {
    frame.children.push_back(add_node(name, {p}, box, height));
  };
  if (!pieces.triangles.empty()) {
    auto filled = primitive(at, buffer.add_indices(pieces.triangles, count),
                            material(fill, "elements", colored ? Rgb{1, 1, 1} : plain, 1), TINYGLTF_MODE_TRIANGLES);
    if (colored) filled.attributes["COLOR_0"] = colors;
    part("elements", filled, 0);
  }
  if (!pieces.marked.empty())
    part("invalid",
         primitive(at, buffer.add_indices(pieces.marked, count), material(invalid, "invalid", invalid_color, 1),
                   TINYGLTF_MODE_TRIANGLES),
         1);
  if (options.edges && !pieces.inner_lines.empty())
    part("edges",
         primitive(at, buffer.add_indices(pieces.inner_lines, count), material(lines, "edges", ink, 0.55),
                   TINYGLTF_MODE_LINE),
         2);
  if (!curve_triangles.empty())
    part("curves",
         primitive(buffer.add_positions(curve_points, box), buffer.add_indices(curve_triangles, curve_points.size()),
                   material(outline, "curves", ink, 1), TINYGLTF_MODE_TRIANGLES),
         3);
}

void GltfWriter::add(const MeshData& mesh) {
  State& s = *state_;
  const GltfOptions& options = s.options;
  if (s.frames.empty()) {
    s.place = GltfPlace(bounding_box(mesh));
    s.size = s.place.size;
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
  TessellationOptions cut;
  cut.subdivide = options.subdivide;
  cut.tolerance = options.tolerance * s.size;
  const ValueRange& shown = options.range ? *options.range : range;
  cut.color_tolerance = color_tolerance * (shown.high - shown.low);
  cut.color_spread = color_spread * (shown.high - shown.low);
  const Point origin = s.place.origin_of(bounding_box(drawn));
  const MeshData local = moved(drawn, origin);
  const Tessellation pieces = tessellate(local, find_edges(local), values, options.color.kind, bad.invalid, cut);
  std::vector<Point> outline;
  std::vector<std::uint32_t> outline_triangles;
  s.add_outlines(local, outline, outline_triangles);
  Box box;
  for (const Point& p : pieces.vertices) box.extend(p);
  for (const Point& p : outline) box.extend(p);
  require_drawable(box);

  tinygltf::Node frame;
  s.add_parts(pieces, outline, outline_triangles, box, frame);
  frame.name = "frame " + std::to_string(s.frames.size());
  if (const Vector shift = origin - s.place.center; shift.x != 0 || shift.y != 0)
    frame.translation = {shift.x, shift.y, 0};
  // A viewer that plays no animation shows the first frame.
  if (!s.frames.empty()) frame.scale = {0, 0, 0};
  frame.extras = extras_of({{"time", mesh.time},
                            {"elements", mesh.triangle_faces.size()},
                            {"invalid", bad.invalid.size()},
                            {"degenerate", bad.degenerate.size()}});
  s.model.nodes.push_back(std::move(frame));
  s.frames.push_back(static_cast<int>(s.model.nodes.size()) - 1);
}

std::string GltfWriter::finish(bool binary) {
  State& s = *state_;
  s.color_vertices();
  if (s.frames.size() > 1) s.animate();
  s.buffer.move_to(s.model);

  tinygltf::Node root;
  root.name = "mesh";
  root.translation = {s.place.center.x * s.place.scale, s.place.center.y * s.place.scale, 0};
  if (s.place.scale != 1) root.scale = {s.place.scale, s.place.scale, s.place.scale};
  root.children = s.circle_nodes;
  root.children.insert(root.children.end(), s.frames.begin(), s.frames.end());
  s.model.nodes.push_back(std::move(root));
  tinygltf::Scene scene;
  scene.nodes = {static_cast<int>(s.model.nodes.size()) - 1};
  s.model.scenes.push_back(std::move(scene));
  s.model.defaultScene = 0;
  s.model.asset.version = "2.0";
  s.model.asset.generator = "Pliant export-gltf";
  const ValueRange shown = s.options.range.value_or(s.range);
  if (!s.title.empty() && !shown.is_empty())
    s.model.asset.extras =
        extras_of({{"color", s.title}, {"low", shown.low}, {"high", shown.high}, {"colormap", s.options.map->name}});
  s.model.extensionsUsed = {"KHR_materials_unlit"};
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
