// tests/formats/read_json_test.cpp: the reader against another parser, and numbers against the C library.
#include "formats/document/read_json.h"

#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/document/mesh_document.h"
#include "formats/document/write_json.h"
#include "support/triangles.h"

using namespace pliant;

namespace {

bool accepts(const std::string& text) {
  try {
    JsonReader in(text);
    in.value();
    in.finish();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// A random value, nested at most `depth` deep, with members whose names never come twice.
std::string random_value(samples::Random& random, int depth) {
  static const std::vector<std::string> scalars = {"0",
                                                   "-0",
                                                   "-1",
                                                   "12.5",
                                                   "1e5",
                                                   "-0.25E-3",
                                                   "1E+2",
                                                   "true",
                                                   "false",
                                                   "null",
                                                   "\"\"",
                                                   "\"a\"",
                                                   "\"\\n\\\"\"",
                                                   "\"é\"",
                                                   "\"\\u00e9\"",
                                                   "\"\\ud83d\\ude00\"",
                                                   "\"\xF0\x9F\x98\x80\"",
                                                   "\"{}[],:\""};
  const int kind = depth == 0 ? 0 : random.integer(0, 3);
  if (kind <= 1) return scalars[static_cast<std::size_t>(random.integer(0, static_cast<int>(scalars.size()) - 1))];
  std::string text = kind == 2 ? "[" : "{";
  const int count = random.integer(0, 3);
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += random.integer(0, 1) == 0 ? "," : " ,\n";
    if (kind == 3) text += "\"k" + std::to_string(i) + "\": ";
    text += random_value(random, depth - 1);
  }
  return text + (kind == 2 ? "]" : "}");
}

double read_one(const std::string& text) {
  JsonReader in(text);
  const double value = in.number();
  in.finish();
  return value;
}

std::string written(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace

TEST_CASE("the reader accepts exactly what another parser accepts", "[formats][property]") {
  const int seed = GENERATE(range(0, 40));
  CAPTURE(seed);
  samples::Random random(seed);
  const std::string alphabet = "{}[]\",:\\ud8truefalsnl0123456789.eE+-\n \x01\x80\xC3\xED\xF4";
  int accepted = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string text = random_value(random, 4);
    const int edits = random.integer(0, 2);
    for (int e = 0; e < edits && !text.empty(); ++e) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
      const char c = alphabet[static_cast<std::size_t>(random.integer(0, static_cast<int>(alphabet.size()) - 1))];
      if (const int edit = random.integer(0, 2); edit == 0)
        text[at] = c;
      else if (edit == 1)
        text.erase(at, 1);
      else
        text.insert(at, 1, c);
    }
    // The other parser knows neither our limits nor numbers beyond doubles, and keeps the last of two equal names.
    bool twice = false;
    nlohmann::json other;
    std::vector<std::vector<std::string>> names;
    const auto watch = [&](int, nlohmann::json::parse_event_t event, nlohmann::json& value) {
      using Event = nlohmann::json::parse_event_t;
      if (event == Event::object_start) names.emplace_back();
      if (event == Event::object_end) names.pop_back();
      if (event == Event::key) {
        auto& here = names.back();
        twice = twice || std::find(here.begin(), here.end(), value.get<std::string>()) != here.end();
        here.push_back(value.get<std::string>());
      }
      return true;
    };
    bool beyond_doubles = false, right = true;
    try {
      other = nlohmann::json::parse(text, watch);
    } catch (const nlohmann::json::out_of_range&) {
      beyond_doubles = true;
    } catch (const nlohmann::json::parse_error&) {
      right = false;
    }
    if (beyond_doubles) continue;
    CAPTURE(text);
    CHECK(accepts(text) == (right && !twice));
    accepted += right ? 1 : 0;
    if (right && !twice) {
      const std::string ours = write_value(*read_value(text));
      CHECK(nlohmann::json::parse(ours) == other);
      CHECK(write_value(*read_value(ours)) == ours);
    }
  }
  CHECK(accepted > 100);
}

TEST_CASE("every double survives writing and reading, in the shortest form", "[formats][property]") {
  const int seed = GENERATE(range(0, 20));
  CAPTURE(seed);
  samples::Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t bits = (static_cast<std::uint64_t>(random.integer(0, 0x7ffffffe)) << 33) ^
                               (static_cast<std::uint64_t>(random.integer(0, 0x7ffffffe)) << 11) ^
                               static_cast<std::uint64_t>(random.integer(0, 0x7ffffffe));
    const auto any = std::bit_cast<double>(bits);
    for (const double value : {any, random.real(-10, 10), 0.001 * random.integer(-100000, 100000)}) {
      if (!std::isfinite(value)) continue;
      const std::string text = written(value);
      CHECK(std::bit_cast<std::uint64_t>(read_one(text)) == std::bit_cast<std::uint64_t>(value));
      char shortest[40];
      const auto end = std::to_chars(shortest, shortest + 40, value).ptr;
      CHECK(text.size() <= static_cast<std::size_t>(end - shortest));
    }
  }
}

