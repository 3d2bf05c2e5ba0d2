// formats/document/write_json.cpp: numbers and strings as JSON.
#include "formats/document/write_json.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace pliant {

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) throw std::domain_error("a number of the result is not finite");
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

}  // namespace pliant
