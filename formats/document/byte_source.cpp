// formats/document/byte_source.cpp: reads, and decompresses with zlib and libzstd.
#include "formats/document/byte_source.h"

#include <unistd.h>
#include <zlib.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr std::string_view gzip_magic = "\x1F\x8B", zstd_magic = "\x28\xB5\x2F\xFD";
constexpr std::size_t skippable_magics = 16;  // 0x184D2A50 to 5F, little-endian

/// Compressed bytes that were read and not yet used.
struct Packed {
  std::vector<char> bytes;
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
  const char* data() const { return bytes.data() + begin; }
  std::string_view view() const { return {data(), size()}; }
};

/// Thrown for bytes that take more memory to decompress than zstd gives without being told to, which is 128 MB.
struct WindowTooLarge {};

class Decompressor {
 public:
  enum class Step { more, member_end };
  Decompressor() = default;
  virtual ~Decompressor() = default;
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;
  /// Uses some of the packed bytes, adds to `made`; null, or what is wrong with them.
  /// Throws      WindowTooLarge
  virtual const char* run(Packed& packed, char* to, std::size_t count, std::size_t& made) = 0;
  /// Between two members, or before the first.
  virtual bool is_at_end() const = 0;
  virtual const char* name() const = 0;
};

class GzipDecompressor : public Decompressor {
 public:
  GzipDecompressor() {
    constexpr int gzip_only = 16;
    if (inflateInit2(&z_, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~GzipDecompressor() override { inflateEnd(&z_); }
  const char* run(Packed& packed, char* to, std::size_t count, std::size_t& made) override {
    if (is_at_end_ && has_begun_) {
      // Some programs fill up with zeros behind the last member.
      while (packed.size() > 0 && *packed.data() == 0) ++packed.begin;
      if (packed.size() == 0) return nullptr;
      if (packed.data()[0] != gzip_magic[0])
        return "bytes follow that gzip did not compress; it must compress all of the file";
      inflateReset(&z_);
    }
    constexpr std::size_t most = 1U << 30;
    const auto room = static_cast<uInt>(std::min(count, most)),
               there = static_cast<uInt>(std::min(packed.size(), most));
    z_.next_in = reinterpret_cast<Bytef*>(packed.bytes.data() + packed.begin);
    z_.avail_in = there;
    z_.next_out = reinterpret_cast<Bytef*>(to);
    z_.avail_out = room;
    const int result = inflate(&z_, Z_NO_FLUSH);
    has_begun_ = true;
    packed.begin += there - z_.avail_in;
    made = room - z_.avail_out;
    is_at_end_ = result == Z_STREAM_END;
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result == Z_OK || result == Z_STREAM_END || result == Z_BUF_ERROR) return nullptr;
    return z_.msg != nullptr ? z_.msg : "it is no gzip file";
  }
  bool is_at_end() const override { return is_at_end_; }
  const char* name() const override { return "gzip"; }

 private:
  z_stream z_{};
  bool is_at_end_ = false, has_begun_ = false;
};

class ZstdDecompressor : public Decompressor {
 public:
  ZstdDecompressor() : z_(ZSTD_createDCtx()) {
    if (z_ == nullptr) throw std::bad_alloc();
  }
  ~ZstdDecompressor() override { ZSTD_freeDCtx(z_); }
  const char* run(Packed& packed, char* to, std::size_t count, std::size_t& made) override {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{to, count, 0};
    const std::size_t result = ZSTD_decompressStream(z_, &out, &in);
    packed.begin += in.pos;
    made = out.pos;
    is_at_end_ = result == 0;
    if (ZSTD_getErrorCode(result) == ZSTD_error_frameParameter_windowTooLarge) throw WindowTooLarge{};
    return ZSTD_isError(result) != 0 ? ZSTD_getErrorName(result) : nullptr;
  }
  bool is_at_end() const override { return is_at_end_; }
  const char* name() const override { return "zstd"; }

 private:
  ZSTD_DCtx* z_;
  bool is_at_end_ = false;
};

bool begins_zstd(std::string_view bytes) {
  if (bytes.starts_with(zstd_magic)) return true;
  return bytes.size() >= 4 && static_cast<unsigned char>(bytes[0]) - 0x50U < skippable_magics &&
         bytes.substr(1, 3) == "\x2A\x4D\x18";
}

}  // namespace

struct ByteSource::State {
  std::FILE* stream;
  std::string name;
  bool is_known = false;  // which of the three it is
  bool is_over = false;   // the stream has ended
  Packed packed;          // also the first bytes of a stream that is not compressed
  std::unique_ptr<Decompressor> decompressor;

