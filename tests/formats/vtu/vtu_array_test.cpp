// tests/formats/vtu/vtu_array_test.cpp: blocks of any number of numbers, inflated again.
#include "formats/vtu/vtu_array.h"

#include <zlib.h>

#include <catch2/catch.hpp>

using namespace pliant;

namespace {

constexpr std::size_t block = std::size_t{1} << 18;

std::uint64_t number_at(const std::string& bytes, std::size_t k) {
  std::uint64_t number = 0;
  for (std::size_t b = 8; b-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[8 * k + b]);
  return number;
}

/// The bytes that were compressed, after a check of the header.
std::string inflate_all(const std::vector<std::string>& parts) {
  const std::string& header = parts.at(0);
  const std::uint64_t blocks = number_at(header, 0), last = number_at(header, 2);
  REQUIRE(header.size() == 8 * (3 + blocks));
  CHECK(number_at(header, 1) == block);
  std::string all;
  std::size_t from = 0;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    std::string part(block, '\0');
    uLongf size = block;
    const std::uint64_t packed = number_at(header, 3 + k);
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(part.data()), &size,
                       reinterpret_cast<const Bytef*>(parts.at(1).data() + from), packed) == Z_OK);
    CHECK(size == (k + 1 == blocks && last > 0 ? last : block));
    all += part.substr(0, size);
    from += packed;
  }
  CHECK(from == parts.at(1).size());
  return all;
}

}  // namespace

TEST_CASE("arrays of any number of blocks, full or not, inflate to their numbers", "[formats][vtu]") {
  const std::size_t full = block / 8;
  const std::size_t count =
      GENERATE_COPY(std::size_t{0}, std::size_t{1}, std::size_t{9}, full - 1, full, full + 1, 2 * full, 2 * full + 3);
  CAPTURE(count);
  BlockCompressor compressor;
  VtuArray array(compressor);
  for (std::size_t k = 0; k < count; ++k) array.put(std::uint64_t{k * k});
  const std::string bytes = inflate_all(array.finish());
  REQUIRE(bytes.size() == 8 * count);
  for (std::size_t k = 0; k < count; ++k) REQUIRE(number_at(bytes, k) == k * k);
}

TEST_CASE("numbers stand with their least significant byte first", "[formats][vtu]") {
  BlockCompressor compressor;
  VtuArray doubles(compressor), ints(compressor), bytes(compressor), words(compressor);
  doubles.put(-2.0);
  ints.put(std::int32_t{0x01020304});
  bytes.put(static_cast<unsigned char>(200));
  words.put_string("ab");
  words.put_string("");
  CHECK(inflate_all(doubles.finish()) == std::string("\0\0\0\0\0\0\0\xC0", 8));
  CHECK(inflate_all(ints.finish()) == "\4\3\2\1");
  CHECK(inflate_all(bytes.finish()) == "\xC8");
  CHECK(inflate_all(words.finish()) == std::string("ab\0\0", 4));
}

TEST_CASE("arrays that grow side by side do not mix", "[formats][vtu]") {
  BlockCompressor compressor;
  std::vector<VtuArray> arrays(3, VtuArray(compressor));
  const std::size_t count = block / 8 + 5;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t a = 0; a < 3; ++a) arrays[a].put(std::uint64_t{3 * k + a});
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string bytes = inflate_all(arrays[a].finish());
    REQUIRE(bytes.size() == 8 * count);
    for (std::size_t k = 0; k < count; ++k) REQUIRE(number_at(bytes, k) == 3 * k + a);
  }
}
