// tests/formats/mesh_document_test.cpp: the mesh document is lossless, strict, and says where it is wrong.
#include "formats/document/mesh_document.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "formats/document/read_json.h"
#include "pliant/mesh/check_mesh.h"
#include "support/carried_members.h"
#include "support/document_texts.h"
#include "support/sample_meshes.h"
#include "support/triangles.h"

using namespace pliant;
using samples::edited, samples::text_of;

namespace {

/// A mesh that has one of everything.
MeshData rich_mesh(int degree) {
  MeshData data = samples::three_disks(degree);
  data.time = 0.1 + 0.2;
  samples::add_field(data, "concentration", 1, [](const Point& p) { return std::vector<double>{p.x / 3}; });
  samples::add_field(data, "velo\"city\n", 2, [](const Point& p) { return std::vector<double>{-p.y, p.x}; });
  Field pressure;
  pressure.name = "pressure";
  pressure.by_face = true;
  std::vector<std::array<std::int32_t, 2>> places;
  const auto net = static_cast<std::size_t>(net_size(degree));
  for (std::size_t i = 0; i < data.triangles.size(); ++i)
    places.push_back({data.triangles[i], data.triangle_faces[i / net]});
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const auto& [point, face] : places) pressure.values.push_back(point * 1e-300 - face);
  pressure.places = places;
  pressure.extra = samples::carried({{"unit", "\"Pa\""}});
  data.fields.push_back(pressure);
  data.criteria.min_angle = 25;
  data.criteria.max_area = 0.1;
  data.criteria.face_area = {{"upper", 0.05}, {"a=b", 1e-3}};
  data.criteria.size = "0.1 + abs(x)";
  data.criteria.size_field = "wanted";
  data.criteria.max_turning = 45;
  data.criteria.accuracy = 1e-5;
  data.criteria.min_size = 1e-6;
  data.criteria.extra = samples::carried({{"later", "{\"a\":[1,2.50]}"}});
  data.boundary.extra = samples::carried({{"made_by", "null"}});
  data.boundary.faces[1].extra = samples::carried({{"color", "\"#ff0000\""}});
  data.boundary.curves[2].extra = samples::carried({{"tension", "1.0e+1"}});
  data.boundary.curves[0].removal_error = 1.25e-7;
  data.extra = samples::carried({{"step", "17"}, {"od/d~name", "[true,false]"}, {"", "{}"}});
  return data;
}

/// Two triangles, one cell, small enough to read.
const std::string& small_document() {
  static const std::string text =
      R"({"format":"pliant-mesh","version":1,"degree":1,"time":0.5,"points":[0,0,1,0,1,1,0,1],)"
      R"("triangles":[0,1,2,0,2,3],"triangle_faces":[0,0],"constrained_edges":[)"
      R"({"curve":0,"span":0,"points":[0,1]},{"curve":0,"span":1,"points":[1,2]},)"
      R"({"curve":0,"span":2,"points":[2,3]},{"curve":0,"span":3,"points":[3,0]}],)"
      R"("fields":[{"name":"u","components":1,"by_face":false,"values":[0,1,2,3]}],)"
      R"("boundary":{"vertices":[],"faces":[{"name":"square"}],"curves":[{"name":"edge","degree":1,"closed":true,)"
      R"("knots":[0,1,2,3,4],"points":[1,0,1,1,0,1,0,0],"start":null,"end":null,"left":0,"right":null,)"
      R"("removal_error":0}],"cusps":[]},"criteria":{"max_area":2}})"
      "\n";
  return text;
}

std::string fault_place(const std::string& text) {
  return samples::fault_place([&] { read_mesh(text); });
}

}  // namespace

TEST_CASE("a mesh that is written, read and written again is the same, byte for byte", "[formats]") {
  const int degree = GENERATE(range(1, 6));
  const std::string first = text_of(rich_mesh(degree));
  CHECK(std::count(first.begin(), first.end(), '\n') == 1);
  CHECK(first.back() == '\n');
  const MeshData data = read_mesh(first);
  CHECK(text_of(data) == first);
  CHECK(check_structure(data).size() == check_structure(rich_mesh(degree)).size());
}

TEST_CASE("the members of a mesh have one order", "[formats]") {
  CHECK(text_of(read_mesh(small_document())) == small_document());
}

