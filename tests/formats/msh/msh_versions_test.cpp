// tests/formats/msh/msh_versions_test.cpp: a mesh is read the same from all versions of MSH files, with sections in any
// order.
#include <catch2/catch.hpp>

#include "formats/msh/msh.h"
#include "support/document_texts.h"
#include "support/sample_meshes.h"
#include "tests/formats/msh/msh_sample.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::string as_json(std::string_view bytes) { return text_of(read_msh(bytes).mesh); }

MshSample small_sample() { return msh_of(disk(3, 3)); }

std::string all_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t place = 0; (place = text.find(from, place)) != std::string::npos; place += to.size())
    text.replace(place, from.size(), to);
  return text;
}

std::string write_msh_1(const MshSample& sample, bool parametric) {
  MshWriter w({});
  w.out = "$NOD\n" + std::to_string(sample.nodes.size()) + "\n";
  for (const auto& node : sample.nodes) {
    w.put(node.tag).put(node.x).put(node.y).put(node.z);
    if (parametric) w.put(1).put(7).put(0.5);
    w.end_row();
  }
  w.out += "$ENDNOD\n$ELM\n" + std::to_string(sample.elements.size()) + "\n";
  for (const auto& element : sample.elements) {
    w.put(element.tag).put(element.type).put(element.physical).put(element.entity).put(element.nodes.size());
    for (const std::int64_t node : element.nodes) w.put(node);
    w.end_row();
  }
  return w.out + "$ENDELM\n";
}

/// Version 4.0: tags have 4 bytes, an entity's tag stands before its dimension, nodes have their tags beside them.
std::string write_msh_4_0(const MshSample& sample, const MshKind& kind) {
  const auto size = [](auto value) { return static_cast<std::uint64_t>(value); };
  MshWriter w(kind);
  w.out = std::string("$MeshFormat\n4 ") + (kind.binary ? "1 8\n" : "0 8\n");
  if (kind.binary) w.put(std::int32_t{1}).out += "\n";
  w.out += "$EndMeshFormat\n$Entities\n";
  std::array<std::map<int, int>, 4> entities;
  for (const auto& element : sample.elements)
    entities[static_cast<std::size_t>(msh_dimension(element.type))][element.entity] = element.physical;
  for (const auto& of : entities) w.put(size(of.size()));
  w.end_row();
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (const auto& [tag, physical] : entities[dimension]) {
      w.put(tag);
      for (int k = 0; k < 6; ++k) w.put(0.5);
      w.put(size(1)).put(physical);
      if (dimension > 0) w.put(size(0));
      w.end_row();
    }
  w.out += "\n$EndEntities\n$Nodes\n";
  w.put(size(2)).put(size(sample.nodes.size())).end_row();
  for (const bool parametric : {false, true}) {
    const std::size_t half = sample.nodes.size() / 2;
    const std::size_t first = parametric ? half : 0, end = parametric ? sample.nodes.size() : half;
    w.put(5).put(2).put(parametric ? 1 : 0).put(size(end - first)).end_row();
    for (std::size_t k = first; k < end; ++k) {
      const auto& node = sample.nodes[k];
      w.put(static_cast<std::int32_t>(node.tag)).put(node.x).put(node.y).put(node.z);
      if (parametric) w.put(0.1).put(0.2);
      w.end_row();
    }
  }
  w.out += "\n$EndNodes\n$Elements\n";
  w.put(size(sample.elements.size())).put(size(sample.elements.size())).end_row();
  for (const auto& element : sample.elements) {
    w.put(element.entity).put(msh_dimension(element.type)).put(element.type).put(size(1)).end_row();
    w.put(static_cast<std::int32_t>(element.tag));
    for (const std::int64_t node : element.nodes) w.put(static_cast<std::int32_t>(node));
    w.end_row();
  }
  return w.out + "\n$EndElements\n";
}

/// Version 2 with Mesh.SaveParametric, on entities of every dimension.
std::string write_parametric(const MshSample& sample, const MshKind& kind) {
  const std::string plain = write_msh(sample, kind);
  MshWriter w(kind);
  const std::string head = "$Nodes\n" + std::to_string(sample.nodes.size()) + "\n";
  for (std::size_t k = 0; k < sample.nodes.size(); ++k) {
    const auto& node = sample.nodes[k];
    const int dimension = static_cast<int>(k % 4);
    w.put(static_cast<std::int32_t>(node.tag)).put(node.x).put(node.y).put(node.z).put(dimension).put(std::int32_t{7});
    for (int p = 0; p < dimension % 3; ++p) w.put(0.25);
    w.end_row();
  }
  return plain.substr(0, plain.find("$Nodes")) + all_replaced(head, "$Nodes", "$ParametricNodes") + w.out +
         "\n$EndParametricNodes" + plain.substr(plain.find("$EndNodes") + 9);
}

}  // namespace

TEST_CASE("every version of a file is read as the same mesh", "[msh]") {
  const MshSample sample = small_sample();
  const std::string expected = as_json(write_msh(sample, {}));
  CHECK(as_json(write_msh_1(sample, false)) == expected);
  CHECK(as_json(write_msh_1(sample, true)) == expected);
  CHECK(as_json(all_replaced(write_msh_1(sample, false), "NOD\n", "NOE\n")) == expected);
  for (const bool binary : {false, true})
    for (const bool swapped : {false, true}) {
      if (swapped && !binary) continue;
      CHECK(as_json(write_msh_4_0(sample, {4, binary, swapped})) == expected);
      CHECK(as_json(write_parametric(sample, {2, binary, swapped})) == expected);
    }
}

