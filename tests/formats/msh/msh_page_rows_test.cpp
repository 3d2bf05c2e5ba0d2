// tests/formats/msh/msh_page_rows_test.cpp: each row of the tables of formats/msh.md has a case here.
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "formats/msh/msh.h"
#include "formats/msh/msh_writer.h"
#include "support/document_texts.h"
#include "support/sample_meshes.h"
#include "tests/formats/page_rows.h"

using namespace pliant;

namespace {

/// Faces, curves, points, then the warnings, or the error.
std::string read_mesh_file(const std::string& bytes) {
  try {
    const MshImport import = read_msh(bytes);
    std::string out;
    for (const Face& face : import.mesh.boundary.faces) out += (out.empty() ? "" : ", ") + face.name;
    for (const Curve& curve : import.mesh.boundary.curves) out += "; " + curve.name;
    out += ":";
    for (const Point& p : import.mesh.points) out += " " + number(p.x) + " " + number(p.y);
    if (!import.mesh.fields.empty()) out += "; time " + number(import.mesh.time);
    for (const Field& field : import.mesh.fields) {
      out += "; " + field.name + " " + std::to_string(field.components) + ":";
      for (const double value : field.values) out += " " + number(value);
    }
    out += "\n";
    for (const std::string& text : import.warnings) out += text + "\n";
    return out;
  } catch (const InputError& e) {
    return (e.pointer().empty() ? "" : e.pointer() + ": ") + e.what();
  }
}

const std::string head_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", head_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
                  head_40 = "$MeshFormat\n4 0 8\n$EndMeshFormat\n",
                  nodes_2 = "$Nodes\n3\n1 0 0 5\n2 4 0 5\n3 0 4 5\n$EndNodes\n",
                  elements_2 = "$Elements\n2\n1 1 2 9 8 1 2\n2 2 2 7 6 1 2 3\n$EndElements\n",
                  nodes_4 = "$Nodes\n1 3 1 3\n2 6 0 3\n1\n2\n3\n0 0 5\n4 0 5\n0 4 5\n$EndNodes\n",
                  elements_4 = "$Elements\n1 1 1 1\n2 6 2 1\n1 1 2 3\n$EndElements\n";

std::vector<Case> mesh_file_cases() {
  const std::string entities = "`$Entities`, `$PartitionedEntities`", old = "`$NOD` or `$NOE`, `$ELM`",
                    dull = "`$Periodic`, `$GhostElements`, `$Parametrizations`, `$Comments`",
                    other = "any other, such as `$NodeStates`", views = "`$NodeData`, `$ElementNodeData`",
                    named = "`$PhysicalNames`", parametric = "`$ParametricNodes`", triangle = ": 0 0 4 0 0 4\n";
  std::vector<Case> cases = {
      {"`$MeshFormat`", head_2 + nodes_2 + elements_2, triangle},
      {"`$MeshFormat`", nodes_2 + head_2 + elements_2, "line 1: expected $MeshFormat before $Nodes"},
      {named, head_2 + "$PhysicalNames\n2\n2 7 \"cell\"\n1 9 \"r\xe4nd\"\n$EndPhysicalNames\n" + nodes_2 + elements_2,
       "cell; r\xc3\xa4nd"},
      {entities, head_4 + "$Entities\n0 0 1 0\n6 0 0 0 4 4 0 1 7 0\n$EndEntities\n" + nodes_4 + elements_4,
       "physical surface 7"},
      {entities,
       head_40 + "$Entities\n0 0 1 0\n6 0 0 0 4 4 0 1 7 0\n$EndEntities\n" +
           "$Nodes\n1 3\n6 2 0 3\n1 0 0 5\n2 4 0 5\n3 0 4 5\n$EndNodes\n$Elements\n1 1\n6 2 2 1\n1 1 2 "
           "3\n$EndElements\n",
       "physical surface 7"},
      {entities,
       head_4 + "$PartitionedEntities\n1\n0\n0 0 1 0\n6 2 3 1 1 0 0 0 4 4 0 0 0\n$EndPartitionedEntities\n" + nodes_4 +
           elements_4,
       "surface 3"},
      {"`$Nodes`", head_4 + nodes_4 + elements_4, triangle},
      {"`$Nodes`", head_2 + samples::edited(nodes_2, "0 4 5", "0 4 5.1") + elements_2, "node 3: has z = 5.1"},
      {parametric,
       head_2 + "$ParametricNodes\n3\n1 0 0 5 0 1\n2 4 0 5 1 2 0.5\n3 0 4 5 2 3 0.5 0.5\n$EndParametricNodes\n" +
           elements_2,
       triangle},
      {"`$Elements`", head_2 + nodes_2 + elements_2,
       "physical surface 7; physical curve 9; boundary of physical surface 7"},
      {old, "$NOD\n3\n1 0 0 5\n2 4 0 5 1 7 0.5\n3 0 4 5\n$ENDNOD\n$ELM\n1\n1 2 7 6 3 1 2 3\n$ENDELM\n", triangle},
      {old, "$NOE\n3\n1 0 0 5\n2 4 0 5\n3 0 4 5\n$ENDNOE\n$ELM\n1\n1 2 7 6 3 1 2 3\n$ENDELM\n", triangle},
      {views,
       head_2 + nodes_2 + elements_2 +
           "$NodeData\n1\n\"u\"\n1\n2.5\n3\n0\n1\n3\n1 7\n2 8\n3 9\n$EndNodeData\n$ElementNodeData\n1\n\"v\"\n"
           "0\n3\n0\n1\n1\n2 3 7 8 9\n$EndElementNodeData\n",
       "time 2.5; u 1: 7 8 9; v 1: 7 8 9\n"},
      {"`$ElementData`",
       head_4 + nodes_4 + elements_4 + "$ElementData\n1\n\"w\"\n0\n3\n0\n1\n1\n1 4\n$EndElementData\n", "w 1: 4 4 4\n"},
      // Values are those at the corners in reverse.
      {"`$InterpolationScheme`",
       head_2 +
           "$InterpolationScheme\n\"s\"\n1\n3\n2\n3 3\n0 1 0\n0 0 1\n1 -1 -1\n3 2\n0 0\n0 1\n1 "
           "0\n$EndInterpolationScheme\n" +
           nodes_2 + elements_2 + "$ElementNodeData\n2\n\"v\"\n\"s\"\n0\n3\n0\n1\n1\n2 3 7 8 9\n$EndElementNodeData\n",
       "v 1: 9 8 7\n"},
      {other, head_2 + "$NodeStates\n1\n$EndNodeStates\n" + nodes_2 + elements_2, "not read: $NodeStates"},
      {other, "$Any\n$EndAny\n" + head_2 + nodes_2 + "$Other\n$EndOther\n" + elements_2, "not read: $Any, $Other"},
  };
  for (const char* section : {"Periodic", "GhostElements", "Parametrizations", "Comments"})
    cases.push_back({dull, head_2 + nodes_2 + elements_2 + "$" + section + "\n1\n$End" + section + "\n", triangle});
  return cases;
}

/// What export-msh makes of two triangles of two faces with a line between them.
std::vector<Case> written_cases() {
  const std::string two =
      head_2 + "$PhysicalNames\n2\n2 7 \"left\"\n2 9 \"right\"\n$EndPhysicalNames\n" +
      "$Nodes\n4\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 4 4 0\n$EndNodes\n$Elements\n2\n1 2 2 7 1 1 2 3\n2 2 2 9 2 2 4 3\n"
      "$EndElements\n";
  const std::string u = "$NodeData\n1\n\"u\"\n1\n2.5\n3\n0\n1\n4\n1 7\n2 8\n3 9\n4 6\n$EndNodeData\n";
  const std::string v = "$ElementData\n1\n\"v\"\n1\n0.5\n3\n0\n1\n2\n1 1\n2 2\n$EndElementData\n";
  return {{"point k", two, "$Nodes\n4\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 4 4 0\n"},
          {"triangle t", two, "\n1 2 2 1 1 1 2 3\n2 2 2 2 2 2 4 3\n"},
          {"constrained edge e", two, "$Elements\n7\n"},
          {"face f", two, "2 1 \"left\"\n2 2 \"right\"\n"},
          {"curve c", two, "1 1 \"left | right\"\n1 2 \"boundary of left\"\n"},
          {"vertex where open curves end", two, "$Entities\n2 3 2 0\n"},
          {"continuous field", two + u, "$NodeData\n1\n\"u\"\n1\n2.5\n3\n0\n1\n4\n1 7\n2 8\n3 9\n4 6\n$EndNodeData\n"},
          {"field by face", two + v,
           "$ElementNodeData\n3\n\"v\"\n\"\"\n\"by_face\"\n1\n0.5\n3\n0\n1\n2\n1 3 1 1 1\n2 3 2 2 "
           "2\n$EndElementNodeData\n"},
          {"time", two + u, "$NodeData\n1\n\"u\"\n1\n2.5\n"}};
}

}  // namespace

