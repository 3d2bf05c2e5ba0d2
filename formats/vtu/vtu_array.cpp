// formats/vtu/vtu_array.cpp: numbers as blocks that zlib has compressed.
#include "formats/vtu/vtu_array.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <utility>

namespace pliant {
namespace {

/// Bytes of a block before compression: small enough to wait for, large beside what a block costs in the header.
constexpr std::size_t block_size = std::size_t{1} << 18;
/// Higher levels take several times as long; control points are little shorter then.
constexpr int compression_level = 1;

void append_little_endian(std::uint64_t number, std::string& out) {
  for (int k = 0; k < 64; k += 8) out += static_cast<char>(number >> k & 255);
}

}  // namespace

BlockCompressor::BlockCompressor() : stream_(std::make_unique<z_stream_s>()) {
  if (deflateInit(stream_.get(), compression_level) != Z_OK) throw std::bad_alloc();
}

BlockCompressor::~BlockCompressor() { deflateEnd(stream_.get()); }

std::size_t BlockCompressor::append(std::string_view block, std::string& out) {
  const std::size_t start = out.size(), most = deflateBound(stream_.get(), static_cast<uLong>(block.size()));
  out.resize(start + most);
  deflateReset(stream_.get());
  // zlib does not write where next_in points to.
  stream_->next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(block.data()));
  stream_->avail_in = static_cast<uInt>(block.size());
  stream_->next_out = reinterpret_cast<Bytef*>(out.data() + start);
  stream_->avail_out = static_cast<uInt>(most);
  [[maybe_unused]] const int result = deflate(stream_.get(), Z_FINISH);
  assert(result == Z_STREAM_END);
  out.resize(start + stream_->total_out);
  return stream_->total_out;
}

void VtuArray::make_room() {
  if (used_ == block_size) close_block();
  if (used_ == block_.size()) block_.resize(std::clamp(2 * block_.size(), std::size_t{64}, block_size));
}

void VtuArray::close_block() {
  sizes_.push_back(compressor_->append(std::string_view(block_).substr(0, used_), compressed_));
  used_ = 0;
}

void VtuArray::put_string(std::string_view text) {
  for (const char c : text) put(c);
  put('\0');
}

std::vector<std::string> VtuArray::finish() {
  const std::size_t last = used_;
  if (last > 0) close_block();
  // A last block of full size counts as one of the others.
  std::string header;
  append_little_endian(sizes_.size(), header);
  append_little_endian(block_size, header);
  append_little_endian(last == block_size ? 0 : last, header);
  for (const std::uint64_t size : sizes_) append_little_endian(size, header);
  block_ = {};
  return {std::move(header), std::move(compressed_)};
}

}  // namespace pliant
