// tests/formats/msh/msh_bad_test.cpp: files that are not MSH, or break its rules, are refused with the place.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "formats/msh/msh.h"
#include "formats/msh/msh_writer.h"
#include "pliant/mesh/check_mesh.h"
#include "support/document_texts.h"
#include "support/msh_texts.h"
#include "support/refusals.h"
#include "support/sample_meshes.h"
#include "tests/formats/msh/msh_sample.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

const std::string header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string nodes = "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n";
const std::string elements = "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n";

/// "line 7: text"
MshSample bad_sample() {
  MshSample sample = msh_of(disk(2, 3));
  sample.names = {{2, 20, "cell"}, {1, 10, "rim"}};
  sample.tail = "$Periodic\n0\n$EndPeriodic\n$NodeData\n1\n\"view\"\n0\n0\n$EndNodeData\n";
  return sample;
}

/// `good` with one to four random changes: of bytes, bits, numbers, lengths.
std::string mutated(const std::string& good, std::mt19937_64& random) {
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::string bad = good;
  for (std::size_t times = 1 + below(4); times > 0; --times) {
    const std::size_t place = below(bad.size());
    switch (below(7)) {
      case 0:
        bad[place] = static_cast<char>(random());
        break;
      case 1:
        bad[place] = static_cast<char>(bad[place] ^ (1 << below(8)));
        break;
      case 2:
        bad.resize(place + 1);
        break;
      case 3:
        bad.erase(place, 1 + below(9));
        break;
      case 4:
        bad.insert(place, bad.substr(below(bad.size()), 1 + below(40)));
        break;
      case 5:
        bad[place] = "0123456789-.e \n$"[below(16)];
        break;
      default: {  // a number in place of a number
        static const std::vector<std::string> numbers = {"0",     "-1",  "1", "2147483648", "18446744073709551615",
                                                         "1e308", "nan", "3", "9",          "15"};
        const std::size_t digit = bad.find_first_of("0123456789", place);
        if (digit != std::string::npos) bad.replace(digit, 1, numbers[below(numbers.size())]);
      }
    }
  }
  return bad;
}

}  // namespace

