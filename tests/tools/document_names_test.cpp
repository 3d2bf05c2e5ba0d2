// tests/tools/document_names_test.cpp: names are found in documents, whole or not.
#include "completion/document_names.h"

#include <catch2/catch.hpp>

#include "completion/value_type.h"

namespace pliant {
namespace {

const std::string mesh = R"({"format": "pliant-mesh", "points": [0, 1e5, -0.0], "note": {"faces": [{"name": "no"}]},
  "fields": [{"name": "u", "values": [[1], "]", 2], "components": 2}, {"name": "\u00e9\"", "values": []}],
  "boundary": {"faces": [{"name": "a b"}, {"color": "red", "name": "c"}], "curves": [{"name": "k"}, {"name": "k"}]},
  "problem": {"parameters": {"rate": 1}}})";

TEST_CASE("names are found where documents have them, and nowhere else", "[completion]") {
  const DocumentNames found = names_in_json(mesh);
  CHECK(found.faces == std::vector<std::string>{"a b", "c"});
  CHECK(found.curves == std::vector<std::string>{"k"});
  CHECK(found.parameters == std::vector<std::string>{"rate"});
  REQUIRE(found.fields.size() == 2);
  CHECK(found.fields[0].name == "u");
  CHECK(found.fields[0].components == 2);
  CHECK(found.fields[1].name == "\u00e9\"");
}

TEST_CASE("a document that is cut, spoilt or deep gives names or none, and no harm", "[completion]") {
  for (std::size_t length = 0; length < mesh.size(); ++length)
    CHECK(names_in_json(mesh.substr(0, length)).faces.size() <= 2);
  unsigned seed = 20;
  for (int k = 0; k < 20000; ++k) {
    std::string text = mesh;
    for (int change = 0; change < 3; ++change) {
      seed = seed * 1664525U + 1013904223U;
      text[(seed >> 8) % text.size()] = "{}[]\",:\\x0"[(seed >> 3) % 10];
    }
    CHECK(names_in_json(text).faces.size() <= 8);
  }
  CHECK(names_in_json(R"({"faces": )" + std::string(1 << 20, '[')).faces.empty());
  CHECK(names_in_json(R"({"faces": [[[{"name": "a"}]], 3, {"name": 4}, {"name": "b"}]})").faces ==
        std::vector<std::string>{"b"});
}

TEST_CASE("the name of a type says what a value may be", "[completion]") {
  const auto parts = [](const std::string& name) {
    std::string text;
    for (const ValueType& type : value_types(name))
      text += "<" + type.literal + "|" + type.word + "|" + type.follows + ">";
    return text;
  };
  CHECK(parts("keep|refine") == "<keep||><refine||>");
  CHECK(parts("TEXT:{element,control}") == "<element||><control||>");
  CHECK(parts("N:INT in [1 - 100]") == "<|N|:INT>");
  CHECK(parts("FLOW[:KEY=VALUE,...]|FILE") == "<|FLOW|[:KEY=VALUE,...]><|FILE|>");
  CHECK(parts("none|field:FIELD[.COMPONENT]") == "<none||><field:|FIELD|[.COMPONENT]>");
  CHECK(parts("[NAME=]FACE:QUANTITY,...") == "<|FACE|:QUANTITY,...>");
  CHECK(parts("[FACE=]EXPR") == "<|FACE|=EXPR>");
  CHECK(parts("").empty());
}

}  // namespace
}  // namespace pliant
