// formats/document/document_place.cpp: passes over a document without making values of it.
#include "formats/document/document_place.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace pliant {
namespace {

/// Passes over values whose grammar has been checked already; at a text that ends early it stays at the end.
class Skimmer {
 public:
  explicit Skimmer(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool is_at(char c) const { return at_ < text_.size() && text_[at_] == c; }

  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  /// Passes an opening bracket, or what stands between values.
  void skip_mark() {
    if (at_ < text_.size()) ++at_;
    skip_space();
  }

  /// Passes a string, and returns what stands between its quotes.
  std::string_view skip_string() {
    const std::size_t first = std::min(at_ + 1, text_.size());
    std::size_t end = first;
    while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    end = std::min(end, text_.size());
    at_ = std::min(end + 1, text_.size());
    return text_.substr(first, end - first);
  }

  /// Passes a value, and the white space behind it.
  void skip_value() {
    long depth = 0;
    do {
      at_ = std::min(depth > 0 ? text_.find_first_of("\"[]{}", at_) : at_, text_.size());
      if (at_ == text_.size()) return;
      const char c = text_[at_];
      if (c == '"') {
        skip_string();
      } else if (c == '[' || c == '{') {
        ++depth;
        ++at_;
      } else if (c == ']' || c == '}') {
        --depth;
        ++at_;
      } else {
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_ + 1), text_.size());
      }
    } while (depth > 0);
    skip_space();
  }

  /// Goes to the element or member of that name in the value that starts here; false if there is none.
  bool enter(std::string_view name) {
    if (is_at('[')) {
      std::size_t index = 0;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
      if (error != std::errc() || end != name.data() + name.size()) return false;
      for (skip_mark(); at_ < text_.size() && !is_at(']'); skip_mark()) {
        if (index-- == 0) return true;
        skip_value();
        if (!is_at(',')) return false;
      }
    } else if (is_at('{')) {
      for (skip_mark(); is_at('"'); skip_mark()) {
        const std::string_view found = skip_string();
        skip_space();
        skip_mark();  // the colon
        if (found == name) return at_ < text_.size();
        skip_value();
        if (!is_at(',')) return false;
      }
    }
    return false;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

std::string unescaped(std::string_view token) {
  std::string name;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const bool is_escape = token[i] == '~' && i + 1 < token.size();
    name += !is_escape ? token[i] : token[++i] == '1' ? '/' : '~';
  }
  return name;
}

}  // namespace

std::string with_column(const std::string& text, const DocumentPlace& place) {
  return text + " (column " + std::to_string(place.column) + ")";
}

DocumentPlace place_of_byte(std::string_view json, std::size_t at) {
  const std::string_view before = json.substr(0, at);
  const std::size_t line_end = before.rfind('\n');
  const std::size_t start = line_end == std::string_view::npos ? 0 : line_end + 1;
  return {1 + static_cast<long>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<long>(before.size() - start)};
}

DocumentPlace find_place(std::string_view json, std::string_view pointer) {
  Skimmer in(json);
  in.skip_space();
  std::size_t found = in.at();
  while (!pointer.empty() && pointer.front() == '/') {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    if (!in.enter(unescaped(pointer.substr(1, end - 1)))) break;
    found = in.at();
    pointer.remove_prefix(end);
  }
  return place_of_byte(json, found);
}

}  // namespace pliant