TEST_CASE("what each row of msh.md says is so", "[msh][pages]") {
  for (const Case& c : mesh_file_cases()) {
    CAPTURE(c.row, c.input);
    CHECK_THAT(read_mesh_file(c.input), Catch::Contains(c.expected));
  }
  for (const Case& c : written_cases()) {
    CAPTURE(c.row);
    std::string text;
    for (const auto version : {MshWriteOptions::Version::v2_2, MshWriteOptions::Version::v4_1})
      write_msh(read_msh(c.input).mesh, {version, false}, text);
    CHECK_THAT(text, Catch::Contains(c.expected));
  }
}

TEST_CASE("every row of msh.md has a case", "[msh][pages]") {
  std::vector<Case> cases = mesh_file_cases();
  for (Case& c : written_cases()) cases.push_back(std::move(c));
  for (const char* family : {"triangle", "line"}) cases.push_back({family, "", ""});  // the next test
  CHECK(rows_of("msh.md") == rows_with_a_case(cases));
}

TEST_CASE("the element types of msh.md are those that are written and read", "[msh][pages]") {
  std::ifstream in(std::string(PLIANT_FORMAT_PAGES) + "/msh.md");
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("| triangle |") || line.starts_with("| line |")) {
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string word; cells >> word;)
        if (word != "|") rows.back().push_back(word);
    }
  REQUIRE(rows.size() == 2);
  for (const auto& row : rows) {
    REQUIRE(row.size() == 11);
    for (std::size_t order = 1; order <= 10; ++order) {
      std::string text;
      write_msh(samples::disk(static_cast<int>(order), std::max(8, static_cast<int>(order))),
                {MshWriteOptions::Version::v4_1, false}, text);
      CAPTURE(row.front(), order);
      std::istringstream elements(text.substr(text.find("$Elements\n")));
      std::set<std::string> types;
      for (std::string line; std::getline(elements, line);) {  // "dimension tag type count" opens a block
        std::istringstream words(line);
        std::vector<std::string> found;
        for (std::string word; words >> word;) found.push_back(word);
        if (found.size() == 4 && found[0] == (row.front() == "line" ? "1" : "2")) types.insert(found[2]);
      }
      CHECK(types.count(row[order]) == 1);
      CHECK(read_msh(text).mesh.degree == static_cast<int>(order));
    }
  }
}
