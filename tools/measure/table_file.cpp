// tools/measure/table_file.cpp: appends records to files, after a look at their beginning and their end.
#include "measure/table_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

#include "run/exit_status.h"

namespace pliant {
namespace {

/// An open file; it closes itself.
class OpenFile {
 public:
  OpenFile(std::string path, int flags) : path_(std::move(path)) {
    constexpr mode_t mode = 0666;
    file_ = open(path_.c_str(), flags | O_CLOEXEC, mode);
    if (file_ < 0) fail();
  }
  ~OpenFile() {
    if (file_ >= 0) close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[noreturn]] void fail() const { throw std::system_error(errno, std::generic_category(), path_); }
  int release() { return std::exchange(file_, -1); }

  off_t size() const {
    struct stat found {};
    if (fstat(file_, &found) != 0) fail();
    return found.st_size;
  }

  /// `length` bytes from `offset`; fewer where the file ends before.
  std::string read(off_t offset, std::size_t length) const {
    std::string bytes(length, '\0');
    std::size_t got = 0;
    while (got < length) {
      const ssize_t more = pread(file_, bytes.data() + got, length - got, offset + static_cast<off_t>(got));
      if (more < 0 && errno == EINTR) continue;
      if (more < 0) fail();
      if (more == 0) break;
      got += static_cast<std::size_t>(more);
    }
    bytes.resize(got);
    return bytes;
  }

  void cut(off_t size) const {
    if (ftruncate(file_, size) != 0) fail();
  }

  /// Writes the bytes at the end, which is `size`; takes back what was written if that fails.
  void append(off_t size, std::string_view bytes) const {
    for (off_t at = size; !bytes.empty();) {
      const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), at);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) {
        const int error = errno;
        (void)!ftruncate(file_, size);
        errno = error;
        fail();
      }
      at += written;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

 private:
  std::string path_;
  int file_ = -1;
};

/// Where the last line that ends before `end` begins: after the newline before it, and not before `first`.
off_t begin_of_line(const OpenFile& file, off_t first, off_t end) {
  constexpr off_t block = 1 << 16;
  for (off_t at = end - 1; at > first;) {  // the newline at end - 1 is the line's own
    const off_t from = std::max(first, at - block);
    const std::string bytes = file.read(from, static_cast<std::size_t>(at - from));
    const std::size_t newline = bytes.rfind('\n');
    if (newline != std::string::npos) return from + static_cast<off_t>(newline) + 1;
    at = from;
  }
  return first;
}

/// The end of the last whole line.
off_t end_of_lines(const OpenFile& file, off_t first, off_t end) {
  if (end <= first || file.read(end - 1, 1) == "\n") return end;
  return begin_of_line(file, first, end);
}

double time_of_line(const OpenFile& file, off_t begin, off_t end) {
  constexpr off_t longest = 64;
  const std::string text = file.read(begin, static_cast<std::size_t>(std::min(longest, end - begin)));
  double time = 0;
  const char* const last = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), last, time);
  if (error != std::errc() || after == last || (*after != ',' && *after != '\n'))
    return -std::numeric_limits<double>::infinity();  // no row of ours: it stays
  return time;
}

/// Are these rows, whole lines, the last ones before `end`?
bool ends_with_rows(const OpenFile& file, off_t first, off_t end, std::string_view rows) {
  const off_t begin = end - static_cast<off_t>(rows.size());
  if (begin < first) return false;
  return (begin == first || file.read(begin - 1, 1) == "\n") && file.read(begin, rows.size()) == rows;
}

bool is_regular(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return true;  // it will be
  return S_ISREG(found.st_mode);
}

}  // namespace

TableFile::TableFile(std::string option, std::string path) : option_(std::move(option)), path_(std::move(path)) {}

TableFile::~TableFile() {
  if (stream_ >= 0) close(stream_);
}

void TableFile::append(std::string_view header, double time, std::string_view rows) const {
  if (stream_ >= 0 || !is_regular(path_)) return append_to_stream(header, rows);
  const OpenFile file(path_, O_RDWR | O_CREAT);
  const off_t size = file.size(), first = static_cast<off_t>(header.size());
  if (size == 0) return file.append(0, std::string(header) + std::string(rows));
  if (file.read(0, header.size()) != header)
    throw UsageError(option_ + " " + path_ +
                     ": the file is there and is no table of these columns, so nothing is appended to it; name another "
                     "one, or remove it");
  off_t end = end_of_lines(file, first, size);
  off_t begin = end;
  if (end > first) begin = begin_of_line(file, first, end);
  if (end > first && time_of_line(file, begin, end) > time) {
    while (end > first && time_of_line(file, begin, end) >= time) {
      end = begin;
      if (end > first) begin = begin_of_line(file, first, end);
    }
  } else if (ends_with_rows(file, first, end, rows)) {
    if (end < size) file.cut(end);
    return;
  }
  if (end < size) file.cut(end);
  file.append(end, rows);
}

void TableFile::append_to_stream(std::string_view header, std::string_view rows) const {
  std::string bytes;
  if (stream_ < 0) {
    stream_ = OpenFile(path_, O_WRONLY).release();
    bytes = header;
  }
  bytes += rows;
  for (std::string_view left = bytes; !left.empty();) {
    const ssize_t written = write(stream_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::system_error(errno, std::generic_category(), path_);
    left.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace pliant
