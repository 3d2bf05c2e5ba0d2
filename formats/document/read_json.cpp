// formats/document/read_json.cpp: objects, arrays and faults of a document.
#include "formats/document/read_json.h"

#include <algorithm>
#include <cstring>

#include "formats/document/characters.h"

namespace pliant {

// -- faults

DocumentPlace JsonReader::place_of(const std::string& pointer) const {
  // What comes behind the value's first byte has not been checked, and need not be JSON.
  const std::size_t known = static_cast<std::size_t>(std::min(at_ + 1, end_) - begin_);
  return find_place({begin_, known}, pointer);
}

void JsonReader::fail_at(const char* where, const std::string& text) const {
  throw DocumentError(pointer(), text, place_of_byte({begin_, end_}, static_cast<std::size_t>(where - begin_)));
}

std::string JsonReader::found() const {
  if (at_ == end_) return at_ == begin_ ? "but the document is empty" : "but the document ends";
  const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
  if (rest.starts_with("\xEF\xBB\xBF")) return "found a byte order mark";
  const char c = *at_;
  if (c == '{') return "found an object";
  if (c == '[') return "found an array";
  if (c == '"') return "found a string";
  if (rest.starts_with("true") || rest.starts_with("false")) return "found a boolean";
  if (rest.starts_with("null")) return "found null";
  if (c == '-' || is_digit(c)) return "found a number";
  if (byte_of(c) > 0x20 && byte_of(c) < 0x7F) return std::string("found '") + c + "'";
  constexpr char hex[] = "0123456789ABCDEF";
  return std::string("found byte 0x") + hex[byte_of(c) >> 4] + hex[byte_of(c) & 15];
}

// -- structure

void JsonReader::open(char bracket, const char* what) {
  if (peek() != bracket || at_ == end_) syntax(std::string("should be ") + what + ", " + found());
  if (path_.size() >= max_depth) syntax("is nested more than " + std::to_string(max_depth) + " deep");
  ++at_;
}

void JsonReader::missing_comma(char close) const { syntax(std::string("expected ',' or '") + close + "', " + found()); }

void JsonReader::open_object(Container&) { open('{', "an object"); }

bool JsonReader::next_member(Container& object, Names& names, std::string_view& name) {
  const bool is_there = next_value('}', object.is_first);
  object.is_first = false;
  if (!is_there) return false;
  if (peek() != '"' || at_ == end_) syntax("expected a member's name in quotes, " + found());
  name = text();
  if (!names.add(name)) syntax("has the member \"" + std::string(name) + "\" twice");
  if (peek() != ':' || at_ == end_) syntax("expected ':', " + found());
  ++at_;
  skip_space();
  return true;
}

void JsonReader::open_array(Container&) { open('[', "an array"); }

bool JsonReader::next_element(Container& array) {
  const bool is_there = next_value(']', array.is_first);
  array.is_first = false;
  return is_there;
}

void JsonReader::finish() {
  if (skip_space(); at_ != end_) syntax("nothing may follow the document on its line, " + found());
}

// -- scalars

DocumentReader::Kind JsonReader::kind() {
  switch (const char c = peek()) {
    case '{':
      return Kind::object;
    case '[':
      return Kind::array;
    case '"':
      return Kind::string;
    case 't':
    case 'f':
      return Kind::boolean;
    case 'n':
      return Kind::null;
    default:
      return c == '-' || is_digit(c) ? Kind::number : Kind::nothing;
  }
}

void JsonReader::skip_word(const char* word) {
  const std::size_t size = std::strlen(word);
  if (static_cast<std::size_t>(end_ - at_) < size || std::memcmp(at_, word, size) != 0)
    syntax(std::string("expected ") + word);
  at_ += size;
}

bool JsonReader::boolean() {
  const char c = peek();
  if (c != 't' && c != 'f') syntax("should be true or false, " + found());
  skip_word(c == 't' ? "true" : "false");
  return c == 't';
}

bool JsonReader::null() {
  if (peek() != 'n') return false;
  skip_word("null");
  return true;
}

}  // namespace pliant