TEST_CASE("what is read is what was written", "[formats]") {
  const MeshData a = rich_mesh(3);
  const MeshData b = read_mesh(text_of(a));
  CHECK(a.degree == b.degree);
  CHECK(a.time == b.time);
  CHECK(a.points == b.points);
  CHECK(a.triangles == b.triangles);
  CHECK(a.triangle_faces == b.triangle_faces);
  CHECK(samples::texts_of(a.extra) == samples::texts_of(b.extra));
  REQUIRE(a.constrained_edges.size() == b.constrained_edges.size());
  for (std::size_t i = 0; i < a.constrained_edges.size(); ++i) {
    CHECK(a.constrained_edges[i].curve == b.constrained_edges[i].curve);
    CHECK(a.constrained_edges[i].span == b.constrained_edges[i].span);
    CHECK(a.constrained_edges[i].points == b.constrained_edges[i].points);
  }
  REQUIRE(a.fields.size() == b.fields.size());
  for (std::size_t i = 0; i < a.fields.size(); ++i) {
    CHECK(a.fields[i].name == b.fields[i].name);
    CHECK(a.fields[i].components == b.fields[i].components);
    CHECK(a.fields[i].by_face == b.fields[i].by_face);
    CHECK(a.fields[i].values == b.fields[i].values);
    CHECK(a.fields[i].places == b.fields[i].places);
    CHECK(samples::texts_of(a.fields[i].extra) == samples::texts_of(b.fields[i].extra));
  }
  CHECK(a.criteria.min_angle == b.criteria.min_angle);
  CHECK(a.criteria.max_area == b.criteria.max_area);
  CHECK(a.criteria.face_area == b.criteria.face_area);
  CHECK(a.criteria.size == b.criteria.size);
  CHECK(a.criteria.size_field == b.criteria.size_field);
  CHECK(a.criteria.max_turning == b.criteria.max_turning);
  CHECK(a.criteria.accuracy == b.criteria.accuracy);
  CHECK(a.criteria.min_size == b.criteria.min_size);
  CHECK(samples::texts_of(a.criteria.extra) == samples::texts_of(b.criteria.extra));
}

TEST_CASE("white space, the order of members and members left out do not matter", "[formats]") {
  std::string spaced;
  for (const char c : small_document()) {
    spaced += c;
    if (c == ',' || c == '{' || c == '[' || c == ':') spaced += "\r\n \t";
  }
  CHECK(text_of(read_mesh(spaced)) == small_document());

  const std::string head = R"("format":"pliant-mesh","version":1,"degree":1,)";
  std::string turned = edited(small_document(), head, "");
  turned.resize(turned.size() - 2);
  CHECK(text_of(read_mesh(turned + "," + head.substr(0, head.size() - 1) + "}")) == small_document());

  std::string brief = edited(small_document(), R"("components":1,"by_face":false,)", "");
  brief = edited(brief, R"(,"start":null,"end":null)", "");
  brief = edited(brief, R"(,"right":null,"removal_error":0)", "");
  brief = edited(brief, R"(,"cusps":[])", "");
  CHECK(text_of(read_mesh(brief)) == small_document());
  const std::string bare = edited(edited(brief, R"(,"criteria":{"max_area":2})", ""), R"("time":0.5,)", "");
  CHECK(read_mesh(bare).time == 0);
  CHECK_FALSE(read_mesh(bare).criteria.max_area.has_value());
}

TEST_CASE("unknown members are kept, behind the known ones, without their white space", "[formats]") {
  const std::string text = edited(small_document(), R"("degree":1)", "\"new\": { \"a b\" : [ 1.0 ] },\n\"degree\":1");
  const MeshData data = read_mesh(text);
  REQUIRE(data.extra.size() == 1);
  CHECK(data.extra[0].first == "new");
  CHECK(write_value(*data.extra[0].second) == R"({"a b":[1]})");
  CHECK(text_of(data).ends_with(R"("criteria":{"max_area":2},"new":{"a b":[1]}})"
                                "\n"));
}

TEST_CASE("the numbers of unknown members are rewritten once, and then stay as they are", "[formats]") {
  const auto [given, kept] = GENERATE(table<std::string, std::string>({
      {"0", "0"},
      {"-0", "-0.0"},
      {"-0.0", "-0.0"},
      {"1.0", "1"},
      {"0.1000", "0.1"},
      {"1.0e+1", "10"},
      {"1e5", "1e+05"},
      {"100000", "100000"},
      {"9007199254740993", "9007199254740993"},          // 2^53 + 1 is no double
      {"-9223372036854775808", "-9223372036854775808"},  // the least integer that 64 bits hold
      {"18446744073709551615", "18446744073709551615"},  // the greatest
      {"18446744073709551616", "18446744073709551616"},  // 64 bits do not hold it: it becomes a double
      {"18446744073709551617", "18446744073709551616"},  // no double: the nearest one is 2^64
      {"-9223372036854775809", "-9223372036854775808"},
      {"12345678901234567890.0", "12345678901234567168"},  // a double that is written as an integer
      {"0.1234567890123456789", "0.12345678901234568"},
      {"5e-324", "5e-324"},
      {"1e-400", "0"},
      {"1.7976931348623157e308", "1.7976931348623157e+308"},
  }));
  CAPTURE(given);
  const std::string text = edited(small_document(), R"("degree":1)", "\"new\":[{\"n\":" + given + "}],\"degree\":1");
  const std::string first = text_of(read_mesh(text));
  CHECK(first.ends_with(",\"new\":[{\"n\":" + kept + "}]}\n"));
  CHECK(text_of(read_mesh(first)) == first);
  CHECK(text_of(read_mesh(text_of(Mesh(read_mesh(first)).to_data()))) == first);
}

