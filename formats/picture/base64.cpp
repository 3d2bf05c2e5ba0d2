// formats/picture/base64.cpp: turns three bytes of numbers at a time into four letters.
#include "formats/picture/base64.h"

#include <bit>
#include <vector>

namespace pliant {
namespace {

template <class Bits>
void append_little_endian(Bits bits, std::vector<unsigned char>& bytes) {
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes.push_back(static_cast<unsigned char>(bits >> (8 * k) & 255));
}

}  // namespace

void append_base64(std::span<const unsigned char> bytes, std::string& out) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t start = out.size(), groups = (bytes.size() + 2) / 3;
  out.resize(start + 4 * groups, '=');
  char* to = out.data() + start;
  for (std::size_t k = 0; k < bytes.size(); k += 3, to += 4) {
    const std::size_t left = bytes.size() - k;
    const unsigned group = unsigned{bytes[k]} << 16 | (left > 1 ? unsigned{bytes[k + 1]} << 8 : 0U) |
                           (left > 2 ? unsigned{bytes[k + 2]} : 0U);
    to[0] = digits[group >> 18];
    to[1] = digits[group >> 12 & 63];
    if (left > 1) to[2] = digits[group >> 6 & 63];
    if (left > 2) to[3] = digits[group & 63];
  }
}

void append_base64(std::span<const double> numbers, std::string& out) {
  std::vector<unsigned char> bytes;
  bytes.reserve(8 * numbers.size());
  for (const double number : numbers) append_little_endian(std::bit_cast<std::uint64_t>(number), bytes);
  append_base64(bytes, out);
}

void append_base64(std::span<const std::int32_t> numbers, std::string& out) {
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * numbers.size());
  for (const std::int32_t number : numbers) append_little_endian(static_cast<std::uint32_t>(number), bytes);
  append_base64(bytes, out);
}

}  // namespace pliant
