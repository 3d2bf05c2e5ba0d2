// formats/document/cbor/read_cbor.cpp: objects, arrays, scalars and faults of a document in CBOR.
#include "formats/document/cbor/read_cbor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "formats/document/cbor/cbor_numbers.h"
#include "formats/document/characters.h"

namespace pliant {
namespace {

enum Major { unsigned_integer, negative_integer, byte_string, text_string, array_major, map_major, tag_major, simple };
constexpr int false_info = 20, true_info = 21, null_info = 22, undefined_info = 23;

}  // namespace

// -- faults

DocumentPlace CborReader::place_of(const std::string& pointer) const {
  return find_place({begin_, static_cast<std::size_t>(end_ - begin_)}, pointer);
}

void CborReader::fail_at(const char* where, const std::string& text) const {
  const bool is_copy = where < begin_ || where > end_;
  DocumentPlace place;
  place.byte = (is_copy ? joined_at_ : where) - begin_;
  throw DocumentError(pointer(), text, place);
}

std::string CborReader::found() const {
  if (element_ != 0) return "found a number";
  if (at_ == end_) return at_ == begin_ ? "but the document is empty" : "but the document ends";
  const auto head = read_cbor_head({at_, static_cast<std::size_t>(end_ - at_)});
  if (!head) return "but the document ends";
  switch (head->major) {
    case unsigned_integer:
    case negative_integer:
      return "found a number";
    case byte_string:
      return "found a byte string, which documents have only in typed arrays";
    case text_string:
      return "found a string";
    case array_major:
      return "found an array";
    case map_major:
      return "found an object";
    case tag_major:
      return is_typed_array(head->value) ? "found an array of numbers" : "found tag " + std::to_string(head->value);
    default:
      if (head->is_break()) return "found a break, which ends no value here";
      if (head->info >= 25) return "found a number";
      if (head->info == false_info || head->info == true_info) return "found a boolean";
      if (head->info == null_info) return "found null";
      if (head->info == undefined_info) return "found undefined, which JSON does not have";
      return "found simple value " + std::to_string(head->value) + ", which JSON does not have";
  }
}

// -- heads and tags

CborHead CborReader::head(const char* what) const {
  if (element_ != 0) fault(std::string(what) + ", " + found());  // the bytes here are a number without a head
  const auto head = read_cbor_head({at_, static_cast<std::size_t>(end_ - at_)});
  if (!head) fault(std::string(what) + ", " + found());
  if (head->is_wrong()) fault("is no CBOR: the first byte of an item cannot be this one");
  return *head;
}

void CborReader::pass_tags() {
  if (element_ != 0) return;
  while (at_ != end_) {
    const auto tag = read_cbor_head({at_, static_cast<std::size_t>(end_ - at_)});
    if (!tag || tag->major != tag_major || is_typed_array(tag->value)) return;
    const bool is_known = (tag->value == self_described_cbor && at_ == begin_) || tag->value == homogeneous_array;
    if (tag->is_wrong() || !is_known)
      fault("has tag " + std::to_string(tag->value) +
            ", which would be lost: documents have only the tags of typed arrays");
    at_ += tag->size;
  }
}

bool CborReader::is_at_typed() const {
  if (element_ != 0) return false;
  const auto tag = read_cbor_head({at_, static_cast<std::size_t>(end_ - at_)});
  return tag && tag->major == tag_major && is_typed_array(tag->value);
}

CborReader::Typed CborReader::take_typed(const char* what) {
  const char* const start = at_;
  const CborHead tag = head(what);
  at_ += tag.size;
  Typed array{static_cast<int>(tag.value), {}, nullptr};
  const bool is_read = with_typed_numbers(array.tag, [](auto) {});
  if (!is_read) fail_at(start, "has tag " + std::to_string(tag.value) + ": numbers of this type are not read");
  const CborHead bytes = head("the numbers of a typed array should follow");
  if (bytes.major != byte_string) fault("should be the byte string of a typed array, " + found());
  at_ += bytes.size;
  const auto take = [&](std::uint64_t size) {
    if (size > static_cast<std::uint64_t>(end_ - at_))
      fault("the numbers of a typed array should go on, but the document ends");
    const std::string_view piece(at_, size);
    at_ += size;
    return piece;
  };
  if (!bytes.is_indefinite()) {
    array.bytes = take(bytes.value);
  } else {
    std::string& copy = copies_.emplace_back();
    for (;;) {
      const CborHead chunk = head("the numbers of a typed array should go on");
      if (chunk.is_break()) break;
      if (chunk.major != byte_string || chunk.is_indefinite()) fault("should be a chunk of a byte string, " + found());
      at_ += chunk.size;
      copy += take(chunk.value);
    }
    ++at_;
    array.bytes = copy;
    joined_at_ = start;
  }
  array.end = at_;
  if (array.bytes.size() % typed_width(tag.value) != 0)
    fail_at(start, "has " + std::to_string(array.bytes.size()) + " bytes, which are no whole numbers of " +
                       std::to_string(typed_width(tag.value)) + " bytes");
  return array;
}

void CborReader::require_depth() const {
  if (path_.size() >= max_depth) fault("is nested more than " + std::to_string(max_depth) + " deep");
}

// -- structure

void CborReader::open_object(Container& object) {
  pass_tags();
  const CborHead map = head("should be an object");
  if (map.major != map_major) fault("should be an object, " + found());
  require_depth();
  object.left = map.value;
  object.is_indefinite = map.is_indefinite();
  at_ += map.size;
}

bool CborReader::is_at_end_of(Container& container) {
  if (!container.is_indefinite) return container.left-- == 0;
  if (at_ == end_) fault("should go on or end, but the document ends");
  if (*at_ != '\xFF') return false;
  ++at_;
  return true;
}

bool CborReader::next_member(Container& object, Names& names, std::string_view& name) {
  if (is_at_end_of(object)) return false;
  name = text("expected a member's name, a text string");
  if (!names.add(name)) fault("has the member \"" + std::string(name) + "\" twice");
  return true;
}

void CborReader::open_array(Container& array) {
  pass_tags();
  if (is_at_typed()) {
    require_depth();
    const Typed typed = take_typed("should be an array");
    array.element = typed.tag;
    array.left = typed.count();
    array.end = typed.end;
    at_ = typed.bytes.data();
    return;
  }
  const CborHead head = this->head("should be an array");
  if (head.major != array_major) fault("should be an array, " + found());
  require_depth();
  array.left = head.value;
  array.is_indefinite = head.is_indefinite();
  at_ += head.size;
}

bool CborReader::next_element(Container& array) {
  if (array.element == 0) return !is_at_end_of(array);
  element_ = array.element;
  if (array.left-- > 0) return true;
  element_ = 0;
  at_ = array.end;
  return false;
}

void CborReader::finish() {
  if (at_ != end_) fault("nothing may follow the document, " + found());
}

// -- scalars

DocumentReader::Kind CborReader::kind() {
  pass_tags();
  if (element_ != 0) return Kind::number;
  if (is_at_typed()) return Kind::array;
  const auto next = read_cbor_head({at_, static_cast<std::size_t>(end_ - at_)});
  if (!next || next->is_wrong()) return Kind::nothing;
  switch (next->major) {
    case unsigned_integer:
    case negative_integer:
      return Kind::number;
    case text_string:
      return Kind::string;
    case array_major:
      return Kind::array;
    case map_major:
      return Kind::object;
    case simple:
      if (next->info == false_info || next->info == true_info) return Kind::boolean;
      if (next->info == null_info) return Kind::null;
      return next->info >= 25 && !next->is_break() ? Kind::number : Kind::nothing;
    default:
      return Kind::nothing;
  }
}

std::string_view CborReader::text(const char* what) {
  pass_tags();
  const char* const start = at_;
  const CborHead first = head(what);
  if (first.major != text_string) fault(std::string(what) + ", " + found());
  at_ += first.size;
  const auto take = [&](std::uint64_t size) {
    if (size > static_cast<std::uint64_t>(end_ - at_)) fail_at(start, "a string should go on, but the document ends");
    const std::string_view piece(at_, size);
    if (const char* wrong = find_no_utf8(piece)) fail_at(wrong, "is not UTF-8");
    at_ += size;
    return piece;
  };
  if (!first.is_indefinite()) return take(first.value);
  std::string& copy = copies_.emplace_back();
  for (;;) {
    const CborHead chunk = head("a string should go on");
    if (chunk.is_break()) break;
    if (chunk.major != text_string || chunk.is_indefinite()) fault("should be a chunk of a string, " + found());
    at_ += chunk.size;
    copy += take(chunk.value);
  }
  ++at_;
  return copy;
}

std::string CborReader::string() { return std::string(text("should be a string")); }

bool CborReader::boolean() {
  if (kind() != Kind::boolean) fault("should be true or false, " + found());
  return (*at_++ & 31) == true_info;
}

bool CborReader::null() {
  if (kind() != Kind::null) return false;
  ++at_;
  return true;
}

// -- numbers

CborReader::Number CborReader::element_of_typed() {
  Number number;
  with_typed_numbers(element_, [&](auto type) {
    const auto value = type.at(at_);
    if constexpr (std::is_floating_point_v<decltype(value)>)
      number = static_cast<double>(value);
    else if (value < 0)
      number = static_cast<std::int64_t>(value);
    else
      number = static_cast<std::uint64_t>(value);
  });
  at_ += typed_width(static_cast<std::uint64_t>(element_));
  element_ = 0;
  return number;
}

CborReader::Number CborReader::take_number(const char* what) {
  const auto finite = [this](const char* where, double value) {
    if (!std::isfinite(value)) fail_at(where, "is no finite number");
    return value;
  };
  pass_tags();
  const char* const start = at_;
  if (element_ != 0) {
    const Number number = element_of_typed();
    if (const double* value = std::get_if<double>(&number)) finite(start, *value);
    return number;
  }
  const CborHead next = head(what);
  const bool is_float = next.major == simple && next.info >= 25 && next.info <= 27;
  if (next.major > negative_integer && !is_float) fault(std::string(what) + ", " + found());
  at_ += next.size;
  if (next.major == unsigned_integer) return next.value;
  if (next.major == negative_integer) {
    if (next.value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
      return static_cast<std::int64_t>(~next.value);
    constexpr double two_to_64 = 0x1p64;
    return next.value + 1 == 0 ? -two_to_64 : -static_cast<double>(next.value + 1);
  }
  if (next.info == 25) return finite(start, half_to_double(static_cast<std::uint16_t>(next.value)));
  if (next.info == 26) return finite(start, std::bit_cast<float>(static_cast<std::uint32_t>(next.value)));
  return finite(start, std::bit_cast<double>(next.value));
}

std::variant<double, std::int64_t, std::uint64_t> CborReader::any_number() { return take_number("expected a value"); }

double CborReader::number() {
  return std::visit([](auto value) { return static_cast<double>(value); }, take_number("should be a number"));
}

std::int32_t CborReader::to_integer(const Number& number, const char* where) const {
  return std::visit(
      [&](auto value) {
        if (!fits<std::int32_t>(value))
          fail_at(where, static_cast<double>(value) != std::floor(static_cast<double>(value))
                             ? "should be an integer"
                             : "is beyond the integers of 32 bits");
        return static_cast<std::int32_t>(value);
      },
      number);
}

std::int32_t CborReader::integer() {
  const char* const start = at_;
  return to_integer(take_number("should be an integer"), start);
}

}  // namespace pliant