TEST_CASE("a bad MSH file is refused with the line and what was expected there", "[msh]") {
  const std::string good = header + nodes + elements;
  CHECK(complaint(good) == "none");
  const auto check = [&](const std::string& from, const std::string& to, const std::string& expected) {
    INFO(to);
    CHECK_THAT(complaint(edited(good, from, to)), Catch::StartsWith(expected));
  };
  check("4.1", "4.2", "line 2: MSH version 4.2: versions 1, 2, 4.0 and 4.1 are read");
  check("4.1", "1", "line 2: MSH version 1: ");
  check("4.1 0 8", "4.1 0 4", "line 2: numbers of 4 bytes");
  check("4.1 0 8", "4.1 2 8", "line 2: the file type is 2");
  check("$EndMeshFormat", "$EndMesh", "line 3: expected $EndMeshFormat");
  check("$Nodes\n1 3", "$Nodes\n1 4", "line 12: the section announces 4 nodes, but its blocks hold 3");
  check("2 1 0 3", "2 1 0 4", "line 6: the section announces 3 nodes, but its blocks hold more");
  check("2 1 0 3", "2 1 0 2", "line 11: the section announces 3 nodes, but its blocks hold 2");
  check("2 1 0 3", "7 1 0 3", "line 6: expected a block of nodes: a dimension from 0 to 3");
  check("2 1 0 3", "2 1 5 3", "line 6: expected a block of nodes");
  check("1 3 1 3", "1 99999999999999 1 3", "line 5: the file ends too early: 99999999999999 nodes");
  check("\n2\n3\n", "\n2\n2\n", "line 12: the section $Nodes, which ends here, has two nodes of tag 2");
  check("\n2\n3\n", "\n-2\n3\n", "line 8: a node tag -2 is negative");
  check("1 0 0", "1 nan 0", "line 11: node 2: expected three finite coordinates");
  check("1 0 0", "1 -inf 0", "line 11: node 2: expected three finite coordinates");
  check("1 0 0", "1 1e999 0", "line 11: node 2: expected three finite coordinates");
  check("1 0 0", "1 0,5 0", "line 11: expected a coordinate (a number), found '0,5'");
  check("1 0 0", "1 2e300 0", "line 11: node 2: expected three finite coordinates up to 1e300");
  check("1 0 0", "1 0 7", "node 2: has z = 7");
  check("$EndNodes\n", "", "line 13: expected $EndNodes behind the nodes, found '$Elements'");
  check("$Elements\n1 1", "$Elements\n1 2", "line 17: the section announces 2 elements, but its blocks hold 1");
  check("2 1 2 1\n1 1 2 3", "2 1 2 1\n1 1 2 9", "line 17: there is no node of tag 9");
  check("2 1 2 1\n", "2 1 141 1\n", "line 16: expected the number of an element type, found 141");
  check("1 1 2 3\n$End", "1 1 2\n$End", "line 18: expected a node tag (an integer), found '$EndElements'");
  check("2 1 2 1\n1 1 2 3", "2 1 15 1\n1 1", "the file has no triangles; it has 1 point (type 15)");
  check("$Elements\n", "$Elements\n$Elements\n", "line 15: expected the number of blocks (an integer)");
  CHECK_THAT(complaint(header + elements), Catch::StartsWith("line 4: expected the section $Nodes before $Elements"));
  CHECK_THAT(complaint(header + nodes), Catch::Contains("the file has no section $Elements"));
  CHECK_THAT(complaint(header), Catch::Contains("the file has no section $Nodes"));
  CHECK_THAT(complaint(good + nodes), Catch::StartsWith("line 27: the section $Nodes, which ends here, has two nodes "
                                                        "of tag 1, itself or with an earlier section"));
  std::string many = good;
  for (int k = 0; k < 64; ++k) many += "$Nodes\n0 0 0 0\n$EndNodes\n";
  CHECK_THAT(complaint(many), Catch::StartsWith("line 208: more than 64 sections $Nodes are not read"));
  CHECK_THAT(complaint(good + "rubbish"), Catch::StartsWith("line 19: expected a section, which starts with $"));
  CHECK_THAT(complaint(good + "$Views\n1\n"), Catch::StartsWith("line 19: the section $Views does not end"));
  CHECK_THAT(complaint(good + "$EndViews\n1\n"), Catch::StartsWith("line 19: expected a section"));
  CHECK_THAT(complaint("$NOD\n3\n"), Catch::StartsWith("line 2: the file ends too early: 3 nodes"));
  CHECK_THAT(complaint("$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n1\n1 2 0 1 4 1 1 1 1\n$ENDELM\n"),
             Catch::StartsWith("line 7: elements of type 2 have 3 nodes, not 4"));
  CHECK_THAT(complaint(nodes), Catch::StartsWith("line 1: expected $MeshFormat before $Nodes"));
  CHECK_THAT(complaint("$ELM\n1\n$ENDELM\n"), Catch::StartsWith("line 1: "));
  CHECK_THAT(complaint("rubbish"), Catch::StartsWith("line 1: expected $MeshFormat (an MSH file), found 'rubbish'"));
  CHECK_THAT(complaint(good + header), Catch::StartsWith("line 19: a second section $MeshFormat"));
  const std::string names = "$PhysicalNames\n1\n2 1 \"a\"\n$EndPhysicalNames\n";
  CHECK(complaint(header + names + names + nodes + elements) == "none");
  CHECK_THAT(complaint("$Mesh"), Catch::StartsWith("line 1: expected $MeshFormat"));
  CHECK_THAT(complaint(""), Catch::StartsWith("line 1: expected $MeshFormat"));
  CHECK_THAT(complaint(header + "$PhysicalNames\n1\n2 1 name\n"),
             Catch::StartsWith("line 6: expected a name in double"));
}

TEST_CASE("an error in a binary MSH file has the byte offset", "[msh]") {
  const MshSample sample = bad_sample();
  for (const MshKind& kind : msh_kinds) {
    if (!kind.binary) continue;
    const std::string good = write_msh(sample, kind);
    REQUIRE(complaint(good) == "none");
    const std::size_t place = good.find("$Nodes\n") + 7;
    CHECK_THAT(complaint(good.substr(0, good.find("$EndNodes") - 5)), Catch::StartsWith("byte "));
    std::string marked = good;
    marked[20] = 3;  // of the integer 1
    CHECK_THAT(complaint(marked), Catch::StartsWith("byte 20: expected the integer 1"));
    if (kind.version == 2) continue;
    std::string huge = good;
    huge.replace(place + 8, 8, std::string(8, '\x7f'));
    CHECK_THAT(complaint(huge), Catch::Contains("the file ends too early: 9187201950435737471 nodes"));
  }
}