TEST_CASE("unknown members keep their order and their strings, at any length and depth that is read", "[formats]") {
  const auto kept = [](const std::string& value) {
    const std::string first =
        text_of(read_mesh(edited(small_document(), R"("degree":1)", "\"new\":" + value + ",\"degree\":1")));
    CHECK(text_of(read_mesh(first)) == first);
    const std::size_t from = first.find(",\"new\":") + 7;
    return first.substr(from, first.size() - from - 2);
  };
  CHECK(kept(R"({"z":1,"a":{"y":[],"b":null},"":true,"\u00e9":"\ud83d\ude00\/\u0000"})") ==
        "{\"z\":1,\"a\":{\"y\":[],\"b\":null},\"\":true,\"é\":\"😀/\\u0000\"}");
  std::string wide = "{", deep(60, '[');
  for (int i = 0; i < 200000; ++i) wide += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":\"\"";
  wide += "}";
  deep += std::string(60, ']');
  // CHECK would print these long texts if it compared them.
  const bool same_wide = kept(wide) == wide, same_deep = kept(deep) == deep;
  CHECK(same_wide);
  CHECK(same_deep);
}

TEST_CASE("a number of an unknown member that no double holds is a fault with its place", "[formats]") {
  for (const char* number : {"1e400", "-1e309", "1e99999999999"}) {
    const std::string text =
        edited(small_document(), R"("degree":1)", "\"new\":{\"a\":[0," + std::string(number) + "]},\"degree\":1");
    CHECK(fault_place(text) == "/new/a/1");
  }
}