TEST_CASE("decimal texts are read as the C library reads them", "[formats][property]") {
  const int seed = GENERATE(range(0, 10));
  CAPTURE(seed);
  samples::Random random(seed);
  for (int i = 0; i < 3000; ++i) {
    std::string text = random.integer(0, 1) == 0 ? "-" : "";
    text += std::to_string(random.integer(0, 9));
    if (text.back() != '0')
      for (int k = random.integer(0, 22); k > 0; --k) text += static_cast<char>('0' + random.integer(0, 9));
    if (random.integer(0, 3) != 0) {
      text += '.';
      for (int k = random.integer(1, 22); k > 0; --k) text += static_cast<char>('0' + random.integer(0, 9));
    }
    if (random.integer(0, 2) == 0) text.append("e").append(std::to_string(random.integer(-340, 280)));
    const double expected = std::strtod(text.c_str(), nullptr);
    if (!std::isfinite(expected)) continue;
    CAPTURE(text);
    CHECK(std::bit_cast<std::uint64_t>(read_one(text)) == std::bit_cast<std::uint64_t>(expected));
  }
}

TEST_CASE("minus zero keeps its sign, and is written so that others keep it", "[formats]") {
  CHECK(written(-0.0) == "-0.0");
  CHECK(written(0.0) == "0");
  for (const char* text : {"-0", "-0.0", "-0e7", "-1e-400"}) {
    CAPTURE(text);
    CHECK(read_one(text) == 0);
    CHECK(std::signbit(read_one(text)));
  }
  CHECK_FALSE(std::signbit(read_one("1e-400")));
}

TEST_CASE("numbers at the ends of the doubles are read, beyond them refused", "[formats]") {
  CHECK(read_one("5e-324") == 5e-324);
  CHECK(read_one("2.4703282292062328e-324") == 5e-324);
  CHECK(read_one("1.7976931348623157e308") == 1.7976931348623157e308);
  CHECK(read_one(std::string("1").append(308, '0')) == 1e308);
  CHECK(read_one("0." + std::string(400, '0') + "1e401") == 1);
  CHECK_THROWS_AS(read_one("1e309"), InputError);
  CHECK_THROWS_AS(read_one("-1e999999999999999999999"), InputError);
  CHECK_THROWS_AS(written(HUGE_VAL), std::domain_error);
  CHECK_THROWS_AS(written(std::nan("")), std::domain_error);
}

