// formats/document/write_json.cpp: numbers and strings as JSON.
#include "formats/document/write_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pliant {

void append_number(std::string& out, double value) {
  require_finite({&value, 1});
  if (value == 0) {
    out += std::signbit(value) ? "-0.0" : "0";  // -0 would be read as an integer by many programs, and lose its sign
    return;
  }
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

void append_integer(std::string& out, std::int64_t value) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

void append_string(std::string& out, std::string_view text) {
  constexpr char hex[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte >= 0x20) {
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else {
      out += "\\u00";
      out += hex[byte >> 4];
      out += hex[byte & 15];
    }
  }
  out += '"';
}

template <class Append>
JsonWriter& JsonWriter::list(std::size_t count, Append append) {
  open('[');
  constexpr std::size_t block = 1024;
  for (std::size_t first = 0; first < count; first += block) {
    for (std::size_t k = first; k < std::min(count, first + block); ++k) {
      if (k > 0) out_ += ',';
      append(k);
    }
    relieve();
  }
  return close(']');
}

JsonWriter& JsonWriter::numbers(std::span<const double> values) {
  return list(values.size(), [&](std::size_t k) { append_number(out_, values[k]); });
}

JsonWriter& JsonWriter::integers(std::span<const std::int32_t> values) {
  return list(values.size(), [&](std::size_t k) { append_integer(out_, values[k]); });
}

JsonWriter& JsonWriter::points(std::span<const Point> points) {
  return list(points.size(), [&](std::size_t k) {
    append_number(out_, points[k].x);
    out_ += ',';
    append_number(out_, points[k].y);
  });
}

void JsonWriter::end() {
  out_ += '\n';
  if (sink_ != nullptr) flush();
}

}  // namespace pliant
