// tests/bench/json_readers.cpp: the arrays of one mesh document by several readers: json_readers READER FILE [TIMES].
// READER is pliant, nlohmann-dom, nlohmann-sax, or simdjson-dom and simdjson-ondemand where simdjson was found. What
// each costs is seen from outside (callgrind) or in the printed processor time of the fastest of the TIMES runs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>
#if defined(PLIANT_SIMDJSON)
#include <simdjson.h>
#endif

#include "formats/document/mesh_document.h"

namespace {

/// What is compared: the arrays that make up nearly all of the text.
struct Arrays {
  std::vector<double> points, values;
  std::vector<std::int32_t> triangles, faces;

  /// So that nothing can be left out, and readers can be seen to agree.
  double sum() const {
    double total = 0;
    for (const double x : points) total += x;
    for (const double x : values) total += x;
    for (const std::int32_t i : triangles) total += i;
    for (const std::int32_t i : faces) total += i;
    return total;
  }
};

Arrays by_pliant(const std::string& text) {
  pliant::MeshData data = pliant::read_mesh(text);
  Arrays arrays{{}, std::move(data.fields.at(0).values), std::move(data.triangles), std::move(data.triangle_faces)};
  for (const pliant::Point& p : data.points) arrays.points.insert(arrays.points.end(), {p.x, p.y});
  return arrays;
}

Arrays by_nlohmann_dom(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  return {json["points"], json["fields"][0]["values"], json["triangles"], json["triangle_faces"]};
}

/// Numbers go into the array whose name came last.
struct Sax : nlohmann::json_sax<nlohmann::json> {
  Arrays arrays;
  std::vector<double>* reals = nullptr;
  std::vector<std::int32_t>* integers = nullptr;
  int depth = 0;  // of objects

  bool take(double number) {
    if (reals != nullptr) reals->push_back(number);
    if (integers != nullptr) integers->push_back(static_cast<std::int32_t>(number));
    return true;
  }
  bool key(string_t& name) override {
    // The curves of the boundary have points, too, deeper down.
    reals = name == "points" && depth == 1 ? &arrays.points : name == "values" ? &arrays.values : nullptr;
    integers = name == "triangles" ? &arrays.triangles : name == "triangle_faces" ? &arrays.faces : nullptr;
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t number) override { return take(static_cast<double>(number)); }
  bool number_unsigned(number_unsigned_t number) override { return take(static_cast<double>(number)); }
  bool number_float(number_float_t number, const string_t&) override { return take(number); }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return ++depth > 0; }
  bool end_object() override { return --depth >= 0; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override {
    reals = nullptr;
    integers = nullptr;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }
};

Arrays by_nlohmann_sax(const std::string& text) {
  Sax sax;
  if (!nlohmann::json::sax_parse(text, &sax)) std::exit(1);
  return std::move(sax.arrays);
}

#if defined(PLIANT_SIMDJSON)
Arrays by_simdjson_dom(const std::string& text) {
  static simdjson::dom::parser parser;
  const simdjson::dom::element document = parser.parse(text);
  Arrays arrays;
  for (const double x : document["points"].get_array()) arrays.points.push_back(x);
  for (const double x : document["fields"].at(0)["values"].get_array()) arrays.values.push_back(x);
  for (const std::int64_t i : document["triangles"].get_array()) arrays.triangles.push_back(static_cast<int>(i));
  for (const std::int64_t i : document["triangle_faces"].get_array()) arrays.faces.push_back(static_cast<int>(i));
  return arrays;
}

Arrays by_simdjson_ondemand(const std::string& text) {
  static simdjson::ondemand::parser parser;
  const simdjson::padded_string padded(text);
  simdjson::ondemand::document document = parser.iterate(padded);
  Arrays arrays;
  for (auto x : document["points"]) arrays.points.push_back(x.get_double());
  for (auto i : document["triangles"]) arrays.triangles.push_back(static_cast<int>(i.get_int64()));
  for (auto i : document["triangle_faces"]) arrays.faces.push_back(static_cast<int>(i.get_int64()));
  for (auto x : document["fields"].at(0)["values"]) arrays.values.push_back(x.get_double());
  return arrays;
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, std::function<Arrays(const std::string&)>> readers {
    {"pliant", by_pliant}, {"nlohmann-dom", by_nlohmann_dom}, {"nlohmann-sax", by_nlohmann_sax},
#if defined(PLIANT_SIMDJSON)
        {"simdjson-dom", by_simdjson_dom}, {"simdjson-ondemand", by_simdjson_ondemand},
#endif
  };
  if (argc < 3 || !readers.contains(argv[1])) {
    std::fprintf(stderr, "usage: json_readers READER FILE [TIMES]; READER is one of");
    for (const auto& [name, read] : readers) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  std::ifstream in(argv[2], std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  double least = HUGE_VAL, sum = 0;
  for (int k = argc > 3 ? std::atoi(argv[3]) : 1; k > 0; --k) {
    const std::clock_t start = std::clock();
    const Arrays arrays = readers.at(argv[1])(text);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    least = std::min(least, seconds);
    sum = arrays.sum();
  }
  std::printf("%s: sum %.17g, %.2f ms, %.0f MB/s\n", argv[1], sum, 1e3 * least,
              static_cast<double>(text.size()) / 1e6 / least);
  return 0;
}
