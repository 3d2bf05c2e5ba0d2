// formats/msh/msh_cursor.h: a cursor over the bytes of an MSH file: numbers as text or binary, faults with place.
#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace pliant {

/// The reader's position in the file. It never passes the end: every failure throws an InputError that names the line
/// of a text file, or the byte offset in a binary one, and what was expected there.
class MshCursor {
 public:
  explicit MshCursor(std::string_view bytes) : begin_(bytes.data()), at_(begin_), end_(begin_ + bytes.size()) {}

  bool binary = false;   ///< are numbers of the bulk sections binary?
  bool swapped = false;  ///< is their byte order the other one than this machine's?

  const char* at() const { return at_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  bool at_end() const { return at_ == end_; }
  void skip_space();
  /// The rest of the line without its end. The cursor goes to the next line.
  std::string_view line();
  /// Passes the line end that stands before binary data.
  void end_line(const char* after);
  /// Reads a word up to white space.
  std::string_view word();
  /// Skips white space and passes `word`, which must stand there.
  void expect(std::string_view word, const char* why);
  /// Goes behind the next line that starts with `word`; false if there is none.
  bool skip_behind(std::string_view word);
  /// Passes binary data, and returns where it starts.
  const char* take(std::size_t count, std::size_t size, const char* what);
  /// Fails unless the rest of the file can hold `count` things of at least `least` bytes each.
  std::size_t room_for(std::uint64_t count, std::size_t least, const char* what) const;

  // Each reads a number as text and skips the white space before it.
  std::int64_t text_integer(const char* what);
  std::int32_t text_int(const char* what);
  std::uint64_t text_size(const char* what);
  double text_number(const char* what);
  // Each reads a number of a bulk section: 4, 8 and 8 bytes where the file is binary, else text.
  std::int32_t int32(const char* what);
  std::uint64_t size(const char* what);
  double number(const char* what);

  [[noreturn]] void fail(const std::string& text) const { fail_at(at_, text); }
  [[noreturn]] void fail_at(const char* where, const std::string& text) const;
  /// The word at the cursor, in quotes, for messages; or "the end of the file".
  std::string found() const { return found_at(at_); }
  std::string found_at(const char* where) const;

 private:
  const char* begin_;
  const char* at_;
  const char* end_;
};

/// Reads a value of a binary file.
template <class T, bool swap>
T load(const char* p) {
  if constexpr (swap) {
    char bytes[sizeof(T)];
    for (std::size_t k = 0; k < sizeof(T); ++k) bytes[k] = p[sizeof(T) - 1 - k];
    return std::bit_cast<T>(bytes);
  } else {
    T value;
    std::memcpy(&value, p, sizeof value);
    return value;
  }
}

}  // namespace pliant