TEST_CASE("each fault of a mesh document is named by its place", "[formats]") {
  struct Case {
    const char *from, *to, *place;
  };
  const std::vector<Case> cases = {
      {"pliant-mesh", "pliant-boundary", "/format"},
      {"\"version\":1", "\"version\":2", "/version"},
      {"\"version\":1", "\"version\":\"1\"", "/version"},
      {"\"version\":1,", "", ""},
      {"\"degree\":1,\"t", "\"degree\":0,\"t", "/degree"},
      {"\"degree\":1,\"t", "\"degree\":11,\"t", "/degree"},
      {"\"degree\":1,\"t", "\"degree\":1.5,\"t", "/degree"},
      {"\"degree\":1,\"t", "\"t", ""},
      {"\"time\":0.5", "\"time\":null", "/time"},
      {"\"time\":0.5", "\"time\":1e999", "/time"},
      {"\"points\":[0,0,1,0,", "\"points\":[0,0,1,", "/points"},
      {"\"points\":[0,0,1,0,", "\"points\":[0,0,NaN,0,", "/points/2"},
      {"\"points\":[0,0,1,0,", "\"points\":[0,0,[1,0],", "/points/2"},
      {"\"points\":[0,0,1,0,", "\"points\":[0,0,\"1\",0,", "/points/2"},
      {"\"triangles\":[0,1,2,", "\"triangles\":[0,1,4,", "/triangles/2"},
      {"\"triangles\":[0,1,2,", "\"triangles\":[0,1,-1,", "/triangles/2"},
      {"\"triangles\":[0,1,2,", "\"triangles\":[0,1,0.5,", "/triangles/2"},
      {"\"triangles\":[0,1,2,", "\"triangles\":[0,1,99999999999,", "/triangles/2"},
      {"\"triangles\":[0,1,2,", "\"triangles\":[0,1,", "/triangles"},
      {"\"triangle_faces\":[0,0]", "\"triangle_faces\":[0]", "/triangle_faces"},
      {"\"triangle_faces\":[0,0]", "\"triangle_faces\":[0,1]", "/triangle_faces/1"},
      {"\"triangle_faces\":[0,0]", "\"triangle_faces\":{}", "/triangle_faces"},
      {"\"span\":1,", "", "/constrained_edges/1"},
      {"\"span\":1,", "\"span\":1,\"mark\":3,", "/constrained_edges/1/mark"},
      {"\"curve\":0,\"span\":1", "\"curve\":1,\"span\":1", "/constrained_edges/1/curve"},
      {"\"points\":[1,2]", "\"points\":[1,7]", "/constrained_edges/1/points/1"},
      {"\"values\":[0,1,2,3]", "\"values\":[0,1,2]", "/fields/0/values"},
      {"\"values\":[0,1,2,3]", "\"values\":[0,1,2,3", "/fields/0/values/4"},
      {"\"values\":[0,1,2,3]", "\"values\":[0,1,2,true]", "/fields/0/values/3"},
      {"\"components\":1", "\"components\":0", "/fields/0/components"},
      {"\"by_face\":false", "\"by_face\":true", "/fields/0"},
      {"\"by_face\":false", "\"by_face\":0", "/fields/0/by_face"},
      {"\"by_face\":false", "\"by_face\":false,\"places\":[0,0]", "/fields/0"},
      {"\"name\":\"u\",", "", "/fields/0"},
      {"{\"max_area\":2}", "{\"max_area\":0}", "/criteria/max_area"},
      {"{\"max_area\":2}", "{\"min_angle\":60}", "/criteria/min_angle"},
      {"{\"max_area\":2}", "{\"face_area\":{\"square\":-1}}", "/criteria/face_area/square"},
      {"{\"max_area\":2}", "{\"face_area\":{\"a/b~\":-1}}", "/criteria/face_area/a~1b~0"},
      {"{\"max_area\":2}", "{\"size\":0.1}", "/criteria/size"},
      {"\"boundary\":{", "\"boundary\":{\"format\":\"x\",", "/boundary/format"},
      {"\"knots\":[0,1,2,3,4]", "\"knots\":[0,1,2,3]", "/boundary/curves/0"},
      {"\"left\":0", "\"left\":1", "/boundary/curves/0/left"},
      {"\"time\":0.5", "\"time\":0.5,\"time\":0.5", ""},
      {"\"time\":0.5", "\"time\":0.5,\"x\":{\"y\":[tru]}", "/x/y/0"},
      {"\"time\":0.5,", "\"time\":0.5,,", ""},
      {"}}\n", "}}}\n", ""},
      {"}}\n", "}", ""},
      {"}}\n", "}} {}", ""},
  };
  for (const Case& c : cases) {
    CAPTURE(c.from, c.to);
    CHECK(fault_place(edited(small_document(), c.from, c.to)) == c.place);
  }
  CHECK(fault_place("") == "");
  CHECK(fault_place("[]") == "");
  CHECK(fault_place("\xEF\xBB\xBF" + small_document()) == "");
}

TEST_CASE("a boundary inside a mesh may carry its own format and version", "[formats]") {
  const std::string text =
      edited(small_document(), "\"boundary\":{", "\"boundary\":{\"format\":\"pliant-boundary\",\"version\":1,");
  CHECK(text_of(read_mesh(text)) == small_document());
}

TEST_CASE("a mutilated document is read or refused, and what is read is written stably", "[formats][property]") {
  const int seed = GENERATE(range(0, 20));
  CAPTURE(seed);
  samples::Random random(seed);
  const std::string whole = seed % 2 == 0 ? small_document() : text_of(rich_mesh(1 + seed % 4));
  const auto at_random = [&](std::size_t size) {
    return static_cast<std::size_t>(random.integer(0, static_cast<int>(size) - 1));
  };
  int read = 0;
  for (int round = 0; round < 500; ++round) {
    std::string text = whole;
    const int kind = random.integer(0, 4);
    if (kind == 0) text.resize(at_random(text.size()));
    for (int edits = random.integer(1, 4); kind != 0 && edits > 0; --edits) {
      const std::size_t at = at_random(text.size());
      if (kind == 1)
        text[at] = static_cast<char>(random.integer(0, 255));
      else if (kind == 2)
        text[at] = "0123456789-.eE,[]{}\":ntf"[at_random(24)];
      else if (kind == 3)
        text.erase(at, static_cast<std::size_t>(random.integer(1, 20)));
      else
        text.insert(at, whole, at_random(whole.size()), static_cast<std::size_t>(random.integer(1, 20)));
    }
    try {
      const std::string again = text_of(read_mesh(text));
      CHECK(text_of(read_mesh(again)) == again);
      ++read;
    } catch (const InputError&) {
    }
  }
  CHECK(read < 500);
}
