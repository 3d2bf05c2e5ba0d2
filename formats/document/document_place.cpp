// formats/document/document_place.cpp: passes over a document without making values of it.
#include "formats/document/document_place.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "formats/document/cbor/cbor_items.h"
#include "formats/document/characters.h"
#include "formats/document/document_form.h"

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

/// The byte at which the value starts; what is left of the pointer comes back in it.
std::size_t find_json_value(std::string_view json, std::string_view& pointer) {
  Skimmer in(json);
  in.skip_space();
  std::size_t found = in.at();
  while (!pointer.empty() && pointer.front() == '/') {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    if (!in.enter(unescape_step(pointer.substr(1, end - 1)))) break;
    found = in.at();
    pointer.remove_prefix(end);
  }
  return found;
}

std::size_t find_value(std::string_view document, std::string_view& pointer) {
  return form_of(document) == DocumentForm::cbor ? find_cbor_value(document, pointer)
                                                 : find_json_value(document, pointer);
}

DocumentPlace place_of_cbor_byte(std::size_t at) { return {1, 1, static_cast<std::int64_t>(at)}; }

/// The byte of the number that `step` ("/7") names in an array of numbers of one width; the array's if it has none.
std::size_t find_number(const NumberArray& array, std::string_view step) {
  std::size_t index = 0;
  if (array.width == 0 || step.size() < 2) return array.begin;
  const auto [end, error] = std::from_chars(step.data() + 1, step.data() + step.size(), index);
  const bool is_there =
      error == std::errc() && end == step.data() + step.size() && index < (array.end - array.first) / array.width;
  return is_there ? array.first + index * array.width : array.begin;
}

/// The typed array of CBOR that starts at this byte; without a width if there is none.
NumberArray typed_array_at(std::string_view cbor, std::size_t at) {
  NumberArray array{at, at};
  const auto tag = read_cbor_head(cbor.substr(at));
  if (!tag || tag->major != 6 || !is_typed_array(tag->value)) return array;
  const auto bytes = read_cbor_head(cbor.substr(at + tag->size));
  if (!bytes || bytes->major != 2 || bytes->is_indefinite()) return array;
  array.first = at + tag->size + bytes->size;
  array.end = array.first + std::min<std::uint64_t>(bytes->value, cbor.size() - array.first);
  array.width = typed_width(tag->value);
  return array;
}

}  // namespace

std::string with_offset(const std::string& text, const DocumentPlace& place) {
  return text +
         (place.byte >= 0 ? " (byte " + std::to_string(place.byte) : " (column " + std::to_string(place.column)) + ")";
}

DocumentPlace place_of_byte(std::string_view json, std::size_t at) {
  const std::string_view before = json.substr(0, at);
  const std::size_t line_end = before.rfind('\n');
  const std::size_t start = line_end == std::string_view::npos ? 0 : line_end + 1;
  return {1 + static_cast<long>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<long>(before.size() - start)};
}

DocumentPlace find_place(std::string_view document, std::string_view pointer) {
  const std::size_t found = find_value(document, pointer);
  if (form_of(document) == DocumentForm::json) return place_of_byte(document, found);
  return place_of_cbor_byte(find_number(typed_array_at(document, found), pointer));
}

DocumentOutline::DocumentOutline(std::string_view document, const std::vector<NumberArray>& arrays) {
  const std::string_view empty_array = form_of(document) == DocumentForm::cbor ? "\x80" : "[]";
  std::size_t done = 0;
  long lines = 0;
  std::size_t line_start = 0;
  const auto pass = [&](std::string_view text, std::size_t begin) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string_view::npos; ++lines) line_start = begin + ++at;
  };
  for (const NumberArray& array : arrays) {
    const std::string_view between = document.substr(done, array.begin - done);
    text_ += between;
    if (form_of(document) == DocumentForm::json) {
      pass(between, done);
      pass(document.substr(array.begin, array.end - array.begin), array.begin);
    }
    cuts_.push_back({array, text_.size(), lines, line_start});
    text_ += empty_array;
    done = array.end;
  }
  text_ += document.substr(std::min(done, document.size()));
}

DocumentPlace DocumentOutline::find(std::string_view pointer) const {
  std::size_t found = find_value(text_, pointer);
  const auto next = std::ranges::upper_bound(cuts_, found, {}, &Cut::at);
  const bool is_cbor = form_of(text_) == DocumentForm::cbor;
  if (is_cbor) found = find_number(typed_array_at(text_, found), pointer);  // a short array is still there
  if (next == cuts_.begin()) return is_cbor ? place_of_cbor_byte(found) : place_of_byte(text_, found);
  const Cut& cut = *std::prev(next);
  const std::size_t stands_for_it = is_cbor ? 1 : 2;
  const bool is_array = found == cut.at;
  const std::size_t byte =
      is_array ? find_number(cut.array, pointer) : cut.array.end + (found - cut.at - stands_for_it);
  if (is_cbor) return place_of_cbor_byte(byte);
  if (is_array) {  // its place is where it begins, while the cut counts to its end
    const Cut before = next - cuts_.begin() >= 2 ? *std::prev(next, 2) : Cut{};
    const std::size_t from = next - cuts_.begin() >= 2 ? before.at + stands_for_it : 0;
    const DocumentPlace inner = place_of_byte(std::string_view(text_).substr(from), cut.at - from);
    const long column = inner.line > 1 ? inner.column : static_cast<long>(byte - before.line_start) + 1;
    return {before.lines + inner.line, column};
  }
  const std::size_t from = cut.at + stands_for_it;
  const DocumentPlace inner = place_of_byte(std::string_view(text_).substr(from), found - from);
  const long column = inner.line > 1 ? inner.column : static_cast<long>(byte - cut.line_start) + 1;
  return {cut.lines + inner.line, column};
}

}  // namespace pliant
