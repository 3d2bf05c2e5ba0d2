#include "formats/gltf.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <set>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "formats/mesh_edges.h"
#include "formats/tessellation.h"
#include "pliant/geometry/jacobian.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_meshes.h"

namespace pliant {
namespace {

tinygltf::Model read_back(const std::string& file, bool binary) {
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

MeshData colorful(MeshData mesh) {
  samples::add_field(mesh, "wave", 1, [](const Point& p) { return std::vector<double>{std::sin(3 * p.x) * p.y}; });
  return mesh;
}

tinygltf::Model model_of(const std::vector<MeshData>& series, GltfOptions options, bool binary = true) {
  GltfWriter writer(std::move(options));
  for (const MeshData& mesh : series) writer.add(mesh);
  return read_back(writer.finish(binary), binary);
}

GltfOptions colored_by(const std::string& color) {
  GltfOptions options;
  options.color = parse_color_by(color);
  return options;
}

/// The numbers of an accessor, as stored.
std::vector<double> numbers(const tinygltf::Model& model, int index) {
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
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
          result.push_back(read(std::uint16_t{}));
          break;
        default:
          result.push_back(read(std::uint32_t{}));
      }
    }
  return result;
}

const tinygltf::Primitive* find_primitive(const tinygltf::Model& model, const std::string& mesh) {
  for (const tinygltf::Mesh& each : model.meshes)
    if (each.name == mesh) return each.primitives.data();
  return nullptr;
}

double curved_area(const MeshData& mesh) {
  double sum = 0;
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
    sum += element_area(mesh.degree, element_net(mesh, t));
  return sum;
}

double drawn_area(const tinygltf::Model& model) {
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

}  // namespace

TEST_CASE("a file reads back with what its mesh has, in every degree and colouring", "[formats][gltf]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const bool quantize = GENERATE(false, true), binary = GENERATE(false, true);
  const MeshData mesh = colorful(samples::three_disks(degree));
  for (const char* color : {"none", "face", "shape", "field:wave"}) {
    CAPTURE(degree, quantize, binary, color);
    GltfOptions options = colored_by(color);
    options.quantize = quantize;
    options.circles = {{{1.5, 0.5}, 0.25}};
    const tinygltf::Model model = model_of({mesh}, options, binary);
    CHECK(model.animations.empty());
    for (const char* part : {"elements", "edges", "curves", "obstacle"}) CHECK(find_primitive(model, part) != nullptr);
    CHECK(find_primitive(model, "invalid") == nullptr);
    for (const tinygltf::Mesh& each : model.meshes)
      for (const tinygltf::Primitive& primitive : each.primitives) {
        const int position = primitive.attributes.at("POSITION");
        const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(position)];
        const std::vector<double> at = numbers(model, position);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double low = HUGE_VAL, high = -HUGE_VAL;
          for (std::size_t i = axis; i < at.size(); i += 3) low = std::min(low, at[i]), high = std::max(high, at[i]);
          CHECK(accessor.minValues[axis] == low);
          CHECK(accessor.maxValues[axis] == high);
        }
        std::set<double> used;
        for (const double index : numbers(model, primitive.indices)) used.insert(index);
        CHECK(*used.rbegin() < double(accessor.count));
        const bool has_colors = primitive.attributes.count("COLOR_0") > 0;
        CHECK(has_colors == (each.name == "elements" && std::string(color) != "none"));
        if (has_colors)
          CHECK(model.accessors[static_cast<std::size_t>(primitive.attributes.at("COLOR_0"))].count == accessor.count);
      }
  }
}

TEST_CASE("the straight pieces' area tends to the curved one, by the square of their size", "[formats][gltf]") {
  const int degree = GENERATE(2, 3, 4);
  const MeshData mesh = samples::disk(degree);
  const double area = curved_area(mesh);
  double last = 0;
  for (const int n : {1, 2, 4, 8}) {
    GltfOptions options = colored_by("none");
    options.subdivide = n;
    const double error = std::abs(drawn_area(model_of({mesh}, options)) - area);
    CAPTURE(degree, n, error, last);
    if (n > 1) CHECK(last / error == Approx(4).epsilon(0.15));
    last = error;
  }
}