  /// What there is, without waiting for more: the first frame of a slow series is worked on while the next one is made.
  /// Streams without a file descriptor are in memory.
  std::size_t read_some(char* to, std::size_t count) {
    const int file = fileno(stream);
    for (;;) {
      const ssize_t got = file < 0 ? static_cast<ssize_t>(std::fread(to, 1, count, stream)) : ::read(file, to, count);
      is_over = got == 0;
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "reading " + name);
    }
  }

  void find_kind() {
    constexpr std::size_t magic = 4;
    packed.bytes.resize(magic);
    while (packed.end < magic && !is_over) {
      packed.end += read_some(packed.bytes.data() + packed.end, magic - packed.end);
      // A single byte that begins neither settles it.
      if (packed.end > 0 && !gzip_magic.starts_with(packed.view().substr(0, 2)) &&
          !zstd_magic.starts_with(packed.view()) && (static_cast<unsigned char>(packed.bytes[0]) & 0xF0) != 0x50)
        break;
    }
    if (packed.view().starts_with(gzip_magic))
      decompressor = std::make_unique<GzipDecompressor>();
    else if (begins_zstd(packed.view()))
      decompressor = std::make_unique<ZstdDecompressor>();
    is_known = true;
  }

  const char* run_decompressor(char* to, std::size_t count, std::size_t& made) {
    try {
      return decompressor->run(packed, to, count, made);
    } catch (const WindowTooLarge&) {
      throw InputError("", name + ": zstd compressed it with a window of more than 128 MB (--long): " +
                               "zstd -dc --long=31 FILE | TOOL reads it");
    }
  }

  std::size_t decompress(char* to, std::size_t count) {
    constexpr std::size_t block = 1 << 16;
    for (;;) {
      if (packed.size() == 0 && !is_over) {
        packed.bytes.resize(block);
        packed.begin = 0;
        packed.end = read_some(packed.bytes.data(), block);
      }
      if (packed.size() == 0 && decompressor->is_at_end()) return 0;
      std::size_t made = 0;
      const std::size_t before = packed.size();
      if (const char* fault = run_decompressor(to, count, made))
        throw InputError("", name + ": what " + decompressor->name() + " compressed is damaged: " + fault);
      if (made > 0) return made;
      if (packed.size() == before && is_over)
        throw InputError("", name + ": what " + decompressor->name() + " compressed ends early: the file is cut off");
    }
  }
};

ByteSource::ByteSource(std::FILE* stream, std::string name) : state_(std::make_unique<State>()) {
  state_->stream = stream;
  state_->name = std::move(name);
}
ByteSource::~ByteSource() = default;

std::size_t ByteSource::read(char* to, std::size_t count) {
  State& s = *state_;
  if (!s.is_known) s.find_kind();
  if (s.decompressor) return s.decompress(to, count);
  if (s.packed.size() == 0) return s.is_over ? 0 : s.read_some(to, count);
  const std::size_t given = std::min(count, s.packed.size());
  std::memcpy(to, s.packed.data(), given);
  s.packed.begin += given;
  return given;
}

std::string ByteSource::compressed_by() const { return state_->decompressor ? state_->decompressor->name() : ""; }
std::FILE* ByteSource::stream() const { return state_->stream; }
const std::string& ByteSource::name() const { return state_->name; }

std::string read_all(ByteSource& source, std::size_t most) {
  std::string bytes;
  const auto refuse = [&](std::size_t size, const std::string& reason) {
    constexpr std::size_t megabyte = 1'000'000;
    const std::string compression = source.compressed_by();
    throw InputError("", source.name() + ": is longer than " + std::to_string(size / megabyte) + " MB" +
                             (compression.empty() ? "" : " once " + compression + " decompresses it") + ", " + reason);
  };
  constexpr std::size_t block = 1 << 16;
  try {
    for (std::size_t got = 1; got > 0;) {
      const std::size_t before = bytes.size();
      bytes.resize(before + block);
      got = source.read(bytes.data() + before, block);
      bytes.resize(before + got);
      if (bytes.size() > most) refuse(most, "and no more is read of such a file");
    }
  } catch (const std::bad_alloc&) {
    refuse(bytes.size(), "and there is no memory for more");
  }
  return bytes;
}

}  // namespace pliant
