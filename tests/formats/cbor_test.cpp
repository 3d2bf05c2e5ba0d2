// tests/formats/cbor_test.cpp: documents in CBOR are lossless, strict, and say where they are wrong.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "formats/document/cbor/read_cbor.h"
#include "formats/document/document_reader.h"
#include "formats/document/document_stream.h"
#include "formats/document/document_value.h"
#include "formats/document/mesh_document.h"

using namespace pliant;
using namespace std::string_literals;

namespace {

const std::string small =
    R"({"format":"pliant-mesh","version":1,"degree":1,"time":0.5,"points":[-0.0,0,1,0,1,1,0,1],)"
    R"("triangles":[0,1,2,0,2,3],"triangle_faces":[0,0],"constrained_edges":[)"
    R"({"curve":0,"span":0,"points":[0,1]},{"curve":0,"span":1,"points":[1,2]},)"
    R"({"curve":0,"span":2,"points":[2,3]},{"curve":0,"span":3,"points":[3,0]}],)"
    R"("fields":[{"name":"u","components":1,"by_face":false,"values":[0,1e-300,1,-2.5]},)"
    R"({"name":"q","components":1,"by_face":true,"values":[1,2,3,4],"places":[0,0,1,0,2,0,3,0]}],)"
    R"("boundary":{"vertices":[],"faces":[{"name":"é","color":"blue"}],"curves":[{"name":"o","degree":1,"closed":true,)"
    R"("knots":[0,1,2,3,4],"points":[0,0,1,0,1,1,0,1],"start":null,"end":null,"left":0,"right":null,)"
    R"("removal_error":0}],"cusps":[]},"criteria":{"max_area":1},)"
    R"("a":[1,-2,18446744073709551615,-9223372036854775808,1e+300,-0.0,0.1,1e+20,true,null,"\u0000x\"",{},[]],)"
    R"("huge":[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,18446744073709551615],)"
    R"("long":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,-17],"mixed":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,0.5],)"
    R"("doubles":[0.5,1.5,2.5,3.5,4.5,5.5,6.5,7.5,8.5,9.5,10.5,11.5,12.5,13.5,14.5,-0.0,0.1]})"
    "\n";

std::string cbor_of(const std::string& document) {
  std::string out;
  write_mesh(read_mesh(document), out, DocumentForm::cbor);
  return out;
}
std::string json_of(const std::string& document) {
  std::string out;
  write_mesh(read_mesh(document), out);
  return out;
}

/// "POINTER: TEXT" of what the reader says of a value.
std::string fault_of(const std::string& bytes) {
  try {
    read_value(bytes);
  } catch (const InputError& e) {
    return e.pointer() + ": " + e.what();
  }
  return {};
}
std::string value_of(const std::string& bytes) { return write_value(*read_value(bytes)); }

/// A map with one member "v".
std::string member(const std::string& value) { return "\xA1\x61v"s + value; }

std::vector<double> numbers_of(const std::string& bytes) {
  CborReader in(bytes);
  std::vector<double> out;
  in.numbers(out);
  in.finish();
  return out;
}

}  // namespace

TEST_CASE("JSON to CBOR to JSON gives the same bytes, and CBOR to JSON to CBOR too", "[formats][cbor]") {
  REQUIRE(json_of(small) == small);
  const std::string cbor = cbor_of(small);
  CHECK(json_of(cbor) == small);
  CHECK(cbor_of(cbor) == cbor);
  CHECK(
      cbor.starts_with("\xBF\x66"
                       "format\x6B"
                       "pliant-mesh"));
  CHECK(json_of("\xD9\xD9\xF7"s + cbor) == small);
}

TEST_CASE("a document in pieces is the document, and nothing comes of one with a number that is not finite",
          "[formats][cbor]") {
  MeshData data = read_mesh(small);
  for (const DocumentForm form : {DocumentForm::json, DocumentForm::cbor}) {
    data.fields.front().values.assign(4, 0.25);
    std::string whole, pieces;
    write_mesh(data, whole, form);
    write_mesh(data, form, [&](std::string_view piece) { pieces += piece; });
    CHECK(pieces == whole);
    data.fields.front().values.back() = std::numeric_limits<double>::infinity();
    pieces.clear();
    CHECK_THROWS_AS(write_mesh(data, form, [&](std::string_view piece) { pieces += piece; }), std::domain_error);
    CHECK(pieces.empty());
  }
}

