// formats/document/cbor/write_cbor.cpp: heads, numbers and typed arrays of CBOR.
#include "formats/document/cbor/write_cbor.h"

#include <algorithm>
#include <bit>

namespace pliant {
namespace {

constexpr int unsigned_integer = 0, negative_integer = 1, bytes_major = 2, text_major = 3, tag_major = 6;
constexpr int uint32_le = 70, sint32_le = 78, float64_le = 86;

void append_big_endian(std::string& out, std::uint64_t value, int bytes) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xFF);
}

}  // namespace

void CborWriter::head(int major, std::uint64_t value) {
  const auto put_head = [&](int info) { out_ += static_cast<char>(major << 5 | info); };
  if (value < 24) return put_head(static_cast<int>(value));
  const int width = value < 0x100 ? 0 : value < 0x10000 ? 1 : value < 0x100000000 ? 2 : 3;
  put_head(24 + width);
  append_big_endian(out_, value, 1 << width);
}

CborWriter& CborWriter::value(double number) {
  require_finite({&number, 1});
  out_ += '\xFB';
  append_big_endian(out_, std::bit_cast<std::uint64_t>(number), 8);
  return *this;
}

CborWriter& CborWriter::value(std::int64_t number) {
  if (number < 0)
    head(negative_integer, ~static_cast<std::uint64_t>(number));  // -1 - number
  else
    head(unsigned_integer, static_cast<std::uint64_t>(number));
  return *this;
}

CborWriter& CborWriter::value(std::uint64_t number) { return head(unsigned_integer, number), *this; }

CborWriter& CborWriter::value(std::string_view text) {
  head(text_major, text.size());
  out_ += text;
  relieve();
  return *this;
}

CborWriter& CborWriter::typed(int tag, const void* bytes, std::size_t size, std::size_t width) {
  head(tag_major, static_cast<std::uint64_t>(tag));
  head(bytes_major, size);
  const auto* const first = static_cast<const char*>(bytes);
  if constexpr (std::endian::native == std::endian::little) {
    constexpr std::size_t large = 1 << 18;
    if (sink_ != nullptr && size >= large) {
      flush();
      (*sink_)({first, size});
    } else if (size > 0) {
      out_.append(first, size);
    }
  } else {
    for (std::size_t at = 0; at < size; at += width) {
      for (std::size_t k = width; k > 0; --k) out_ += first[at + k - 1];
      relieve();
    }
  }
  relieve();
  return *this;
}

CborWriter& CborWriter::numbers(std::span<const double> values) {
  require_finite(values);
  return typed(float64_le, values.data(), values.size_bytes(), sizeof(double));
}

CborWriter& CborWriter::integers(std::span<const std::int32_t> values) {
  const bool has_negative = std::any_of(values.begin(), values.end(), [](std::int32_t value) { return value < 0; });
  return typed(has_negative ? sint32_le : uint32_le, values.data(), values.size_bytes(), sizeof(std::int32_t));
}

CborWriter& CborWriter::points(std::span<const Point> points) {
  static_assert(sizeof(Point) == 2 * sizeof(double), "x and y, and nothing else");
  for (const Point& p : points) require_finite(std::array{p.x, p.y});
  return typed(float64_le, points.data(), points.size_bytes(), sizeof(double));
}

void CborWriter::end() {
  if (sink_ != nullptr) flush();
}

}  // namespace pliant
