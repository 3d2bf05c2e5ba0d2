// formats/document/read_json.h: a strict pull reader of JSON; bulk arrays go straight into vectors, faults name the
// place.
#pragma once
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_reader.h"

namespace pliant {

/// Reads a document in JSON by the grammar of RFC 8259.
class JsonReader final : public DocumentReader {
 public:
  explicit JsonReader(std::string_view text) : begin_(text.data()), end_(begin_ + text.size()), at_(begin_) {}

  Kind kind() override;
  double number() override;
  std::int32_t integer() override;  ///< also 2.0 and 2e0
  bool boolean() override;
  std::string string() override;
  bool null() override;
  void numbers(std::vector<double>& out) override;
  void integers(std::vector<std::int32_t>& out) override;
  void points(std::vector<Point>& out) override;
  void pairs(std::vector<std::array<std::int32_t, 2>>& out) override;
  std::variant<double, std::int64_t, std::uint64_t> any_number() override;
  void finish() override;
  /// The first byte of the next value, or what stands in its place; 0 at the end.
  char peek() {
    skip_space();
    return at_ == end_ ? '\0' : *at_;
  }

 private:
  void open_object(Container& object) override;
  bool next_member(Container& object, Names& names, std::string_view& name) override;
  void open_array(Container& array) override;
  bool next_element(Container& array) override;
  DocumentPlace place_of(const std::string& pointer) const override;

  void skip_space() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }
  void open(char bracket, const char* what);
  bool next_value(char close, bool first) {
    const char c = peek();
    if (c == close) return ++at_, false;
    if (first) return true;
    if (c != ',') missing_comma(close);
    return ++at_, true;
  }
  [[noreturn]] void missing_comma(char close) const;
  std::string_view text();
  void escape(std::string& out);
  unsigned four_hex();
  template <class Store>
  void bulk(const char* what, Store store);
  double read_number();
  std::int32_t read_integer();
  double slow_number(const char* first, const char* last) const;
  void skip_word(const char* word);
  [[noreturn]] void syntax(const std::string& text) const { fail_at(at_, text); }
  [[noreturn]] void fail_at(const char* where, const std::string& text) const;
  std::string found() const;

  const char* begin_;
  const char* end_;
  const char* at_;
  std::deque<std::string> unescaped_;  // names with escapes, which have no place in the text
};

}  // namespace pliant