TEST_CASE("by default the drawn boundary is within the tolerance, so the area is too", "[formats][gltf]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const MeshData mesh = colorful(samples::three_disks(degree));
  for (const char* color : {"none", "shape", "field:wave"}) {
    CAPTURE(degree, color);
    const GltfOptions options = colored_by(color);
    const double length = 2 * 3.15 * 3.25;
    CHECK(std::abs(drawn_area(model_of({mesh}, options)) - curved_area(mesh)) <
          options.tolerance * bounding_box(mesh).size() * length + 1e-5);
  }
}

TEST_CASE("the lattice of an element covers it once, whatever the cuts of its edges", "[formats][gltf][property]") {
  const int n = GENERATE(1, 2, 4, 8, 16);
  for (int a = 1; a <= n; a *= 2)
    for (int b = 1; b <= n; b *= 2)
      for (int c = 1; c <= n; c *= 2) {
        CAPTURE(n, a, b, c);
        std::map<std::array<int, 4>, int> sides;
        int area = 0;
        for (const auto& [p, q, r] : ElementLattice{n, {a, b, c}}.triangles()) {
          const int twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
          CHECK(twice > 0);
          area += twice;
          ++sides[{p[0], p[1], q[0], q[1]}], ++sides[{q[0], q[1], r[0], r[1]}], ++sides[{r[0], r[1], p[0], p[1]}];
        }
        CHECK(area == n * n);
        int alone = 0;
        for (const auto& [side, count] : sides) {
          CHECK(count == 1);
          alone += sides.count({side[2], side[3], side[0], side[1]}) == 0;
        }
        // Only the cuts of the edges have no neighbour: there are no T-junctions.
        CHECK(alone == a + b + c);
      }
}

TEST_CASE("pieces of neighbours share their vertices where a field is continuous: no cracks", "[formats][gltf]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const MeshData mesh = colorful(samples::three_disks(degree));
  const MeshEdges edges = find_edges(mesh);
  TessellationOptions options;
  options.tolerance = 1e-4;
  options.color_tolerance = GENERATE(1e-3, 0.1);
  const ColorBy color = parse_color_by("field:wave");
  const Tessellation pieces = tessellate(mesh, edges, ElementValues(mesh, color), color.kind, {}, options);
  std::set<std::array<std::uint32_t, 2>> sides;
  for (std::size_t i = 0; i < pieces.triangles.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(sides.insert({pieces.triangles[i + k], pieces.triangles[i + (k + 1) % 3]}).second);
  std::size_t outer = 0, expected = 0;
  for (const auto& [from, to] : sides) outer += sides.count({to, from}) == 0;
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    const std::vector<Point> polygon = positions(mesh, edge.points);
    expected += static_cast<std::size_t>(edge_pieces(polygon, options.tolerance));
  }
  CHECK(outer >= expected);
  for (std::size_t i = 0; i < pieces.inner_lines.size(); i += 2)
    CHECK(sides.count({pieces.inner_lines[i], pieces.inner_lines[i + 1]}) == 1);
}

TEST_CASE("a series is an animation with a channel a frame, and shows one frame at any time", "[formats][gltf]") {
  const std::size_t count = GENERATE(2, 3, 7);
  std::vector<MeshData> series;
  for (std::size_t i = 0; i < count; ++i) {
    series.push_back(samples::disk(2, 6, {double(i), 0}));
    series.back().time = 0.5 * double(i);
  }
  GltfOptions options = colored_by("shape");
  options.frames_per_second = 10;
  const tinygltf::Model model = model_of(series, options);
  REQUIRE(model.animations.size() == 1);
  const tinygltf::Animation& animation = model.animations[0];
  REQUIRE(animation.channels.size() == count);
  for (std::size_t shown = 0; shown < count; ++shown) {
    const double now = (double(shown) + 0.5) / 10;
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(count, shown, i);
      const tinygltf::AnimationChannel& channel = animation.channels[i];
      const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
      CHECK(sampler.interpolation == "STEP");
      CHECK(channel.target_path == "scale");
      const std::vector<double> keys = numbers(model, sampler.input), scales = numbers(model, sampler.output);
      REQUIRE(scales.size() == 3 * keys.size());
      CHECK(std::is_sorted(keys.begin(), keys.end(), std::less_equal<>()));
      const auto after = std::upper_bound(keys.begin(), keys.end(), now) - keys.begin();
      CHECK(scales[static_cast<std::size_t>(3 * (after - 1))] == (i == shown ? 1 : 0));
      const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(channel.target_node)];
      CHECK(node.extras.Get("time").GetNumberAsDouble() == 0.5 * double(i));
      // Without animation, the first frame.
      CHECK(node.scale == (i == 0 ? std::vector<double>{} : std::vector<double>{0, 0, 0}));
    }
  }
}