TEST_CASE("long arrays go to the sink as they are, and come back", "[formats][cbor]") {
  const std::size_t count = 100000;
  MeshData data = read_mesh(small);
  data.points.resize(count, Point{0.1, -0.0});
  for (std::size_t k = 0; k < count; ++k) data.points[k].x += static_cast<double>(k);
  data.fields.clear();
  std::string json, cbor;
  write_mesh(data, DocumentForm::json, [&](std::string_view piece) { json += piece; });
  write_mesh(data, DocumentForm::cbor, [&](std::string_view piece) { cbor += piece; });
  CHECK(read_mesh(cbor).points == data.points);
  CHECK(json_of(cbor) == json);
  CHECK(cbor_of(json) == cbor);
  data.extra.emplace_back("force", to_document(Json(std::numeric_limits<double>::infinity())));
  std::string pieces;
  for (const DocumentForm form : {DocumentForm::json, DocumentForm::cbor})
    CHECK_THROWS_AS(write_mesh(data, form, [&](std::string_view piece) { pieces += piece; }), std::domain_error);
  CHECK(pieces.empty());
}

TEST_CASE("numbers are read in every encoding of CBOR", "[formats][cbor]") {
  CHECK(value_of("\x86\x00\x18\x18\x19\x01\x00\x1A\x00\x01\x00\x00\x1B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x20"s) ==
        "[0,24,256,65536,18446744073709551615,-1]");
  CHECK(value_of("\x82\x3B\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x3B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s) ==
        "[-9223372036854775808,-18446744073709551616]");
  // RFC 8949, appendix A
  CHECK(value_of("\x87\xF9\x00\x00\xF9\x80\x00\xF9\x3C\x00\xF9\x7B\xFF\xF9\x00\x01\xF9\x04\x00\xF9\xC4\x00"s) ==
        "[0,-0.0,1,65504,5.960464477539063e-08,6.103515625e-05,-4]");
  CHECK(value_of("\x82\xFA\x47\xC3\x50\x00\xFB\x3F\xF1\x99\x99\x99\x99\x99\x9A"s) == "[1e+05,1.1]");
  CHECK(value_of("\x9F\x01\x7F\x62hi\x60\x61!\xFF\xBF\x61x\xF6\xFF\xFF"s) == R"([1,"hi!",{"x":null}])");
}

TEST_CASE("typed arrays of every type, order and alignment are read, and plain arrays too", "[formats][cbor]") {
  const std::vector<double> three{1, 2, 3};
  const auto typed = [](int tag, const std::string& bytes) {
    return "\xD8"s + static_cast<char>(tag) + "\x58"s + static_cast<char>(bytes.size()) + bytes;
  };
  CHECK(numbers_of(typed(64, "\1\2\3")) == three);
  CHECK(numbers_of(typed(68, "\1\2\3")) == three);
  CHECK(numbers_of(typed(65, "\0\1\0\2\0\3"s)) == three);
  CHECK(numbers_of(typed(69, "\1\0\2\0\3\0"s)) == three);
  CHECK(numbers_of(typed(66, "\0\0\0\1\0\0\0\2\0\0\0\3"s)) == three);
  CHECK(numbers_of(typed(70, "\1\0\0\0\2\0\0\0\3\0\0\0"s)) == three);
  CHECK(numbers_of(typed(67, "\0\0\0\0\0\0\0\1"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(71, "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF")) == std::vector{0x1p64});
  CHECK(numbers_of(typed(72, "\xFF")) == std::vector{-1.0});
  CHECK(numbers_of(typed(73, "\xFF\xFE")) == std::vector{-2.0});
  CHECK(numbers_of(typed(77, "\xFE\xFF")) == std::vector{-2.0});
  CHECK(numbers_of(typed(74, "\xFF\xFF\xFF\xFE")) == std::vector{-2.0});
  CHECK(numbers_of(typed(78, "\xFE\xFF\xFF\xFF")) == std::vector{-2.0});
  CHECK(numbers_of(typed(75, "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFE")) == std::vector{-2.0});
  CHECK(numbers_of(typed(79, "\xFE\xFF\xFF\xFF\xFF\xFF\xFF\xFF")) == std::vector{-2.0});
  CHECK(numbers_of(typed(80, "\x3C\x00"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(84, "\x00\x3C"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(81, "\x3F\x80\0\0"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(85, "\0\0\x80\x3F"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(82, "\x3F\xF0\0\0\0\0\0\0"s)) == std::vector{1.0});
  CHECK(numbers_of(typed(86, "\0\0\0\0\0\0\xF0\x3F"s)) == std::vector{1.0});
  CHECK(numbers_of("\xD8\x46\x5F\x43\1\0\0\x45\0\2\0\0\0\xFF"s) == std::vector{1.0, 2.0});  // in chunks
  CHECK(numbers_of("\xD8\x46\x40"s).empty());
  CHECK(numbers_of("\x83\x01\xF9\x40\x00\xFA\x40\x40\x00\x00"s) == three);
  CHECK(numbers_of("\x9F\x01\x02\x03\xFF"s) == three);
  CHECK(numbers_of("\xD8\x29\x83\x01\x02\x03"s) == three);
  CHECK(value_of(typed(69, "\1\0\2\0\3\0"s)) == "[1,2,3]");
  CHECK(value_of(member(typed(72, "\xFF\1"))) == R"({"v":[-1,1]})");
  CHECK(value_of("\xD8\x46\x5F\x44\1\0\0\0\xFF"s) == "[1]");
  const std::string odd = "\xD8\x46\x44\1\0\0\0"s;
  CborReader in(odd);
  std::vector<std::array<std::int32_t, 2>> pairs;
  CHECK_THROWS_WITH(in.pairs(pairs), Catch::Contains("odd number"));
  const std::string half = "\xD8\x55\x44\0\0\0\x3F"s;
  CborReader fraction(half);
  std::vector<std::int32_t> integers;
  CHECK_THROWS_WITH(fraction.integers(integers), Catch::Contains("should be an integer (byte 3)"));
}

TEST_CASE("what JSON has not is refused with its place", "[formats][cbor]") {
  using Catch::Contains;
  CHECK_THAT(fault_of(member("\x43xyz")), Contains("/v: ") && Contains("byte string") && Contains("(byte 3)"));
  CHECK_THAT(fault_of("\xA1\x01\x02"s), Contains("name") && Contains("found a number") && Contains("(byte 1)"));
  CHECK_THAT(fault_of(member("\xF7")), Contains("undefined"));
  CHECK_THAT(fault_of(member("\xF9\x7E\x00"s)), Contains("no finite number"));
  CHECK_THAT(fault_of(member("\xFA\x7F\x80\x00\x00"s)), Contains("no finite number"));
  CHECK_THAT(fault_of(member("\xFB\x7F\xF0\0\0\0\0\0\0"s)), Contains("no finite number"));
  CHECK_THAT(fault_of(member("\xD8\x56\x48\0\0\0\0\0\0\xF0\x7F"s)), Contains("no finite number"));
  CHECK_THAT(fault_of(member("\xC1\x01"s)), Contains("tag 1"));
  CHECK_THAT(fault_of(member("\xD8\x57\x50" + std::string(16, '\0'))), Contains("tag 87"));
  CHECK_THAT(fault_of(member("\xD8\x46\x43\1\2\3")), Contains("3 bytes"));
  CHECK_THAT(fault_of(member("\xF8\x20"s)), Contains("simple value 32"));
  CHECK_THAT(fault_of(member("\x61\xFF")), Contains("UTF-8"));
  CHECK_THAT(fault_of(member("\x62\xED\xA0")), Contains("UTF-8"));
  CHECK_THAT(fault_of("\xA2\x61"
                      "a\x01\x61"
                      "a\x02"),
             Contains("twice"));
  CHECK_THAT(fault_of(member("\x1C")), Contains("is no CBOR"));
  CHECK_THAT(fault_of(member("\xFF")), Contains("break"));
  CHECK_THAT(fault_of(member("\x01\x01")), Contains("nothing may follow"));
  CHECK_THAT(fault_of(std::string(65, '\x81') + "\x01"), Contains("nested more than 64 deep"));
  CHECK(fault_of(std::string(64, '\x81') + "\x01").empty());
  CHECK_THAT(fault_of(std::string(100000, '\x9F')), Contains("nested more than 64 deep"));
  CHECK_THAT(fault_of("\xD9\xD9\xF7"s), Contains("the document ends"));
}

TEST_CASE("numbers of a typed array are taken for nothing else, whatever their bytes", "[formats][cbor]") {
  // 0x1B would be the head of an item of nine bytes, 0x1C none at all.
  for (const std::string& bytes : {"\xD8\x40\x41\x1C"s, "\xD8\x40\x5F\x41\x1B\xFF"s}) {
    const auto refuses = [&](const std::string& text, auto read) {
      CborReader in(bytes);
      CHECK_THROWS_WITH(in.array([&] { read(in); }), Catch::Contains(text + ", found a number"));
    };
    refuses("should be an object", [](CborReader& in) { in.object([](std::string_view) { return false; }); });
    refuses("should be an array", [](CborReader& in) { in.array([] {}); });
    refuses("should be a string", [](CborReader& in) { in.string(); });
    refuses("should be an array of numbers", [](CborReader& in) {
      std::vector<double> numbers;
      in.numbers(numbers);
    });
  }
}

TEST_CASE("forged lengths are refused before anything is allocated", "[formats][cbor]") {
  const std::string huge = "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF";
  for (const char* head : {"\x9B", "\xBB", "\x7B", "\x5B", "\xD8\x56\x5B", "\xD8\x46\x5F\x5B"})
    CHECK_THAT(fault_of(member(head + huge)), Catch::Contains("/v"));
  for (const char* head : {"\x9B", "\xD8\x56\x5B"}) {
    const std::string bytes = head + huge;
    CborReader in(bytes);
    std::vector<double> out;
    CHECK_THROWS_AS(in.numbers(out), InputError);
  }
}

TEST_CASE("a fault found after reading has its byte, with the document and without it", "[formats][cbor]") {
  const std::string cbor = cbor_of(small);
  ReaderNotes notes;
  read_mesh(cbor, &notes);
  const DocumentOutline outline(cbor, notes.arrays);
  for (const char* pointer : {"", "/points", "/points/3", "/triangles/5", "/constrained_edges/2/points/1", "/nowhere",
                              "/fields/1/values/2", "/boundary/faces/0/color", "/a/2", "/doubles/16", "/criteria"}) {
    CAPTURE(pointer);
    CHECK(outline.find(pointer).byte == find_place(cbor, pointer).byte);
  }
  CHECK(cbor.substr(static_cast<std::size_t>(find_place(cbor, "/points/2").byte), 8) == "\0\0\0\0\0\0\xF0\x3F"s);
  CHECK(cbor[static_cast<std::size_t>(find_place(cbor, "/constrained_edges/3/span").byte)] == '\3');
}

TEST_CASE("an outline of JSON tells line and column as the document does", "[formats]") {
  std::string text = "{\"a\": 1,\n \"points\": [";
  for (int k = 0; k < 200; ++k) text += std::to_string(k) + (k % 7 == 0 ? ",\n" : ", ");
  text += "0], \"b\": [1,\n 2], \"c\":\n  3, \"more\": [" + std::string(600, ' ') + "1], \"d\": {\"e\": 4}}";
  NumberArray points{text.find('['), text.find(']') + 1};
  const std::size_t more = text.find('[', text.find("more"));
  const DocumentOutline outline(text, {points, {more, text.find(']', more) + 1}});
  for (const char* pointer : {"", "/a", "/points", "/b", "/b/1", "/c", "/more", "/d", "/d/e"}) {
    CAPTURE(pointer);
    CHECK(outline.find(pointer).line == find_place(text, pointer).line);
    CHECK(outline.find(pointer).column == find_place(text, pointer).column);
  }
}

TEST_CASE("a sequence falls into its items, also beside JSON", "[formats][cbor]") {
  const std::string cbor = cbor_of(small);
  const std::string series = cbor + cbor + small + cbor + small;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  std::fwrite(series.data(), 1, series.size(), file.get());
  std::rewind(file.get());
  DocumentStream stream(file.get(), "series");
  std::string_view document;
  std::vector<std::string> found;
  while (stream.next(document)) {
    found.emplace_back(document);
    CHECK(series.substr(static_cast<std::size_t>(stream.first_byte()), document.size()) == document);
    if (found.size() % 2 == 0) stream.release();
  }
  REQUIRE(found.size() == 5);
  for (const std::string& each : found) CHECK(json_of(each) == small);
}

TEST_CASE("damaged bytes of CBOR are refused or read, and what is read stays the same", "[formats][cbor][property]") {
  const std::string cbor = cbor_of(small);
  const int seed = GENERATE(range(0, 8));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (int k = 0; k < 500; ++k) {
    std::string bytes = cbor;
    for (std::size_t times = 1 + below(3); times > 0 && !bytes.empty(); --times) {
      const std::size_t at = below(bytes.size());
      switch (below(4)) {
        case 0:
          bytes[at] = static_cast<char>(below(256));
          break;
        case 1:
          bytes.erase(at, 1 + below(8));
          break;
        case 2:
          bytes.insert(at, bytes.substr(below(bytes.size()), below(16)));
          break;
        default:
          bytes.resize(at);
      }
    }
    try {
      const std::string again = cbor_of(bytes);
      CHECK(json_of(cbor_of(json_of(again))) == json_of(again));
    } catch (const InputError&) {
    }
  }
}
