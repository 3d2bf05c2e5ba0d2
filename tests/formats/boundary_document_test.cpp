// tests/formats/boundary_document_test.cpp: the boundary document is lossless, strict, and says where it is wrong.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "formats/document/mesh_document.h"
#include "support/carried_members.h"
#include "support/document_texts.h"
#include "support/triangles.h"

using namespace pliant;
using samples::edited, samples::text_of;

namespace {

/// A half-disk: an open arc and an open line between two vertices, and a closed hole, with a cusp for good measure.
const std::string& document() {
  static const std::string text =
      R"({"format":"pliant-boundary","version":1,"vertices":[-1,0,1,-0.0],)"
      R"("faces":[{"name":"half"},{"name":"hole","color":"red"}],"curves":[)"
      R"({"name":"line","degree":1,"closed":false,"knots":[0,0,1,1],"points":[-1,0,1,-0.0],"start":0,"end":1,)"
      R"("left":0,"right":null,"removal_error":0},)"
      R"({"name":"arc","degree":2,"closed":false,"knots":[0,0,0,0.5,1,1,1],"points":[1,-0.0,1,1,-1,1,-1,0],)"
      R"("start":1,"end":0,"left":0,"right":null,"removal_error":1e-09},)"
      R"({"name":"ring","degree":2,"closed":true,"knots":[0,1,2,3.5,4],"points":[0.1,0.3,0.1,0.5,-0.1,0.5,-0.1,0.3],)"
      R"("start":null,"end":null,"left":1,"right":0,"removal_error":0,"group":{"id":7}}],"cusps":[1],"by":"hand"})"
      "\n";
  return text;
}

std::string boundary_fault_place(const std::string& text) {
  return samples::fault_place([&] { read_boundary(text); });
}

}  // namespace

TEST_CASE("a boundary that is read and written is the same, byte for byte", "[formats]") {
  CHECK(text_of(read_boundary(document())) == document());
}

TEST_CASE("the members of a boundary document mean what the page says", "[formats]") {
  const BoundaryComplex boundary = read_boundary(document());
  REQUIRE(boundary.vertices.size() == 2);
  CHECK(std::signbit(boundary.vertices[1].y));
  REQUIRE(boundary.faces.size() == 2);
  CHECK(boundary.faces[1].name == "hole");
  REQUIRE(boundary.curves.size() == 3);
  const Curve& arc = boundary.curves[1];
  CHECK(arc.name == "arc");
  CHECK(arc.spline.degree() == 2);
  CHECK_FALSE(arc.spline.closed());
  CHECK(arc.spline.span_count() == 2);
  CHECK(arc.start == 1);
  CHECK(arc.end == 0);
  CHECK(arc.left == 0);
  CHECK(arc.right == outside);
  CHECK(arc.removal_error == 1e-9);
  const Curve& ring = boundary.curves[2];
  CHECK(ring.spline.closed());
  CHECK(ring.spline.span_count() == 4);
  CHECK(ring.start == no_vertex);
  CHECK(samples::texts_of(ring.extra) == samples::MemberTexts{{"group", "{\"id\":7}"}});
  CHECK(boundary.cusps == std::vector<int>{1});
  CHECK(samples::texts_of(boundary.extra) == samples::MemberTexts{{"by", "\"hand\""}});
}

TEST_CASE("each fault of a boundary document is named by its place", "[formats]") {
  struct Case {
    const char *from, *to, *place;
  };
  const std::vector<Case> cases = {
      {"pliant-boundary", "pliant-mesh", "/format"},
      {"\"format\":\"pliant-boundary\",", "", ""},
      {"\"version\":1,", "", ""},
      {"\"version\":1", "\"version\":1.5", "/version"},
      {"\"vertices\":[-1,0,1,-0.0]", "\"vertices\":[-1,0,1]", "/vertices"},
      {"\"vertices\":[-1,0,1,-0.0]", "\"vertices\":[[-1,0],[1,-0.0]]", "/vertices/0"},
      {"{\"name\":\"half\"}", "{}", "/faces/0"},
      {"{\"name\":\"half\"}", "\"half\"", "/faces/0"},
      {"\"name\":\"line\",", "", "/curves/0"},
      {"\"degree\":1", "\"degree\":0", "/curves/0/degree"},
      {"\"degree\":1", "\"degree\":17", "/curves/0/degree"},
      {"\"degree\":1", "\"degree\":2", "/curves/0"},
      {"\"closed\":false", "\"closed\":\"no\"", "/curves/0/closed"},
      {"\"knots\":[0,0,1,1]", "\"knots\":[0,0,1,2]", "/curves/0/knots/2"},
      {"\"knots\":[0,0,0,0.5,1,1,1]", "\"knots\":[0,0,0,1.5,1,1,1]", "/curves/1/knots/4"},
      {"\"points\":[-1,0,1,-0.0]", "\"points\":[-1,0,1]", "/curves/0/points"},
      {"\"start\":0", "\"start\":2", "/curves/0/start"},
      {"\"start\":0", "\"start\":-1", "/curves/0/start"},
      {"\"start\":0,", "", "/curves/0"},
      {"\"start\":0", "\"start\":null", "/curves/0"},
      {"\"start\":null", "\"start\":0", "/curves/2"},
      {"\"left\":1", "\"left\":2", "/curves/2/left"},
      {"\"left\":1", "\"left\":\"hole\"", "/curves/2/left"},
      {"\"removal_error\":0}", "\"removal_error\":-1}", "/curves/0/removal_error"},
      {"\"cusps\":[1]", "\"cusps\":[1,2]", "/cusps/1"},
      {"\"cusps\":[1]", "\"cusps\":[-1]", "/cusps/0"},
      {"\"by\":\"hand\"", "\"by\":hand", "/by"},
      {"\"by\":\"hand\"", "\"cusps\":[]", ""},
  };
  for (const Case& c : cases) {
    CAPTURE(c.from, c.to);
    CHECK(boundary_fault_place(edited(document(), c.from, c.to)) == c.place);
  }
}

TEST_CASE("a mutilated boundary is read or refused", "[formats][property]") {
  const int seed = GENERATE(range(0, 10));
  CAPTURE(seed);
  samples::Random random(seed);
  for (int round = 0; round < 1000; ++round) {
    std::string text = document();
    for (int edits = random.integer(1, 3); edits > 0; --edits) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
      if (random.integer(0, 1) == 0)
        text[at] = "0123456789-.eE,[]{}\":ntf"[random.integer(0, 23)];
      else
        text.erase(at, static_cast<std::size_t>(random.integer(1, 5)));
    }
    try {
      const std::string again = text_of(read_boundary(text));
      CHECK(text_of(read_boundary(again)) == again);
    } catch (const InputError&) {
    }
  }
}