TEST_CASE("far from the origin the drawing keeps its precision, and its place", "[formats][gltf]") {
  const Point far{1e7, -3e6};
  const MeshData mesh = samples::disk(2, 8, far, 1e-2);
  const tinygltf::Model model = model_of({mesh}, colored_by("none"));
  const tinygltf::Node& root = model.nodes[static_cast<std::size_t>(model.scenes[0].nodes[0])];
  CHECK(root.translation[0] == Approx(far.x).epsilon(1e-12));
  CHECK(root.translation[1] == Approx(far.y).epsilon(1e-12));
  CHECK(drawn_area(model) == Approx(curved_area(mesh)).epsilon(1e-2));
}

TEST_CASE("quantized positions are within half a step of the true ones", "[formats][gltf]") {
  const MeshData mesh = samples::three_disks(2);
  GltfOptions options = colored_by("none");
  const tinygltf::Model plain = model_of({mesh}, options);
  options.quantize = true;
  const tinygltf::Model small = model_of({mesh}, options);
  CHECK(small.extensionsRequired == std::vector<std::string>{"KHR_mesh_quantization"});
  const auto elements = std::find_if(small.nodes.begin(), small.nodes.end(),
                                     [](const tinygltf::Node& node) { return node.name == "elements"; });
  const std::vector<double> exact = numbers(plain, find_primitive(plain, "elements")->attributes.at("POSITION"));
  const std::vector<double> steps = numbers(small, find_primitive(small, "elements")->attributes.at("POSITION"));
  REQUIRE(exact.size() == steps.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double scale = elements->scale[i % 3];
    CHECK(std::abs(steps[i] / 65535 * scale + elements->translation[i % 3] - exact[i]) <= 0.51 * scale / 65535 + 1e-7);
  }
}

TEST_CASE("elements that are not valid are a part of their own", "[formats][gltf]") {
  MeshData mesh = samples::disk(2);
  mesh.points[static_cast<std::size_t>(mesh.triangles[3])] += Point{0.4, 0.9};
  REQUIRE_FALSE(find_invalid(mesh).invalid.empty());
  const tinygltf::Model model = model_of({mesh}, colored_by("shape"));
  CHECK(find_primitive(model, "invalid") != nullptr);
}

TEST_CASE("the range of colours is that of all frames", "[formats][gltf]") {
  std::vector<MeshData> series;
  for (const double value : {1.0, 5.0}) {
    series.push_back(samples::disk(1));
    samples::add_field(series.back(), "level", 1, [value](const Point&) { return std::vector<double>{value}; });
  }
  const tinygltf::Model model = model_of(series, colored_by("field:level"));
  CHECK(model.asset.extras.Get("low").GetNumberAsDouble() == 1);
  CHECK(model.asset.extras.Get("high").GetNumberAsDouble() == 5);
  const std::vector<double> colors = numbers(model, find_primitive(model, "elements")->attributes.at("COLOR_0"));
  const Rgb lowest = linear_light(colormaps()[0].stops.front());
  for (std::size_t c = 0; c < 3; ++c) CHECK(colors[c] == std::round(lowest[c] * 255));
}

namespace {

/// The box of the fill of a frame in the world, by the translations and scales of its nodes.
Box world_box(const tinygltf::Model& model, const std::string& frame_name) {
  const auto named = [&](const std::string& name) {
    return *std::find_if(model.nodes.begin(), model.nodes.end(), [&](const auto& node) { return node.name == name; });
  };
  Box box;
  const auto number = [](const std::vector<double>& list, std::size_t axis, double otherwise) {
    return list.empty() ? otherwise : list[axis];
  };
  const tinygltf::Node root = named("mesh"), frame = named(frame_name);
  for (const int child : frame.children) {
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(child)];
    if (node.name != "elements") continue;
    const auto& primitive = model.meshes[static_cast<std::size_t>(node.mesh)].primitives.front();
    const auto& accessor = model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    const double whole = accessor.normalized ? 65535 : 1;
    const auto corner = [&](const std::vector<double>& values) {
      std::array<double, 2> at{};
      for (std::size_t axis = 0; axis < 2; ++axis)
        at[axis] =
            number(root.translation, axis, 0) +
            number(root.scale, axis, 1) * (number(frame.translation, axis, 0) + number(node.translation, axis, 0) +
                                           number(node.scale, axis, 1) * values[axis] / whole);
      return Point{at[0], at[1]};
    };
    box.extend(corner(accessor.minValues));
    box.extend(corner(accessor.maxValues));
  }
  return box;
}

