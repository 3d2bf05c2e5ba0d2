// formats/document/byte_source.h: the bytes of a stream, also of one that gzip or zstd compressed.
#pragma once
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

namespace pliant {

/// The bytes of a stream; what gzip or zstd compressed, in one piece or several, is decompressed on the way, with
/// memory that does not depend on its length. What was compressed twice is decompressed once: see recognize.h.
class ByteSource {
 public:
  /// Takes over the stream (not closed). `name` is for messages: the file, or "standard input".
  ByteSource(std::FILE* stream, std::string name);
  ~ByteSource();
  /// Puts at least one and at most `count` bytes there, what there is without waiting for more, and returns how many;
  /// 0 at the end.
  /// Throws      std::system_error when reading fails; InputError, its text with the name, for compressed bytes that
  ///             are damaged, end early, or ask for more memory than is given to them
  std::size_t read(char* to, std::size_t count);
  /// "gzip" or "zstd" once bytes have been read that it compressed; else empty.
  std::string compressed_by() const;
  std::FILE* stream() const;
  const std::string& name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All bytes of a source.
/// Throws      as `read`; InputError, its text with the name, where there are more than `most` or than memory holds
std::string read_all(ByteSource& source, std::size_t most = static_cast<std::size_t>(-1));

}  // namespace pliant
