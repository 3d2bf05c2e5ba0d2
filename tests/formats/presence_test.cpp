// tests/formats/presence_test.cpp: which names of members count as misspelt.
#include "formats/document/presence.h"

#include <catch2/catch.hpp>

#include "formats/document/mesh_document.h"

using namespace pliant;

TEST_CASE("a name that is written in another style, or with a typing error, is a misspelling", "[formats]") {
  for (const auto& [name, member] :
       std::initializer_list<std::pair<const char*, const char*>>{{"maxArea", "max_area"},
                                                                  {"max-area", "max_area"},
                                                                  {"MAX_AREA", "max_area"},
                                                                  {"max_arae", "max_area"},
                                                                  {"maxarea", "max_area"},
                                                                  {"field", "fields"},
                                                                  {"edn", "end"},
                                                                  {"End", "end"},
                                                                  {"tiem", "time"},
                                                                  {"thing", "thin"},
                                                                  {"critria", "criteria"},
                                                                  {"removal_errors", "removal_error"}})
    CHECK(is_misspelling(name, member));
}

TEST_CASE("a word of its own is no misspelling", "[formats]") {
  for (const auto& [name, member] : std::initializer_list<std::pair<const char*, const char*>>{{"and", "end"},
                                                                                               {"ends_at", "end"},
                                                                                               {"name", "time"},
                                                                                               {"state", "start"},
                                                                                               {"height", "right"},
                                                                                               {"weight", "right"},
                                                                                               {"area", "max_area"},
                                                                                               {"unit", "time"},
                                                                                               {"time", "time"},
                                                                                               {"", "end"}})
    CHECK_FALSE(is_misspelling(name, member));
}

TEST_CASE("doubts of one kind are counted, and their number is bounded", "[formats]") {
  std::string text = R"({"format": "pliant-boundary", "version": 1, "vertices": [], "curves": [], "faces": [)";
  for (int i = 0; i < 5; ++i) text += std::string(i > 0 ? "," : "") + R"({"name": "a", "nam": "b"})";
  ReaderNotes notes;
  read_boundary(text + R"(], "Cusps": 1, "cusp": 2, "other": 3})", &notes);
  REQUIRE(notes.doubts.size() == 2);  // a face has no optional members
  CHECK(notes.doubts[0].pointer == "/Cusps");
  CHECK(notes.doubts[1].pointer == "/cusp");
  CHECK(notes.doubts[1].more == 0);
  text = R"({"format": "pliant-mesh", "version": 1, "degree": 1, "points": [], "triangles": [], "triangle_faces": [],
    "constrained_edges": [], "boundary": {"vertices": [], "curves": [], "faces": []}, "criteria": {"a": 0)";
  for (int i = 0; i < 1000; ++i) text += ", \"a/" + std::to_string(i) + "\": 0";
  read_mesh(text + "}}", &notes);
  REQUIRE(notes.doubts.size() == 20);
  CHECK(notes.doubts[0].pointer == "/criteria/a");
  CHECK(notes.doubts[1].pointer == "/criteria/a~10");
  CHECK(notes.doubts.back().more == 981);
}
