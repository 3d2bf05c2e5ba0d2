// formats/document/document_stream.h: the documents of a stream, one at a time.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pliant {

/// A document that does not end before memory does, as a file that decompresses to very much; its text has the file and
/// the place where the document begins.
class DocumentTooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The documents of a stream, one at a time with memory for one: JSON Lines, a single document over many lines, or a
/// sequence of CBOR items (RFC 8742). What gzip or zstd compressed is decompressed.
class DocumentStream {
 public:
  /// The longest document that is held by default, in bytes: three quarters of the machine's memory.
  static std::size_t memory_for_a_document();
  /// Takes over the stream (not closed). `name` is for messages: the file, or "standard input". No document may be
  /// longer than `most` bytes.
  DocumentStream(std::FILE* stream, std::string name, std::size_t most = memory_for_a_document());
  ~DocumentStream();
  /// The text of the next document, valid until the next call; false at the end. Blank lines are skipped.
  /// Throws      std::system_error when reading fails; InputError for compressed bytes that are damaged;
  /// DocumentTooLong
  bool next(std::string_view& document);
  /// Frees the memory of the document last returned, which is gone then.
  void release();
  /// All of a stream that starts with these bytes, valid as long as this object; empty, and nothing is passed, if it
  /// starts with others. Only before the first `next`. A regular file is mapped, not copied.
  /// Throws      as `next`
  std::string_view all_if(std::string_view start);
  /// The first bytes, as many as there are up to `most`, of a stream that does not start with an object; empty, without
  /// waiting for more, of one that does. Only before the first `next`.
  std::string_view head_unless_object(std::size_t most);
  long frame() const;               ///< number of the document last returned, from 0
  long first_line() const;          ///< line on which it starts, from 1
  std::int64_t first_byte() const;  ///< at which it starts, from 0
  const std::string& name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