TEST_CASE("what only looks like a number is refused", "[formats]") {
  for (const char* text : {"", "-", "+1", "01", "-01", "1.", ".5", "1e", "1e+", "0x10", "nan", "inf", "Infinity",
                           "1_000", "1,5", "--1", "1.5.2", "\"1\"", "null"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(read_one(text), InputError);
  }
}

TEST_CASE("integers may be written as any number of that value, within 32 bits", "[formats]") {
  const auto read = [](const std::string& text) { return JsonReader(text).integer(); };
  CHECK(read("7") == 7);
  CHECK(read("-7") == -7);
  CHECK(read("2.0") == 2);
  CHECK(read("12e2") == 1200);
  CHECK(read("2147483647") == 2147483647);
  for (const char* text : {"2.5", "2147483648", "1e10", "99999999999999999999", "18446744073709551617", "true"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(read(text), InputError);
  }
}

TEST_CASE("arrays of integers take what single integers take, whatever follows each", "[formats]") {
  const auto read = [](const std::string& text) {
    std::vector<std::int32_t> all;
    JsonReader in(text);
    in.integers(all);
    in.finish();
    return all;
  };
  CHECK(read("[0,7 ,-3,123456789,1234567890, 2147483647,2.0,1e2,0]") ==
        std::vector<std::int32_t>{0, 7, -3, 123456789, 1234567890, 2147483647, 2, 100, 0});
  for (const char* text : {"[00]", "[007,1]", "[012345678]", "[2147483648]", "[9999999999]", "[1.5]", "[-]", "[1",
                           "[1,]", "[1 2]", "[1:2]", "[1]]", "[123456789", "[12a]"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(read(text), InputError);
  }
}

TEST_CASE("strings are UTF-8 and survive a round trip", "[formats]") {
  for (const std::string& text : {std::string("plain"), std::string("\"\\/\b\f\n\r\t\x01\x1F\x7F"),
                                  std::string("\0nul", 4), std::string("é€😀")}) {
    std::string json;
    append_string(json, text);
    CHECK(JsonReader(json).string() == text);
    CHECK(nlohmann::json::parse(json).get<std::string>() == text);
  }
  CHECK(JsonReader("\"\\u00e9\\ud83d\\ude00\\/\"").string() == "é😀/");
  for (const char* bad :
       {"\"\xC0\x80\"", "\"\xED\xA0\x80\"", "\"\xF5\x80\x80\x80\"", "\"\xE2\x82\"", "\"\x80\"", "\"\\ud800\"",
        "\"\\udc00\"", "\"\\ud800\\u0041\"", "\"\\x41\"", "\"\\u12g4\"", "\"\n\"", "\"open"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(JsonReader(bad).string(), InputError);
  }
}

TEST_CASE("values that nobody asked for lose white space outside strings", "[formats]") {
  CHECK(write_value(*read_value(" { \"a b\" : [ 1.5 , \"x \\\" y\\\\\" ,\n{ } ] } ")) ==
        R"({"a b":[1.5,"x \" y\\",{}]})");
}

TEST_CASE("nesting has a limit", "[formats]") {
  CHECK(accepts(std::string(60, '[') + std::string(60, ']')));
  CHECK_FALSE(accepts(std::string(1000000, '[')));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  CHECK_FALSE(accepts(objects));
}

TEST_CASE("a name that comes twice is found among many, in reasonable time", "[formats]") {
  std::string text = "{";
  for (int i = 0; i < 200000; ++i) text += "\"n" + std::to_string(i) + "\":0,";
  CHECK(accepts(text + "\"m\":0}"));
  CHECK_FALSE(accepts(text + "\"n199999\":0}"));
  CHECK_FALSE(accepts("{\"a\":1,\"\\u0061\":2}"));
}

TEST_CASE("a fault tells line and column of the text", "[formats]") {
  try {
    JsonReader in("{\n  \"a\": [1, 2,\n   x]}");
    in.value();
    FAIL("accepted");
  } catch (const DocumentError& e) {
    CHECK(e.pointer() == "/a/2");
    CHECK(e.line() == 3);
    CHECK(e.column() == 4);
    CHECK(std::string(e.what()).find("column 4") != std::string::npos);
  }
}
