// formats/document/cbor/cbor_numbers.h: the numbers of typed arrays, at any address, in either order of bytes.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace pliant {

/// The half-precision number of these bits.
inline double half_to_double(std::uint16_t bits) {
  constexpr int exponent_bits = 31, fraction_bits = 10;
  const int exponent = bits >> fraction_bits & exponent_bits;
  const int fraction = bits & ((1 << fraction_bits) - 1);
  double value = std::ldexp(fraction + (exponent > 0 ? 1 << fraction_bits : 0), std::max(exponent, 1) - 25);
  if (exponent == exponent_bits)
    value = fraction == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  return (bits & 0x8000) != 0 ? -value : value;
}

struct HalfFloat {};

/// Numbers of one type in the bytes of a typed array.
template <class T, bool is_little>
struct TypedNumbers {
  using Bits = std::conditional_t<std::is_same_v<T, HalfFloat> || sizeof(T) == 2, std::uint16_t,
                                  std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                                     std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;
  static constexpr std::size_t width = sizeof(Bits);
  static constexpr bool is_float = std::is_same_v<T, HalfFloat> || std::is_floating_point_v<T>;
  using Value = std::conditional_t<std::is_same_v<T, HalfFloat>, double, T>;

  static Value at(const char* p) {
    Bits bits;
    std::memcpy(&bits, p, width);
    if constexpr (is_little != (std::endian::native == std::endian::little) && width > 1) {
      if constexpr (width == 2) bits = __builtin_bswap16(bits);
      if constexpr (width == 4) bits = __builtin_bswap32(bits);
      if constexpr (width == 8) bits = __builtin_bswap64(bits);
    }
    if constexpr (std::is_same_v<T, HalfFloat>)
      return half_to_double(bits);
    else
      return std::bit_cast<T>(bits);
  }
};

/// Calls use(TypedNumbers<...>{}) for the tag of a typed array; false for the types that are not read (128 bits).
template <class Use>
bool with_typed_numbers(int tag, Use use) {
  switch (tag) {
    case 64:
    case 68:
      return use(TypedNumbers<std::uint8_t, true>{}), true;
    case 65:
      return use(TypedNumbers<std::uint16_t, false>{}), true;
    case 66:
      return use(TypedNumbers<std::uint32_t, false>{}), true;
    case 67:
      return use(TypedNumbers<std::uint64_t, false>{}), true;
    case 69:
      return use(TypedNumbers<std::uint16_t, true>{}), true;
    case 70:
      return use(TypedNumbers<std::uint32_t, true>{}), true;
    case 71:
      return use(TypedNumbers<std::uint64_t, true>{}), true;
    case 72:
      return use(TypedNumbers<std::int8_t, true>{}), true;
    case 73:
      return use(TypedNumbers<std::int16_t, false>{}), true;
    case 74:
      return use(TypedNumbers<std::int32_t, false>{}), true;
    case 75:
      return use(TypedNumbers<std::int64_t, false>{}), true;
    case 77:
      return use(TypedNumbers<std::int16_t, true>{}), true;
    case 78:
      return use(TypedNumbers<std::int32_t, true>{}), true;
    case 79:
      return use(TypedNumbers<std::int64_t, true>{}), true;
    case 80:
      return use(TypedNumbers<HalfFloat, false>{}), true;
    case 81:
      return use(TypedNumbers<float, false>{}), true;
    case 82:
      return use(TypedNumbers<double, false>{}), true;
    case 84:
      return use(TypedNumbers<HalfFloat, true>{}), true;
    case 85:
      return use(TypedNumbers<float, true>{}), true;
    case 86:
      return use(TypedNumbers<double, true>{}), true;
    default:
      return false;
  }
}

/// Can the number be an integer of 32 bits, or, for doubles, is it finite? The least integer, -2^31, cannot: as in
/// JSON, a number fits if its negative does.
template <class Scalar, class Value>
bool fits(Value value) {
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  if constexpr (std::is_same_v<Scalar, double> && std::is_floating_point_v<Value>)
    return std::isfinite(value);
  else if constexpr (std::is_same_v<Scalar, double>)
    return true;
  else if constexpr (std::is_floating_point_v<Value>)
    return std::abs(static_cast<double>(value)) <= most && value == std::floor(value);
  else
    return std::cmp_less_equal(value, most) && std::cmp_greater_equal(value, -most);
}

}  // namespace pliant
