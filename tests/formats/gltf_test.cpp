// tests/formats/gltf_test.cpp: scenes read back by another reader: geometry, colours, animation.
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "formats/document/document_value.h"
#include "formats/picture/cut_polygon.h"
#include "tests/formats/gltf_reading.h"

namespace pliant {

TEST_CASE("what is read back from a file is what its mesh has, in every degree and colouring", "[formats][gltf]") {
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

TEST_CASE("the area of the straight pieces tends to the curved area, with the square of their size",
          "[formats][gltf]") {
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
  const auto box = std::find_if(small.nodes.begin(), small.nodes.end(),
                                [](const tinygltf::Node& node) { return node.name == "box"; });
  const std::vector<double> exact = numbers(plain, find_primitive(plain, "elements")->attributes.at("POSITION"));
  const std::vector<double> steps = numbers(small, find_primitive(small, "elements")->attributes.at("POSITION"));
  REQUIRE(exact.size() == steps.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (i % 3 == 2) {
      CHECK(steps[i] == 0);
      continue;
    }
    const double scale = box->scale[i % 3];
    CHECK(std::abs(steps[i] / 65535 * scale + box->translation[i % 3] - exact[i]) <= 0.51 * scale / 65535 + 1e-7);
  }
}

TEST_CASE("a polygon is cut into triangles that cover it once", "[formats][gltf][property]") {
  const int seed = GENERATE(range(0, 40));
  CAPTURE(seed);
  // A star around the origin, with corners on straight lines between.
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<double> radius(0.3, 1);
  std::vector<Point> star, corners;
  const int n = 3 + seed % 8;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n, r = radius(random);
    star.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  for (std::size_t k = 0; k < star.size(); ++k) {
    const Point &a = star[k], &b = star[(k + 1) % star.size()];
    for (int step = 0; step <= seed % 3; ++step) corners.push_back(a + (b - a) * (double(step) / (seed % 3 + 1)));
  }
  double whole = 0, sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    whole += cross(corners[k] - Point{}, corners[(k + 1) % corners.size()] - Point{}) / 2;
  const auto triangles = cut_polygon(corners);
  CHECK(triangles.size() == corners.size() - 2);
  std::set<std::array<int, 2>> sides;
  for (const auto& [a, b, c] : triangles) {
    const auto at = [&corners](int k) { return corners[static_cast<std::size_t>(k)]; };
    CHECK(cross(at(b) - at(a), at(c) - at(a)) > -1e-15);  // corners on a line are on it but for rounding
    sum += cross(at(b) - at(a), at(c) - at(a)) / 2;
    for (const auto& side : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) CHECK(sides.insert(side).second);
  }
  CHECK(sum == Approx(whole));
  std::size_t alone = 0;
  for (const auto& [from, to] : sides) alone += sides.count({to, from}) == 0;
  CHECK(alone == corners.size());
}

TEST_CASE("a field lifts the surface: heights are its values, times the scale, above the least of all frames",
          "[formats][gltf]") {
  const bool quantize = GENERATE(false, true), given = GENERATE(false, true);
  std::vector<MeshData> series;
  for (const double shift : {0.0, 3.0}) {
    series.push_back(samples::disk(2));
    samples::add_field(series.back(), "lift", 1,
                       [shift](const Point& p) { return std::vector<double>{1e3 + shift + 2 * p.x - p.y}; });
  }
  GltfOptions options = colored_by("none");
  options.quantize = quantize;
  options.height = parse_color_by("field:lift");
  options.lit = true;
  if (given) options.height_scale = 0.5;
  const tinygltf::Model model = model_of(series, options);
  const auto& about = model.asset.extras.Get("height");
  const double scale = about.Get("scale").GetNumberAsDouble(), zero = about.Get("zero").GetNumberAsDouble();
  if (given) CHECK(scale == 0.5);
  const double size = bounding_box(series[0]).size();
  int frame = 0;
  double most = 0;
  for (const tinygltf::Node& box : model.nodes) {
    if (box.name != "box") continue;
    for (const int child : box.children) {
      const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(child)];
      if (node.name != "elements") continue;
      const tinygltf::Primitive& part = model.meshes[static_cast<std::size_t>(node.mesh)].primitives[0];
      const std::vector<double> at = numbers(model, part.attributes.at("POSITION"));
      const std::vector<double> normals = numbers(model, part.attributes.at("NORMAL"));
      const auto axis = [&box](const std::vector<double>& list, std::size_t k, double other) {
        return list.empty() ? other : list[k];
      };
      for (std::size_t i = 0; i < at.size(); i += 3) {
        std::array<double, 3> p{}, normal{};
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double part_of_box = quantize ? at[i + k] / 65535 : at[i + k];
          p[k] = axis(box.translation, k, 0) + axis(box.scale, k, 1) * part_of_box;
          normal[k] = normals[i + k] / axis(box.scale, k, 1);
          length = std::hypot(length, normal[k]);
        }
        // The disk is around the origin, as is the scene.
        const double value = 1e3 + 3 * frame + 2 * p[0] - p[1];
        CHECK(std::abs(p[2] - (value - zero) * scale) < 2e-4 * size);
        CHECK(normal[2] / length == Approx(1 / std::hypot(1, 2 * scale, scale)).epsilon(5e-3));
        most = std::max(most, p[2]);
      }
    }
    ++frame;
  }
  CHECK(frame == 2);
  if (!given) CHECK(most == Approx(size / 4).epsilon(1e-3));
}

