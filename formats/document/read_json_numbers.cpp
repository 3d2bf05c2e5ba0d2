// formats/document/read_json_numbers.cpp: numbers by the grammar of RFC 8259, one or many.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>

#include "formats/document/characters.h"
#include "formats/document/read_json.h"

namespace pliant {
namespace {

/// Powers of ten that doubles hold exactly.
constexpr std::array<double, 23> exact_powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exact_integers = std::uint64_t{1} << 53;

/// The value of the eight bytes at `p` if all are digits; they are the digits of one word, and worked on side by side.
std::optional<std::uint64_t> eight_digits(const char* p) {
  if constexpr (std::endian::native != std::endian::little) return {};
  std::uint64_t word;
  std::memcpy(&word, p, sizeof word);
  constexpr std::uint64_t high_halves = 0xF0F0F0F0F0F0F0F0;
  const std::uint64_t carried = word + 0x0606060606060606;  // bytes above '9' change their high half
  if (((word & high_halves) | (carried & high_halves) >> 4) != 0x3333333333333333) return {};
  word -= 0x3030303030303030;
  word = word * 10 + (word >> 8);  // pairs of digits, in every other byte
  constexpr std::uint64_t pairs = 0x000000FF000000FF;
  constexpr std::uint64_t first_weights = 100 + (1000000ULL << 32), second_weights = 1 + (10000ULL << 32);
  return ((word & pairs) * first_weights + ((word >> 16) & pairs) * second_weights) >> 32;
}

/// The parts of a number's text: its end, and its value as mantissa * 10^exponent where `digits` <= 19.
struct Scanned {
  const char* end;
  std::uint64_t mantissa;  // of all digits, wrapped if there are more than 19
  std::ptrdiff_t digits;
  long exponent;
  bool integral;      // neither fraction nor exponent
  const char* fault;  // null if the text is a number of JSON
};

Scanned scan_number(const char* p, const char* end) {
  Scanned s{p, 0, 0, 0, true, nullptr};
  const auto eat_digits = [&] {
    const char* first = p;
    while (p != end && is_digit(*p)) s.mantissa = 10 * s.mantissa + static_cast<std::uint64_t>(*p++ - '0');
    return p - first;
  };
  const auto stop = [&](const char* fault) {
    s.end = p;
    s.fault = fault;
    return s;
  };
  if (p != end && *p == '-') ++p;
  const char* first = p;
  s.digits = eat_digits();
  if (s.digits == 0) return stop("a number needs a digit here");
  if (s.digits > 1 && *first == '0') return stop("a number must not begin with zeros");
  if (p != end && *p == '.') {
    ++p;
    s.integral = false;
    const char* first_of_fraction = p;
    constexpr std::ptrdiff_t block = 8;
    for (std::optional<std::uint64_t> eight; end - p >= block && (eight = eight_digits(p)); p += block)
      s.mantissa = 100'000'000 * s.mantissa + *eight;
    eat_digits();
    const std::ptrdiff_t fraction = p - first_of_fraction;
    if (fraction == 0) return stop("a number needs a digit after its point");
    s.digits += fraction;
    s.exponent = -static_cast<long>(fraction);
  }
  if (p != end && (*p == 'e' || *p == 'E')) {
    ++p;
    s.integral = false;
    const bool negative = p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    if (p == end || !is_digit(*p)) return stop("a number needs a digit in its exponent");
    long exponent = 0;
    for (; p != end && is_digit(*p); ++p) exponent = std::min(100'000'000L, 10 * exponent + (*p - '0'));
    s.exponent += negative ? -exponent : exponent;
  }
  s.end = p;
  return s;
}

}  // namespace

double JsonReader::slow_number(const char* first, const char* last) const {
  double value = 0;
  if (std::from_chars(first, last, value).ec == std::errc()) return value;
  // Too large or too small for a double; strtod tells which, and rounds what is merely small.
  value = std::strtod(std::string(first, last).c_str(), nullptr);
  if (!std::isfinite(value)) fail_at(first, "is too large for a double");
  return value;
}

double JsonReader::read_number() {
  const Scanned s = scan_number(at_, end_);
  if (s.fault != nullptr) {
    if (*at_ != '-' && !is_digit(*at_)) syntax("should be a number, " + found());
    at_ = s.end;
    syntax(s.fault);
  }
  const char* first = at_;
  const bool negative = *first == '-';
  double value;
  if (s.digits <= 19 && s.mantissa <= exact_integers && std::abs(s.exponent) <= 22) {
    // One rounding of exact numbers (Clinger).
    const auto mantissa = static_cast<double>(s.mantissa);
    const double power = exact_powers[static_cast<std::size_t>(std::abs(s.exponent))];
    value = s.exponent < 0 ? mantissa / power : mantissa * power;
    if (negative) value = -value;
  } else {
    value = slow_number(first, s.end);
  }
  at_ = s.end;
  return value;
}

std::int32_t JsonReader::read_integer() {
  // Nearly all are indices in an array: at most nine digits, which fit, before a comma or a bracket.
  const char* p = at_;
  std::int32_t index = 0;
  for (const char* last = end_ - p > 9 ? p + 9 : end_; p != last && is_digit(*p); ++p) index = 10 * index + (*p - '0');
  const bool has_leading_zero = p - at_ > 1 && *at_ == '0';
  if (p != at_ && p != end_ && (*p == ',' || *p == ']') && !has_leading_zero) return at_ = p, index;
  const Scanned s = scan_number(at_, end_);
  constexpr auto limit = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  if (s.fault == nullptr && s.integral && s.digits <= 19 && s.mantissa <= limit) {
    const auto value = static_cast<std::int32_t>(s.mantissa);
    const bool negative = *at_ == '-';
    at_ = s.end;
    return negative ? -value : value;
  }
  const char* first = at_;
  const double value = read_number();
  if (value != std::floor(value)) fail_at(first, "should be an integer");
  if (std::abs(value) > static_cast<double>(limit)) fail_at(first, "is beyond the integers of 32 bits");
  return static_cast<std::int32_t>(value);
}

double JsonReader::number() {
  if (skip_space(); at_ == end_) syntax("should be a number, " + found());
  return read_number();
}

std::int32_t JsonReader::integer() {
  if (skip_space(); at_ == end_) syntax("should be an integer, " + found());
  return read_integer();
}

std::variant<double, std::int64_t, std::uint64_t> JsonReader::any_number() {
  if (skip_space(); at_ == end_ || (*at_ != '-' && !is_digit(*at_))) syntax("expected a value, " + found());
  const Scanned s = scan_number(at_, end_);
  // -0 is no integer: it would lose its sign.
  if (s.fault == nullptr && s.integral && !(*at_ == '-' && s.mantissa == 0)) {
    const auto read = [&](auto integer) {
      const bool fits = std::from_chars(at_, s.end, integer).ec == std::errc();
      return fits ? std::optional(integer) : std::nullopt;
    };
    if (*at_ == '-') {
      if (const auto integer = read(std::int64_t{})) return at_ = s.end, *integer;
    } else if (const auto integer = read(std::uint64_t{})) {
      return at_ = s.end, *integer;
    }
  }
  return read_number();
}

// -- bulk arrays

template <class Store>
void JsonReader::bulk(const char* what, Store store) {
  peek();
  const char* const start = at_;
  open('[', what);
  path_.push_back({{}, 0});
  for (bool first = true; next_value(']', first); first = false) {
    if (skip_space(); at_ == end_) syntax("should be a number, " + found());
    store();
    ++path_.back().index;
  }
  path_.pop_back();
  constexpr std::ptrdiff_t is_long = 256;
  if (at_ - start >= is_long)
    arrays_.push_back({static_cast<std::size_t>(start - begin_), static_cast<std::size_t>(at_ - begin_)});
}

void JsonReader::numbers(std::vector<double>& out) {
  bulk("an array of numbers", [&] { out.push_back(read_number()); });
}

void JsonReader::integers(std::vector<std::int32_t>& out) {
  bulk("an array of integers", [&] { out.push_back(read_integer()); });
}

void JsonReader::points(std::vector<Point>& out) {
  bool odd = false;
  bulk("an array of numbers x0, y0, x1, ...", [&] {
    const double value = read_number();
    if (odd)
      out.back().y = value;
    else
      out.push_back({value, 0});
    odd = !odd;
  });
  if (odd) fail("has an odd number of entries: its last x has no y");
}

void JsonReader::pairs(std::vector<std::array<std::int32_t, 2>>& out) {
  bool odd = false;
  bulk("an array of pairs of integers", [&] {
    const std::int32_t value = read_integer();
    if (odd)
      out.back()[1] = value;
    else
      out.push_back({value, 0});
    odd = !odd;
  });
  if (odd) fail("has an odd number of entries: they are pairs");
}

}  // namespace pliant