TEST_CASE("sections that mean nothing may stand anywhere, and unknown ones are named", "[msh]") {
  const MshSample sample = small_sample();
  const std::string expected = as_json(write_msh(sample, {}));
  const std::string comments = "$Comments\nof $Nodes and\n $EndNodes\n$EndComments\n",
                    mine = "$Mine\n1 2 3\n$EndMine\n";
  for (const MshKind& kind : msh_kinds) {
    const std::string plain = write_msh(sample, kind);
    std::vector<std::string> places{comments + mine + comments + plain, plain + mine + comments};
    for (const char* before : {"$Nodes\n", "$Elements\n"})
      places.push_back(all_replaced(plain, before, comments + mine + before));
    for (const std::string& bytes : places) {
      CHECK(as_json(bytes) == expected);
      CHECK(read_msh(bytes).warnings == std::vector<std::string>{"not read: $Mine"});
    }
    CHECK(read_msh(comments + plain + comments).warnings.empty());
  }
}

TEST_CASE("lines of text files may end in CR and LF, comments too", "[msh]") {
  const MshSample sample = small_sample();
  const std::string expected = as_json(write_msh(sample, {}));
  const std::string comments = "$Comments\na comment\n$EndComments\n";
  for (const int version : {2, 4}) {
    const std::string bytes = comments + write_msh(sample, {version, false, false}) + comments;
    CHECK(as_json(all_replaced(bytes, "\n", "\r\n")) == expected);
  }
  CHECK(as_json(all_replaced(write_msh_1(sample, false), "\n", "\r\n")) == expected);
}

TEST_CASE("nodes at the same place are named", "[msh]") {
  MshSample sample;
  sample.nodes = {{1, 0, 0, 0}, {2, 1, 0, 0}, {3, 0, 1, 0}, {12, 1, 0, 0}, {13, 1e-16, 1, 0}, {14, 1, 1, 0}};
  sample.elements = {{2, 1, 0, 1, {1, 2, 3}}, {2, 2, 0, 2, {12, 14, 13}}};
  const MshImport import = read_msh(write_msh(sample, {}));
  REQUIRE(import.warnings.size() == 1);
  CHECK_THAT(import.warnings[0], Catch::StartsWith("nodes are at one place twice (2 and 12, 3 and 13): "));
  sample.elements[1].nodes = {2, 14, 3};
  CHECK(read_msh(write_msh(sample, {})).warnings.empty());
  CHECK(read_msh(write_msh(small_sample(), {})).warnings.empty());
}

TEST_CASE("whatever is done to a file of an old version, it is a mesh or bad input", "[msh]") {
  const MshSample sample = small_sample();
  const std::vector<std::string> good{
      write_msh_1(sample, true), write_msh_4_0(sample, {}), write_msh_4_0(sample, {4, true, false}),
      write_parametric(sample, {2, true, false}), write_parametric(sample, {2, false, false})};
  std::uint64_t state = 1;
  const auto below = [&state](std::size_t n) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>((state >> 33U) % n);
  };
  int refused = 0;
  for (const std::string& bytes : good)
    for (int k = 0; k < 600; ++k) {
      std::string bad = bytes;
      for (std::size_t times = 1 + below(3); times > 0; --times) bad[below(bad.size())] = static_cast<char>(below(256));
      if (k % 10 == 0) bad.resize(below(bad.size()));
      try {
        read_msh(bad);
      } catch (const InputError&) {
        ++refused;
      }
    }
  CHECK(refused > 300);
  CHECK(refused < 3000);
}

TEST_CASE("sections of MSH files that come again are read one after the other", "[msh]") {
  // Gmsh 4.8 does so, too, with 4.1, but for the nodes of the last section only.
  const std::string tail_nodes = "$Nodes\n2\n8 1 1 0\n9 2 0 0\n$EndNodes\n",
                    tail_elements = "$Elements\n2\n5 2 2 1 1 2 8 3\n6 2 2 4 1 2 9 8\n$EndElements\n";
  const std::string head =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"a\"\n$EndPhysicalNames\n"
      "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
  const std::string elements = "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n",
                    names = "$PhysicalNames\n1\n2 4 \"b\"\n$EndPhysicalNames\n";
  const std::string at_once =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"a\"\n2 4 \"b\"\n$EndPhysicalNames\n"
      "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n8 1 1 0\n9 2 0 0\n$EndNodes\n"
      "$Elements\n3\n1 2 2 1 1 1 2 3\n5 2 2 1 1 2 8 3\n6 2 2 4 1 2 9 8\n$EndElements\n";
  const std::string expected = as_json(at_once);
  CHECK(as_json(head + elements + tail_nodes + tail_elements + names) == expected);
  CHECK(as_json(head + tail_nodes + elements + names + tail_elements) == expected);
  CHECK_THROWS_AS(read_msh(head + "$Elements\n1\n1 2 2 1 1 1 2 8\n$EndElements\n" + tail_nodes), InputError);
  const MshImport import = read_msh(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 7 0\n$EndEntities\n"
      "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
      "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n"
      "$Entities\n0 0 1 0\n2 0 0 0 1 1 0 1 8 0\n$EndEntities\n"
      "$Nodes\n1 1 4 4\n2 2 0 1\n4\n1 1 0\n$EndNodes\n"
      "$Elements\n1 1 2 2\n2 2 2 1\n2 2 4 3\n$EndElements\n");
  REQUIRE(import.mesh.triangle_faces.size() == 2);
  CHECK(import.mesh.boundary.faces[1].name == "physical surface 8");
  CHECK(import.mesh.points.size() == 4);
}
