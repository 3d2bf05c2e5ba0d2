// formats/document/read_json.h: a strict pull reader of JSON; bulk arrays go straight into vectors, faults name the
// place.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "formats/document/document_place.h"
#include "pliant/boundary/extra_members.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// Bad input with its place in the text too: line and column (bytes) from 1, counted from the start of the document.
class DocumentError : public InputError {
 public:
  DocumentError(std::string pointer, const std::string& text, const DocumentPlace& place)
      : InputError(std::move(pointer), with_column(text, place)), place_(place) {}
  long line() const { return place_.line; }
  long column() const { return place_.column; }

 private:
  DocumentPlace place_;
};

/// One pass over one document, from the first byte to the last: the caller asks for what must stand next, and every
/// byte is checked against the grammar of RFC 8259, also in members that nobody asked for (UTF-8, escapes, numbers,
/// names that come twice). Nothing is allocated that the text does not hold. The text must outlive the reader.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : begin_(text.data()), end_(begin_ + text.size()), at_(begin_) {}

  /// Calls member(name) for each; it must read the value, or return false: then the value goes into `extra`.
  template <class F>
  void object(ExtraMembers& extra, F member);
  /// The same where other members are not allowed.
  template <class F>
  void object(F member);
  /// Calls element() for each.
  template <class F>
  void array(F element);

  double number();
  std::int32_t integer();  ///< within 32 bits; 2.0 and 2e0 are integers as in JSON Schema
  bool boolean();
  std::string string();
  bool null();  ///< reads null if it stands there
  /// An array of finite numbers; of integers; of x and y in turn.
  void numbers(std::vector<double>& out);
  void integers(std::vector<std::int32_t>& out);
  void points(std::vector<Point>& out);
  void pairs(std::vector<std::array<std::int32_t, 2>>& out);
  /// A number that nobody asked for: exactly, if it is an integer of 64 bits; the nearest double otherwise.
  std::variant<double, std::int64_t, std::uint64_t> any_number();
  /// Any value.
  std::shared_ptr<const DocumentValue> value();
  /// The first byte of the next value, or what stands in its place; 0 at the end.
  char peek() {
    skip_space();
    return at_ == end_ ? '\0' : *at_;
  }
  /// Requires that nothing but white space follows.
  void finish();

  /// Throws a DocumentError at the value now being read, or below it ("/knots/7").
  [[noreturn]] void fail(const std::string& text, const std::string& below = {}) const;
  /// Notes that this member of the value last read is probably not what was meant.
  void doubt(std::string_view member, const std::string& text);
  const std::vector<Doubt>& doubts() const { return doubts_; }

 private:
  struct Step {
    std::string_view name;  // a member, if index is negative
    long index;
  };
  struct Names {
    bool add(std::string_view name);
    std::vector<std::string_view> few;
    std::unordered_set<std::string_view> many;
  };
  static constexpr int max_depth = 64;

  void skip_space() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }
  void open(char bracket, const char* what);
  bool next_element(char close, bool first) {
    const char c = peek();
    if (c == close) return ++at_, false;
    if (first) return true;
    if (c != ',') missing_comma(close);
    return ++at_, true;
  }
  [[noreturn]] void missing_comma(char close) const;
  std::string_view member_name(Names& names);
  std::string_view text();
  void escape(std::string& out);
  unsigned four_hex();
  const char* skip_utf8(const char* p) const;
  template <class Store>
  void bulk(const char* what, Store store);
  double read_number();
  std::int32_t read_integer();
  double slow_number(const char* first, const char* last) const;
  void skip_word(const char* word);
  [[noreturn]] void syntax(const std::string& text) const { fail_at(at_, text); }
  [[noreturn]] void fail_at(const char* where, const std::string& text) const;
  std::string pointer() const;  ///< of the value now being read
  std::string found() const;

  const char* begin_;
  const char* end_;
  const char* at_;
  std::vector<Step> path_;
  std::vector<Doubt> doubts_;
  std::deque<std::string> unescaped_;  // names with escapes, which have no place in the text
};

template <class F>
void JsonReader::object(ExtraMembers& extra, F member) {
  open('{', "an object");
  Names names;
  for (bool first = true; next_element('}', first); first = false) {
    const std::string_view name = member_name(names);
    path_.push_back({name, -1});
    if (!member(name)) extra.emplace_back(std::string(name), value());
    path_.pop_back();
  }
}

template <class F>
void JsonReader::object(F member) {
  ExtraMembers none_kept;
  object(none_kept, [&](std::string_view name) {
    if (!member(name)) fail("is not a member of this object, which cannot carry others");
    return true;
  });
}

template <class F>
void JsonReader::array(F element) {
  open('[', "an array");
  path_.push_back({{}, 0});
  for (bool first = true; next_element(']', first); first = false) {
    element();
    ++path_.back().index;
  }
  path_.pop_back();
}

}  // namespace pliant
