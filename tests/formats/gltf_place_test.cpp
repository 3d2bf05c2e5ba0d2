// tests/formats/gltf_place_test.cpp: scenes of any size and place, and colours of any range.
#include "pliant/boundary/fault.h"
#include "tests/formats/gltf_reading.h"

namespace pliant {
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
  const auto node_of = [&](int node) { return model.nodes[static_cast<std::size_t>(node)]; };
  const bool has_box = node_of(frame.children.front()).name == "box";
  const tinygltf::Node placing = has_box ? node_of(frame.children.front()) : tinygltf::Node();
  for (const int child : has_box ? placing.children : frame.children) {
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
            number(root.scale, axis, 1) * (number(frame.translation, axis, 0) + number(placing.translation, axis, 0) +
                                           number(placing.scale, axis, 1) * values[axis] / whole);
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

TEST_CASE("obstacles lie below the mesh, so that neither flickers", "[formats][gltf]") {
  const MeshData mesh = colorful(samples::three_disks(2));
  GltfOptions options = colored_by("none");
  options.quantize = GENERATE(false, true);
  options.circles = {{{1.5, 0.5}, 0.25}};
  if (GENERATE(false, true)) options.height = parse_color_by("field:wave");
  for (const tinygltf::Node& node : model_of({mesh}, options).nodes) {
    if (node.name == "obstacle") CHECK(node.translation.at(2) < 0);
    if (node.name == "elements" || node.name == "box") CHECK((node.translation.empty() || node.translation[2] == 0));
  }
}

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
    // A place may be off by single precision or one of the 65536 steps of a quantized box, and by what the doubles of
    // the document have lost at this offset.
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
