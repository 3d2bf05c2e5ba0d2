// tools/run/growing_file.h: a file that grows by whole records, and that a later run can continue.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace pliant {

/// A series, a log: each record is in the file whole or not at all. "-" is standard output.
class GrowingFile {
 public:
  /// A new file; an old one of this name is replaced when the first record is there. Devices and FIFOs are written in
  /// place.   Throws std::system_error
  static GrowingFile create(const std::string& path);
  /// A file that is there, cut to its first `size` bytes.   Throws std::system_error
  static GrowingFile reopen(const std::string& path, std::int64_t size);
  ~GrowingFile();
  GrowingFile(GrowingFile&&) noexcept;
  GrowingFile& operator=(GrowingFile&&) noexcept;

  /// Writes the record. If that fails, what was written of it is taken back, as far as the file allows.
  /// Throws      std::system_error
  void append(std::string_view record);
  /// Cuts the file; records after the first `size` bytes are gone.   Throws std::system_error
  void cut(std::int64_t size);
  std::int64_t size() const;

 private:
  struct State;
  explicit GrowingFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace pliant
