// tests/formats/msh/msh_views_test.cpp: views of MSH files that become fields, and those that do not.
#include <catch2/catch.hpp>

#include "formats/msh/msh.h"
#include "formats/msh/msh_writer.h"
#include "pliant/mesh/check_mesh.h"
#include "support/msh_texts.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

// Two triangles of order 1 in two faces, 1 2 3 and 2 4 3.
const std::string linear =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 4 4 0\n9 7 7 0\n$EndNodes\n"
    "$Elements\n2\n11 2 2 7 1 1 2 3\n12 2 2 9 2 2 4 3\n$EndElements\n";
// The same triangle 1 2 3 of order 2, alone.
const std::string quadratic =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 2 0 0\n5 2 2 0\n6 0 2 0\n$EndNodes\n"
    "$Elements\n1\n11 9 2 7 1 1 2 3 4 5 6\n$EndElements\n";

/// A section with these entries, each a line.
std::string section(const std::string& kind, const std::string& name, int components, int count,
                    const std::string& lines, int step = 0, const std::string& time = "0", const std::string& more = "",
                    int partition = 0) {
  return "$" + kind + "\n" + (more.empty() ? "1" : "3") + "\n\"" + name + "\"\n" + more + "1\n" + time + "\n4\n" +
         std::to_string(step) + "\n" + std::to_string(components) + "\n" + std::to_string(count) + "\n" +
         std::to_string(partition) + "\n" + lines + "$End" + kind + "\n";
}

std::vector<double> values(const std::string& file, const MshOptions& options = {}) {
  const MshImport import = read_msh(file, options);
  for (const std::string& text : import.warnings) UNSCOPED_INFO(text);
  REQUIRE(import.mesh.fields.size() == 1);
  CHECK(check_arrays(import.mesh).empty());
  return import.mesh.fields[0].values;
}

std::string warning(const std::string& file) {
  const MshImport import = read_msh(file);
  CHECK(check_arrays(import.mesh).empty());
  return import.warnings.empty() ? "" : import.warnings.front();
}

}  // namespace

TEST_CASE("a view of a lower degree than the mesh's is raised, one of a higher degree left out", "[msh]") {
  CHECK(values(quadratic + section("ElementNodeData", "u", 1, 1, "11 3 0 4 8\n")) ==
        std::vector<double>{0, 4, 8, 2, 6, 4});
  CHECK(values(quadratic + section("ElementData", "u", 1, 1, "11 5\n")) == std::vector<double>(6, 5));
  // x^2/4 at the nodes; its control values are 0 4 0, 0 0 0 but for the edges of corner 2.
  CHECK(values(quadratic + section("NodeData", "u", 1, 6, "1 0\n2 4\n3 0\n4 1\n5 1\n6 0\n")) ==
        std::vector<double>{0, 4, 0, 0, 0, 0});
  CHECK(warning(linear + section("ElementNodeData", "u", 1, 2, "11 6 1 1 1 1 1 1\n12 3 1 1 1\n")) ==
        "the view u is left out: it has degree 2, the mesh degree 1 (at element 11)");
  CHECK(warning(linear + section("ElementNodeData", "u", 1, 2, "11 4 1 1 1 1\n12 3 1 1 1\n")) ==
        "the view u is left out: an element has 4 values, which no triangle of order 1 to 10 has (at element 11)");
}

TEST_CASE("values of elements become a continuous field, one by face, or none", "[msh]") {
  const auto read = [&](const std::string& lines, const std::string& mark = "") {
    return read_msh(linear + section("ElementNodeData", "u", 1, 2, lines, 0, "0", mark));
  };
  const MeshData same = read("11 3 1 2 3\n12 3 2 4 3\n").mesh;
  CHECK_FALSE(same.fields[0].by_face);
  CHECK(same.fields[0].values == std::vector<double>{1, 2, 3, 4});
  const MeshData jumps = read("12 3 7 4 3\n11 3 1 2 3\n").mesh;
  REQUIRE(jumps.fields[0].by_face);
  CHECK(jumps.fields[0].values == std::vector<double>{1, 2, 7, 3, 3, 4});
  CHECK(read("11 3 1 2 3\n12 3 2 4 3\n", "\"\"\n\"by_face\"\n").mesh.fields[0].by_face);
  // Rounding is no jump.
  CHECK_FALSE(read("11 3 1 2 3\n12 3 2.000000000000001 4 3\n").mesh.fields[0].by_face);
  std::string one_face = linear;
  one_face.replace(one_face.find("12 2 2 9 2"), 10, "12 2 2 7 1");
  CHECK(warning(one_face + section("ElementData", "u", 1, 2, "11 1\n12 2\n")) ==
        "the view u is left out: its values jump inside a face (most at a node of element 12), and fields are "
        "continuous there");
}