MeshData placed(MeshData mesh, double scale, const Vector& offset) {
  for (Point& p : mesh.points) p = scale * p + offset;
  return mesh;
}

}  // namespace

TEST_CASE("meshes of any size and place are drawn to single precision of their size", "[formats][gltf]") {
  const MeshData mesh = samples::three_disks(2);
  const bool quantize = GENERATE(false, true);
  GltfOptions options = colored_by("shape");
  options.quantize = quantize;
  options.tolerance = 1e-6;
  const Box plain = world_box(model_of({mesh}, options), "frame 0");
  struct Case {
    double scale;
    Vector offset;
  };
  for (const auto& [scale, offset] :
       {Case{1, {0, 0}}, Case{2, {5e6, -5e6}}, Case{1e-3, {1e6, 0}}, Case{1e-200, {0, 0}}, Case{1e200, {0, 0}},
        Case{1e-7, {1, 1}}, Case{1e8, {1e9, 1}}, Case{1e150, {1e151, 0}}, Case{1e-300, {1e-299, 0}}}) {
    CAPTURE(scale, offset.x, quantize);
    const MeshData there = placed(mesh, scale, offset);
    const tinygltf::Model model = model_of({there}, options);
    const Box found = world_box(model, "frame 0");
    // What the doubles of the offset cannot hold is lost before; a quantized box has 65536 steps.
    const double allowed = scale * (quantize ? 1e-4 : 1e-6) + 4e-16 * std::max(std::abs(offset.x), std::abs(offset.y));
    for (const auto& [is, should] : {std::pair(found.low, plain.low), std::pair(found.high, plain.high)}) {
      CHECK(std::abs(is.x - (scale * should.x + offset.x)) <= allowed);
      CHECK(std::abs(is.y - (scale * should.y + offset.y)) <= allowed);
    }
    for (const auto& accessor : model.accessors)
      if (accessor.type == TINYGLTF_TYPE_VEC3 && !accessor.maxValues.empty()) {
        CHECK(std::abs(accessor.maxValues[0]) < 1e10);
        CHECK((accessor.maxValues[0] - accessor.minValues[0]) > 1e-8);
      }
  }
}

TEST_CASE("a frame far from the first keeps its precision, and what has none is refused", "[formats][gltf]") {
  const MeshData mesh = samples::three_disks(2);
  const GltfOptions options = colored_by("none");
  const Box plain = world_box(model_of({mesh}, options), "frame 0");
  const Vector offset{3e8, -2e8};
  const tinygltf::Model far = model_of({mesh, placed(mesh, 1, offset)}, options);
  const Box found = world_box(far, "frame 1");
  CHECK(std::abs(found.low.x - (plain.low.x + offset.x)) < 1e-5);
  CHECK(std::abs(found.high.y - (plain.high.y + offset.y)) < 1e-5);
  CHECK_THROWS_AS(model_of({mesh, placed(mesh, 1e40, {})}, options), InputError);
  CHECK_THROWS_AS(model_of({mesh, placed(mesh, 1e-40, {})}, options), InputError);
  CHECK_THROWS_AS(model_of({placed(mesh, 1.7e308, {-1.7e308, 0})}, options), InputError);
  GltfOptions circled = options;
  circled.circles = {{{1e40, 0}, 1}};
  CHECK_THROWS_AS(model_of({mesh}, circled), InputError);
}

TEST_CASE("colours tell values apart that single precision does not", "[formats][gltf]") {
  MeshData mesh = samples::three_disks(2);
  samples::add_field(mesh, "high", 1, [](const Point& p) { return std::vector<double>{1e9 + p.x}; });
  samples::add_field(mesh, "huge", 1, [](const Point& p) { return std::vector<double>{1e200 * p.x}; });
  for (const char* color : {"field:high", "field:huge"}) {
    const tinygltf::Model model = model_of({mesh}, colored_by(color));
    const std::vector<double> colors = numbers(model, find_primitive(model, "elements")->attributes.at("COLOR_0"));
    CHECK(std::set<double>(colors.begin(), colors.end()).size() > 50);
  }
}

}  // namespace pliant
