// formats/document/read_json.cpp: objects, arrays and faults of a document.
#include "formats/document/read_json.h"

#include <algorithm>
#include <cstring>

namespace pliant {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
unsigned byte_of(char c) { return static_cast<unsigned char>(c); }

/// The pointer's text of a member name (RFC 6901).
void append_escaped(std::string& pointer, std::string_view name) {
  for (const char c : name) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
}

}  // namespace

// -- faults

std::string JsonReader::pointer() const {
  std::string pointer;
  for (const Step& step : path_) {
    pointer += '/';
    if (step.index < 0)
      append_escaped(pointer, step.name);
    else
      pointer += std::to_string(step.index);
  }
  return pointer;
}

void JsonReader::fail(const std::string& text, const std::string& below) const {
  const std::string pointer = this->pointer() + below;
  // What comes behind the value's first byte has not been checked, and need not be JSON.
  const std::size_t known = static_cast<std::size_t>(std::min(at_ + 1, end_) - begin_);
  const DocumentPlace place = find_place({begin_, known}, pointer);
  throw DocumentError(pointer, text, place);
}

void JsonReader::doubt(std::string_view member, const std::string& text) {
  constexpr std::size_t most = 20;
  std::string place;
  append_escaped(place, member);
  for (char& c : place)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';  // a terminal would act on it
  const auto is_same = [&](const Doubt& old) { return old.text == text && old.pointer.ends_with("/" + place); };
  if (const auto old = std::find_if(doubts_.begin(), doubts_.end(), is_same); old != doubts_.end())
    ++old->more;
  else if (doubts_.size() < most)
    doubts_.push_back({pointer() + "/" + place, text, 0});
  else
    ++doubts_.back().more;
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

bool JsonReader::Names::add(std::string_view name) {
  constexpr std::size_t linear = 16;  // above, a hostile object would cost the square of its size
  if (few.size() < linear) {
    if (std::find(few.begin(), few.end(), name) != few.end()) return false;
    if (few.empty()) few.reserve(8);
    few.push_back(name);
    if (few.size() == linear) many.insert(few.begin(), few.end());
    return true;
  }
  return many.insert(name).second;
}

std::string_view JsonReader::member_name(Names& names) {
  if (peek() != '"' || at_ == end_) syntax("expected a member's name in quotes, " + found());
  const std::string_view name = text();
  if (!names.add(name)) syntax("has the member \"" + std::string(name) + "\" twice");
  if (peek() != ':' || at_ == end_) syntax("expected ':', " + found());
  ++at_;
  skip_space();
  return name;
}

void JsonReader::finish() {
  if (skip_space(); at_ != end_) syntax("nothing may follow the document on its line, " + found());
}

// -- scalars

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
