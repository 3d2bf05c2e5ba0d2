// formats/picture/base64.h: arrays of numbers as text, little-endian whatever the machine.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pliant {

/// Appends the bytes in the alphabet of RFC 4648, with padding.
void append_base64(std::span<const unsigned char> bytes, std::string& out);
/// Appends the numbers, each as 8, 4 or 1 bytes with the least significant byte first.
void append_base64(std::span<const double> numbers, std::string& out);
void append_base64(std::span<const std::int32_t> numbers, std::string& out);

}  // namespace pliant