TEST_CASE("no control point of the largest coordinates that are read overflows", "[msh]") {
  MshSample sample = bad_sample();
  for (auto& node : sample.nodes) node.x *= 1e299;
  CHECK(complaint(write_msh(sample, {})) == "none");
  for (const int order : {2, 5, 10}) {
    std::mt19937 random(7);
    sample = msh_of(disk(order, std::max(3, order)));
    for (auto& node : sample.nodes) {
      node.x = random() % 2 == 0 ? 1e300 : -1e300;
      node.y = random() % 2 == 0 ? 1e300 : -1e300;
    }
    for (const Point& p : read_msh(write_msh(sample, {})).mesh.points)
      CHECK((std::isfinite(p.x) && std::isfinite(p.y)));
  }
}

TEST_CASE("whatever is done to an MSH file, it is a mesh with well-formed arrays or bad input", "[msh]") {
  const int degree = GENERATE(1, 2, 4);
  MshSample sample = msh_of(disk(degree, std::max(3, degree)));
  sample.names = {{2, 20, "cell"}, {1, 10, "rim"}};
  sample.tail = "$Periodic\n0\n$EndPeriodic\n$NodeData\n1\n\"view\"\n0\n0\n$EndNodeData\n";
  sample.elements.push_back({3, 77, 0, 1, {1, 2, 3, 4}});
  if (degree == 4) sample.elements.push_back({2, 78, 0, 1, {1, 2, 3}});
  std::mt19937_64 random(static_cast<std::uint64_t>(degree));
  Outcomes outcomes;
  for (const MshKind& kind : msh_kinds) {
    const std::string good = write_msh(sample, kind);
    for (int k = 0; k < 1200; ++k) {
      const std::string bad = mutated(good, random);
      for (const bool orient : {false, true})
        outcomes.count([&] {
          const MshImport import = read_msh(bad, {orient});
          check_none(check_arrays(import.mesh));
          (void)check_structure(import.mesh, 3);
        });
    }
  }
  CHECK(outcomes.taken > 500);
  CHECK(outcomes.refused > 500);
}

TEST_CASE("whatever is done to an MSH file with views, its fields are well-formed or it is bad input", "[msh]") {
  const int degree = GENERATE(1, 2, 3);
  MeshData mesh = disk(degree, 3);
  Field u;
  u.name = "u";
  for (std::size_t p = 0; p < mesh.points.size(); ++p) u.values.push_back(double(p) / 3);
  Field v = u;
  v.name = "v";
  v.by_face = true;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) v.places.push_back({static_cast<std::int32_t>(p), 0});
  mesh.fields = {u, v};
  std::mt19937_64 random(static_cast<std::uint64_t>(degree));
  Outcomes outcomes;
  int left_out = 0;
  for (const auto version : {MshWriteOptions::Version::v4_1, MshWriteOptions::Version::v2_2})
    for (const bool binary : {false, true}) {
      std::string good;
      write_msh(mesh, {version, binary}, good);
      const std::size_t data = good.find("$NodeData");
      // A second step, and a scheme: the Lagrange basis of order 1.
      std::string tail = good.substr(data);
      tail.replace(tail.find("\"u\""), 3, "\"w\"");
      tail +=
          "$InterpolationScheme\n\"s\"\n1\n3\n2\n3 3\n1 -1 -1\n0 1 0\n0 0 1\n3 2\n0 0\n1 0\n0 "
          "1\n$EndInterpolationScheme\n";
      if (!binary)
        tail +=
            "$ElementNodeData\n2\n\"x\"\n\"s\"\n0\n3\n0\n1\n3\n1 3 1 2 3\n2 3 1 3 4\n3 3 1 4 2\n$EndElementNodeData\n";
      const std::string head = good.substr(0, data), views = good.substr(data) + tail;
      for (int k = 0; k < 1500; ++k) {
        const std::string bad = k % 4 == 0 ? mutated(head + views, random) : head + mutated(views, random);
        outcomes.count([&] {
          const MshImport import = read_msh(bad, {k % 2 == 0, k % 3 == 0 ? std::optional(-1) : std::nullopt});
          check_none(check_arrays(import.mesh));
          (void)check_structure(import.mesh, 3);
          left_out += import.mesh.fields.size() < 4;
        });
      }
    }
  CHECK(outcomes.taken > 500);
  CHECK(left_out > 100);
  CHECK(outcomes.refused > 500);
}
