// formats/msh/msh_cursor.cpp: a cursor over the bytes of an MSH file: numbers as text or binary, faults with place.
#include "formats/msh/msh_cursor.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "formats/document/characters.h"
#include "pliant/boundary/fault.h"

namespace pliant {
void MshCursor::skip_space() {
  while (at_ != end_ && is_space(*at_)) ++at_;
}

std::string_view MshCursor::line() {
  const char* stop = at_ == end_ ? nullptr : static_cast<const char*>(std::memchr(at_, '\n', left()));
  const char* last = stop == nullptr ? end_ : stop;
  std::string_view text(at_, static_cast<std::size_t>(last - at_));
  at_ = stop == nullptr ? end_ : stop + 1;
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

void MshCursor::end_line(const char* after) {
  while (at_ != end_ && (*at_ == ' ' || *at_ == '\r')) ++at_;
  if (at_ == end_ || *at_ != '\n') fail(std::string("expected a line end behind ") + after + ", found " + found());
  ++at_;
}

std::string_view MshCursor::word() {
  skip_space();
  const char* stop = std::find_if(at_, end_, is_space);
  const std::string_view text(at_, static_cast<std::size_t>(stop - at_));
  at_ = stop;
  return text;
}

void MshCursor::expect(std::string_view wanted, const char* why) {
  skip_space();
  if (std::string_view(at_, left()).substr(0, wanted.size()) != wanted)
    fail("expected " + std::string(wanted) + why + ", found " + found());
  at_ += wanted.size();
}

bool MshCursor::skip_behind(std::string_view wanted) {
  const std::string_view rest(at_, left());
  for (std::size_t from = 0;;) {
    const std::size_t place = rest.find(wanted, from);
    if (place == std::string_view::npos) return false;
    const std::size_t behind = place + wanted.size();
    if ((place == 0 ? at_ == begin_ || at_[-1] == '\n' : rest[place - 1] == '\n') &&
        (behind == rest.size() || is_space(rest[behind]))) {
      at_ += behind;
      return true;
    }
    from = behind;
  }
}

const char* MshCursor::take(std::size_t count, std::size_t each, const char* what) {
  const char* start = at_;
  at_ += room_for(count, each, what) * each;
  return start;
}

std::size_t MshCursor::room_for(std::uint64_t count, std::size_t least, const char* what) const {
  if (least != 0 && count > left() / least)
    fail("the file ends too early: " + std::to_string(count) + " " + what + " take at least " + std::to_string(least) +
         " bytes each, and " + std::to_string(left()) + " bytes are left");
  return static_cast<std::size_t>(count);
}

std::int64_t MshCursor::text_integer(const char* what) {
  skip_space();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(at_, end_, value);
  if (error == std::errc::result_out_of_range) fail(std::string(what) + " " + found() + " is too large");
  if (error != std::errc() || (stop != end_ && !is_space(*stop)))
    fail(std::string("expected ") + what + " (an integer), found " + found());
  at_ = stop;
  return value;
}

std::int32_t MshCursor::text_int(const char* what) {
  skip_space();
  const char* start = at_;
  const std::int64_t value = text_integer(what);
  if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
    fail_at(start, std::string(what) + " " + std::to_string(value) + " is too large");
  return static_cast<std::int32_t>(value);
}

std::uint64_t MshCursor::text_size(const char* what) {
  skip_space();
  const char* start = at_;
  const std::int64_t value = text_integer(what);
  if (value < 0) fail_at(start, std::string(what) + " " + std::to_string(value) + " is negative");
  return static_cast<std::uint64_t>(value);
}

double MshCursor::text_number(const char* what) {
  skip_space();
  double value = 0;
  const auto [stop, error] = std::from_chars(at_, end_, value);
  // A number too small for a double counts as 0.
  if (error == std::errc::result_out_of_range) {
    const std::string text(at_, stop);
    value = std::strtod(text.c_str(), nullptr);
  } else if (error != std::errc()) {
    fail(std::string("expected ") + what + " (a number), found " + found());
  }
  if (stop != end_ && !is_space(*stop)) fail(std::string("expected ") + what + " (a number), found " + found());
  at_ = stop;
  return value;
}

std::int32_t MshCursor::int32(const char* what) {
  if (!binary) return text_int(what);
  const char* p = take(1, sizeof(std::int32_t), what);
  return swapped ? load<std::int32_t, true>(p) : load<std::int32_t, false>(p);
}

std::uint64_t MshCursor::size(const char* what) {
  if (!binary) return text_size(what);
  const char* p = take(1, sizeof(std::uint64_t), what);
  return swapped ? load<std::uint64_t, true>(p) : load<std::uint64_t, false>(p);
}

double MshCursor::number(const char* what) {
  if (!binary) return text_number(what);
  const char* p = take(1, sizeof(double), what);
  return swapped ? load<double, true>(p) : load<double, false>(p);
}

void MshCursor::fail_at(const char* where, const std::string& text) const {
  throw InputError(
      binary ? "byte " + std::to_string(where - begin_) : "line " + std::to_string(1 + std::count(begin_, where, '\n')),
      text);
}

std::string MshCursor::found_at(const char* where) const {
  if (where == end_) return "the end of the file";
  constexpr std::ptrdiff_t most = 30;
  const char* stop = std::find_if(where, end_ - where > most ? where + most : end_, is_space);
  std::string text = "'";
  for (const char* p = where; p != stop; ++p) text += *p < 32 || *p == 127 ? '?' : *p;
  return text + "'";
}

}  // namespace pliant
