// formats/vtu/vtu_array.h: numbers as VTK's XML files hold them: blocks of little-endian bytes, each compressed by
// zlib.
#pragma once
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace pliant {

/// Compresses one block at a time. Its memory (some 260 kB) serves any number of arrays.
class BlockCompressor {
 public:
  BlockCompressor();  ///< Throws std::bad_alloc
  ~BlockCompressor();
  BlockCompressor(const BlockCompressor&) = delete;
  BlockCompressor& operator=(const BlockCompressor&) = delete;
  /// Appends the block in zlib's format (RFC 1950), and returns how many bytes that takes.
  std::size_t append(std::string_view block, std::string& out);

 private:
  std::unique_ptr<z_stream_s> stream_;
};

/// One array, to which numbers of one type are added in order. Only the compressed bytes and one block are in memory.
class VtuArray {
 public:
  explicit VtuArray(BlockCompressor& compressor) : compressor_(&compressor) {}

  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  void put(Number number) {
    if (used_ == block_.size()) make_room();
    if constexpr (sizeof(Number) == 8)
      put_bits(std::bit_cast<std::uint64_t>(number));
    else if constexpr (sizeof(Number) == 4)
      put_bits(std::bit_cast<std::uint32_t>(number));
    else
      put_bits(static_cast<unsigned char>(number));
  }
  /// Adds the bytes of a text and a zero, as arrays of strings have them.
  void put_string(std::string_view text);

  /// The array as it stands in a file: the number of blocks, their size, that of the last one if it is smaller, the
  /// compressed sizes, each as 8 bytes, and the compressed blocks. Nothing may be added afterwards.
  std::vector<std::string> finish();

 private:
  template <class Bits>
  void put_bits(Bits bits) {
    if constexpr (std::endian::native == std::endian::little)
      std::memcpy(&block_[used_], &bits, sizeof(Bits));
    else
      for (std::size_t k = 0; k < sizeof(Bits); ++k) block_[used_ + k] = static_cast<char>(bits >> (8 * k) & 255);
    used_ += sizeof(Bits);
  }
  void make_room();
  void close_block();

  BlockCompressor* compressor_;
  std::string block_;  // grows up to the size of a block, of which a number is never cut
  std::size_t used_ = 0;
  std::string compressed_;
  std::vector<std::uint64_t> sizes_;
};

}  // namespace pliant