TEST_CASE("heights by face jump: faces share no vertices, and each side of a curve has its band", "[formats][gltf]") {
  MeshData mesh = samples::three_disks(2);
  Field& field = mesh.fields.emplace_back();
  field.name = "level";
  field.by_face = true;
  std::set<std::array<std::int32_t, 2>> places;
  const std::size_t size = mesh.triangles.size() / mesh.triangle_faces.size();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    places.insert({mesh.triangles[i], mesh.triangle_faces[i / size]});
  for (const auto& place : places) {
    field.places.push_back(place);
    field.values.push_back(place[1]);
  }
  GltfOptions options = colored_by("none");
  options.height = parse_color_by("field:level");
  options.height_scale = 1;
  const tinygltf::Model model = model_of({mesh}, options);
  const tinygltf::Primitive& part = *find_primitive(model, "elements");
  const std::vector<double> at = numbers(model, part.attributes.at("POSITION")), index = numbers(model, part.indices);
  for (std::size_t i = 0; i < index.size(); i += 3) {
    const auto z = [&](std::size_t k) { return at[3 * static_cast<std::size_t>(index[i + k]) + 2]; };
    CHECK(z(0) == z(1));
    CHECK(z(1) == z(2));
  }
  std::set<double> levels;
  for (std::size_t i = 2; i < at.size(); i += 3) levels.insert(at[i]);
  CHECK(levels.size() == mesh.boundary.faces.size());
}

TEST_CASE("equal indices are stored once, and bands share one array", "[formats][gltf]") {
  const std::vector<MeshData> series(5, samples::disk(2));
  const tinygltf::Model model = model_of(series, colored_by("face"));
  std::set<int> elements, curves;
  for (const tinygltf::Mesh& mesh : model.meshes) {
    if (mesh.name == "elements") elements.insert(mesh.primitives[0].indices);
    if (mesh.name == "curves") curves.insert(mesh.primitives[0].indices);
  }
  CHECK(elements.size() == 1);
  CHECK(curves.size() == 1);
}

TEST_CASE("a document's history is in the file", "[formats][gltf]") {
  MeshData mesh = samples::disk(2);
  mesh.extra.emplace_back("history",
                          to_document(Json::parse(R"([{"tool":"refine","version":"0.1","options":["-q"]}])")));
  const tinygltf::Model model = model_of({mesh}, colored_by("face"));
  CHECK(model.asset.extras.Get("history").Get(0).Get("tool").Get<std::string>() == "refine");
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

}  // namespace pliant
