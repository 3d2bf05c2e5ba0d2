// formats/document/read_json_strings.cpp: strings: UTF-8 and escapes.
#include <charconv>

#include "formats/document/characters.h"
#include "formats/document/read_json.h"

namespace pliant {
namespace {

void append_utf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | (code >> 6));
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | (code >> 12));
    add(0x80 | ((code >> 6) & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | (code >> 18));
    add(0x80 | ((code >> 12) & 0x3F));
    add(0x80 | ((code >> 6) & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

}  // namespace

// -- strings

unsigned JsonReader::four_hex() {
  unsigned code = 0;
  if (end_ - at_ < 4 || std::from_chars(at_, at_ + 4, code, 16).ptr != at_ + 4) syntax("\\u needs four hex digits");
  at_ += 4;
  return code;
}

void JsonReader::escape(std::string& out) {
  constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
  if (++at_ == end_) syntax("a string should end, but the document ends");
  const char c = *at_++;
  if (c != 'u') {
    const std::size_t i = names.find(c);
    if (--at_; i == std::string_view::npos) syntax("\\ does not escape this character");
    ++at_;
    out += values[i];
    return;
  }
  unsigned code = four_hex();
  if (code >= 0xD800 && code < 0xE000) {
    unsigned low = 0;
    if (code < 0xDC00 && end_ - at_ >= 2 && at_[0] == '\\' && at_[1] == 'u') {
      at_ += 2;
      low = four_hex();
    }
    if (low < 0xDC00 || low >= 0xE000) syntax("half of a surrogate pair is no character");
    code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
  }
  append_utf8(out, code);
}

std::string_view JsonReader::text() {
  const char* first = ++at_;
  std::string* copy = nullptr;  // made at the first escape
  for (;;) {
    if (at_ == end_) syntax("a string should end, but the document ends");
    const unsigned c = byte_of(*at_);
    if (c == '"') break;
    if (c < 0x20) syntax("a control character in a string must be escaped");
    if (c == '\\') {
      if (copy == nullptr) copy = &unescaped_.emplace_back(first, at_);
      escape(*copy);
      continue;
    }
    const char* next = c < 0x80 ? at_ + 1 : skip_utf8(at_, end_);
    if (next == nullptr) syntax("is not UTF-8");
    if (copy != nullptr) copy->append(at_, next);
    at_ = next;
  }
  const std::string_view plain(first, static_cast<std::size_t>(at_ - first));
  ++at_;
  return copy == nullptr ? plain : std::string_view(*copy);
}

std::string JsonReader::string() {
  if (peek() != '"') syntax("should be a string, " + found());
  return std::string(text());
}

}  // namespace pliant