TEST_CASE("a vector is one of the plane if its third component is 0", "[msh]") {
  const auto read = [&](const std::string& last, const std::string& mark = "") {
    return read_msh(linear +
                    section("NodeData", "v", 3, 4, "1 1 2 0\n2 3 4 0\n3 5 6 0\n4 7 8 " + last + "\n", 0, "0", mark))
        .mesh.fields[0];
  };
  CHECK(read("0").values == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(read("1").components == 3);
  CHECK(read("0", "\"\"\n\"components=3\"\n").components == 3);
}

TEST_CASE("of several time steps one is read, which a warning says", "[msh]") {
  std::string file = linear;
  for (const int step : {4, 0, 2})
    file += section("NodeData", "u", 1, 4, "1 " + std::to_string(step) + "\n2 0\n3 0\n4 0\n", step,
                    std::to_string(step) + ".5");
  CHECK(warning(file) ==
        "the view u has 3 time steps: the first is read, of time 0.5; import-msh --step takes another");
  for (const auto& [step, first] : {std::pair(0, 0.0), std::pair(1, 2.0), std::pair(-1, 4.0), std::pair(-3, 0.0)}) {
    const MshImport import = read_msh(file, {false, step});
    CHECK(import.warnings.empty());
    CHECK(import.mesh.time == first + 0.5);
    CHECK(import.mesh.fields[0].values[0] == first);
  }
  for (const int step : {3, -4}) CHECK(read_msh(file, {false, step}).no_step == "the view u has 3 steps");
  // A view with one step is taken whatever is asked for.
  file += section("NodeData", "w", 1, 4, "1 1\n2 1\n3 1\n4 1\n");
  CHECK(read_msh(file, {false, 2}).mesh.fields.size() == 2);
  CHECK(read_msh(file, {false, 2}).warnings ==
        std::vector<std::string>{"the views have different times: that of u, 4.5, is the mesh's"});
}

TEST_CASE("sections of several partitions are one view, and a second one of the same kind is another", "[msh]") {
  const std::string parts = section("NodeData", "u", 1, 3, "1 1\n2 2\n3 3\n", 0, "0", "", 1) +
                            section("NodeData", "u", 1, 3, "2 2\n4 4\n3 3\n", 0, "0", "", 2);
  CHECK(values(linear + parts) == std::vector<double>{1, 2, 3, 4});
  const std::string whole = section("NodeData", "u", 1, 4, "1 1\n2 1\n3 1\n4 1\n");
  const MeshData twice = read_msh(linear + whole + whole + section("NodeData", "", 1, 4, "1 1\n2 1\n3 1\n4 1\n")).mesh;
  REQUIRE(twice.fields.size() == 3);
  CHECK(twice.fields[1].name == "u (2)");
  CHECK(twice.fields[2].name == "view");
}

TEST_CASE("what is not whole is left out, with the reason", "[msh]") {
  const auto why = [](const std::string& data) { return warning(linear + data); };
  CHECK(why(section("NodeData", "u", 1, 3, "1 1\n2 1\n3 1\n")) ==
        "the view u is left out: it has 3 entries for 4 nodes of triangles");
  CHECK(why(section("NodeData", "u", 1, 4, "1 1\n2 1\n3 1\n9 1\n")) ==
        "the view u is left out: it has no value at 1 of 4 nodes of triangles (first: node 4)");
  CHECK(why(section("ElementData", "u", 1, 1, "11 1\n")) == "the view u is left out: it has 1 entries for 2 triangles");
  CHECK(why(section("ElementData", "u", 1, 2, "11 1\n77 1\n")) ==
        "the view u is left out: it has no values on 1 of 2 triangles (first: element 12)");
  CHECK(why(section("ElementData", "u", 1, 2, "11 1\n11 1\n")) ==
        "the view u is left out: element 11 has values twice");
  CHECK(why(section("NodeData", "u", 1, 4, "1 1\n2 1\n3 1\n4 1\n", 0, "0", "\"s\"\n\"\"\n")) ==
        "the view u is left out: the file has no interpolation scheme s");
  const auto scheme = [](const std::string& text) {
    return "$InterpolationScheme\n\"s\"\n" + text + "$EndInterpolationScheme\n";
  };
  const std::string data = section("ElementNodeData", "u", 1, 2, "11 1 1\n12 1 1\n", 0, "0", "\"s\"\n\"\"\n");
  CHECK(why(scheme("1\n3\n2\n1 1\n1\n1 2\n0 0\n") + data) == "");
  CHECK(why(scheme("1\n4\n2\n1 1\n1\n1 2\n0 0\n") + data) ==
        "the view u is left out: its interpolation scheme says nothing of triangles (at element 11)");
  for (const char* exponents : {"1 1", "0 0.5", "0 -1", "1e300 1e300"})
    CHECK(
        why(scheme(std::string("1\n3\n2\n1 1\n1\n1 2\n") + exponents + "\n") + data) ==
        "the view u is left out: its interpolation scheme has other functions than polynomials of the mesh's degree 1 "
        "(at element 11)");
  CHECK(why(scheme("1\n3\n2\n2 1\n1\n1\n1 2\n0 0\n") + data) ==
        "the view u is left out: an element has 1 values, and its interpolation scheme 2 (at element 11)");
  CHECK(why(scheme("1\n3\n2\n1 1\n1e301\n1 2\n0 0\n") + data) ==
        "the view u is left out: its values overflow at element 11");
}

TEST_CASE("views of triangles of several orders are raised with them", "[msh]") {
  // 2 x y at the nodes of a quadratic triangle and of a linear one beside it, where it is linear along the common edge.
  const std::string mixed =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n7\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 2 0 0\n5 2 2 0\n6 0 2 0\n"
      "7 4 4 0\n$EndNodes\n$Elements\n2\n11 9 2 7 1 1 2 3 4 5 6\n12 2 2 7 1 2 7 3\n$EndElements\n";
  const MshImport nodal = read_msh(mixed + section("NodeData", "u", 1, 7, "1 0\n2 4\n3 8\n4 2\n5 6\n6 4\n7 12\n") +
                                   section("ElementNodeData", "w", 1, 2, "11 6 0 4 8 2 6 4\n12 3 4 12 8\n"));
  REQUIRE(nodal.mesh.fields.size() == 2);
  CHECK(check_arrays(nodal.mesh).empty());
  // x + 2 y, at all control points.
  for (const Field& field : nodal.mesh.fields)
    for (std::size_t p = 0; p < nodal.mesh.points.size(); ++p)
      CHECK(field.values[p] == Approx(nodal.mesh.points[p].x + 2 * nodal.mesh.points[p].y).margin(1e-12));
}

TEST_CASE("a turned triangle keeps its values where they are", "[msh]") {
  std::string clockwise = quadratic;
  clockwise.replace(clockwise.find("1 2 3 4 5 6\n$"), 11, "1 3 2 6 5 4");
  const std::string data = section("ElementNodeData", "u", 1, 1, "11 6 0 8 4 4 6 2\n");
  for (const bool orient : {false, true}) {
    const MshImport import = read_msh(clockwise + data, {orient});
    REQUIRE(import.mesh.fields.size() == 1);
    for (std::size_t p = 0; p < 6; ++p)
      CHECK(import.mesh.fields[0].values[p] == import.mesh.points[p].x + 2 * import.mesh.points[p].y);
  }
}

TEST_CASE("bad sections with values are refused with the line", "[msh]") {
  const auto why = [](const std::string& data) { return samples::complaint(linear + data); };
  const std::string good = section("NodeData", "u", 1, 4, "1 1\n2 1\n3 1\n4 1\n");
  REQUIRE(why(good) == "none");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    REQUIRE(text.find(from) != std::string::npos);
    return why(text.replace(text.find(from), from.size(), to));
  };
  CHECK(with("\n1 1\n", "\n1 nan\n") == "line 27: $NodeData, node 1: expected finite values up to 1e300");
  CHECK(with("\n1 1\n", "\n1 -inf\n") == "line 27: $NodeData, node 1: expected finite values up to 1e300");
  CHECK(with("\n1 1\n", "\n1 1e301\n") == "line 27: $NodeData, node 1: expected finite values up to 1e300");
  CHECK(with("\n1 1\n", "\n1 one\n") == "line 27: expected a value (a number), found 'one'");
  CHECK(with("\n1 1\n", "\n8 1\n") == "line 27: there is no node of tag 8");
  CHECK(with("\n1 1\n", "\n-1 1\n") == "line 27: a node's tag -1 is negative");
  CHECK(with("4 1\n$", "$") == "line 30: expected a node's tag (an integer), found '$EndNodeData'");
  CHECK(with("4 1\n$", "4 1\n4 1\n$") == "line 31: expected $EndNodeData behind 4 entries, found '4'");
  CHECK(with("\n1\n4\n0\n", "\n0\n4\n0\n") == "line 24: expected 1 to 9 components, found 0");
  CHECK(with("\n1\n4\n0\n", "\n10\n4\n0\n") == "line 24: expected 1 to 9 components, found 10");
  CHECK(with("\n1\n4\n0\n", "\n1\n-4\n0\n") == "line 25: expected the number of entries, found -4");
  CHECK(with("\n1\n4\n0\n", "\n1\n2000000000\n0\n").substr(0, 60) ==
        "line 27: the file ends too early: 2000000000 entries take at");
  CHECK(with("\"u\"", "u") == "line 19: expected a name in double quotes");
  CHECK(with("\n1\n0\n4\n", "\n1\nnan\n4\n") == "line 21: the time of the values is not finite");
  CHECK(with("$NodeData\n1\n", "$NodeData\n101\n") ==
        "line 18: expected the number of string tags, at most 100, found 101");
  CHECK(with("$EndNodeData\n", "") == "line 17: the section $NodeData does not end: there is no $EndNodeData");
  CHECK(why(section("ElementNodeData", "u", 1, 2, "11 0\n12 3 1 1 1\n")) ==
        "line 27: expected an element's number of nodes, found 0");
  CHECK(why("$InterpolationScheme\n\"s\"\n1\n3\n2\n1 1\n1\n2 2\n0 0\n0 0\n$EndInterpolationScheme\n") ==
        "line 23: expected 1 rows of 2 or 3 exponents, found a matrix of 2 x 2");
  CHECK(why("$InterpolationScheme\n\"s\"\n1\n3\n2\n1 1\nnan\n") == "line 23: expected a finite number of a matrix");
  CHECK(why("$InterpolationScheme\n\"s\"\n1\n3\n2\n9999 9999\n1\n").substr(0, 33) ==
        "line 22: the file ends too early:");
  // In a binary file the place is the byte.
  MeshData mesh = samples::disk(2, 3);
  mesh.fields.push_back({"u", 1, false, std::vector<double>(mesh.points.size(), 1), {}, {}});
  std::string bytes;
  write_msh(mesh, {MshWriteOptions::Version::v4_1, true}, bytes);
  const std::size_t data = bytes.find("$NodeData\n");
  CHECK(samples::complaint(bytes.substr(0, data + 100)).substr(0, 5) == "byte ");
  std::string nan = bytes;
  const std::size_t end = nan.find("\n$EndNodeData");
  nan.replace(end - 8, 8, std::string(8, '\xff'));
  CHECK(samples::complaint(nan).find(": expected finite values up to 1e300") != std::string::npos);
}
