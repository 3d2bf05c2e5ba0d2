// tests/formats/document_place_test.cpp: a pointer leads to the line and column of its value.
#include "formats/document/document_place.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "formats/document/mesh_document.h"
#include "formats/document/read_json.h"

using namespace pliant;

namespace {

std::string at(std::string_view json, std::string_view pointer) {
  const DocumentPlace place = find_place(json, pointer);
  return std::to_string(place.line) + ":" + std::to_string(place.column);
}

constexpr std::string_view nested = R"({ "a": [1, [2.5e3, "x,]}\"{"], {"b/c": {"~": null}}],
  "points": [0, 1,
    2, 3],
  "": true })";

/// Checks for every value of a document that its pointer leads to the place where it stands.
void check_all(const std::string& json, const nlohmann::json& value, const std::string& pointer, long& count) {
  const DocumentPlace place = find_place(json, pointer);
  std::size_t start = 0;
  for (long line = 1; line < place.line; ++line) start = json.find('\n', start) + 1;
  start += static_cast<std::size_t>(place.column) - 1;
  INFO(pointer);
  const std::string token = value.is_structured() ? value.is_array() ? "[" : "{" : value.dump();
  CHECK(json.compare(start, token.size(), token) == 0);
  ++count;
  if (!value.is_structured()) return;
  std::size_t index = 0;
  for (const auto& [name, inner] : value.items())
    check_all(json, inner, pointer + "/" + (value.is_array() ? std::to_string(index++) : name), count);
}

}  // namespace

TEST_CASE("a pointer finds its value, whatever strings before it hold", "[formats]") {
  CHECK(at(nested, "") == "1:1");
  CHECK(at(nested, "/a") == "1:8");
  CHECK(at(nested, "/a/1/0") == "1:13");
  CHECK(at(nested, "/a/1/1") == "1:20");
  CHECK(at(nested, "/a/2/b~1c/~0") == "1:46");
  CHECK(at(nested, "/points/2") == "3:5");
  CHECK(at(nested, "/") == "4:7");
}

TEST_CASE("a pointer to what is not there finds what would hold it", "[formats]") {
  CHECK(at(nested, "/a/9") == "1:8");
  CHECK(at(nested, "/a/x") == "1:8");
  CHECK(at(nested, "/points/0/1") == "2:14");
  CHECK(at(nested, "/none") == "1:1");
  CHECK(at("", "/a") == "1:1");
  for (std::size_t cut = 0; cut < nested.size(); ++cut)
    for (const char* pointer : {"/a/2/b~1c/~0", "/points/3", "/", "/a/1/1"}) {
      const DocumentPlace place = find_place(nested.substr(0, cut), pointer);
      CHECK(place.line >= 1);
      CHECK(place.line <= 4);
    }
}

TEST_CASE("every value of a document is found by its pointer", "[formats]") {
  const nlohmann::json value = {{"one", {1, 2, 3, {{"x", "a\"b"}, {"y", {true, nullptr, -5}}}}},
                                {"two", {{"three", nlohmann::json::array()}, {"four", "[{,"}}}};
  for (const int indent : {-1, 0, 3}) {
    long count = 0;
    check_all(value.dump(indent), value, "", count);
    CHECK(count == 14);
  }
}

TEST_CASE("a wrong value is named by the place where it starts", "[formats]") {
  try {
    read_boundary(
        "{\"format\": \"pliant-boundary\",\n \"version\": 1, \"vertices\": [],\n \"faces\": [],\n"
        " \"curves\": [{\"name\": \"c\", \"degree\": 77}]}");
    FAIL("should be refused");
  } catch (const DocumentError& error) {
    CHECK(error.pointer() == "/curves/0/degree");
    CHECK(error.line() == 4);
    CHECK(error.column() == 37);
    CHECK_THAT(error.what(), Catch::EndsWith("(column 37)"));
  }
}
