// formats/document/document_stream.cpp: cuts a stream into documents, by their braces or the lengths of CBOR.
#include "formats/document/document_stream.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include "formats/document/byte_source.h"
#include "formats/document/cbor/cbor_items.h"
#include "formats/document/characters.h"
#include "formats/document/document_form.h"

namespace pliant {
namespace {

/// Finds where an object ends: at the brace that closes its first one. Fed piece by piece.
class ObjectEnd {
 public:
  /// The position behind the closing brace in [first, last), or null if the object goes on.
  const char* scan(const char* first, const char* last) {
    while (first != last) {
      if (!in_string_ && last - first >= block && is_dull(first)) {
        first += block;
        continue;
      }
      const char* stop = first + std::min<std::ptrdiff_t>(block, last - first);
      for (; first != stop; ++first)
        if (step(*first)) return first + 1;
    }
    return nullptr;
  }

 private:
  static constexpr std::ptrdiff_t block = 64;

  /// True if nothing in the block matters outside a string. Numbers, the bulk of a document, do not. Without a branch
  /// so that the compiler can compare many bytes at once.
  static bool is_dull(const char* p) {
    unsigned char found = 0;
    for (int i = 0; i < block; ++i) found |= static_cast<unsigned char>((p[i] == '"') | (p[i] == '{') | (p[i] == '}'));
    return found == 0;
  }

  bool step(char c) {
    if (in_string_) {
      if (escaped_)
        escaped_ = false;
      else if (c == '\\')
        escaped_ = true;
      else if (c == '"')
        in_string_ = false;
      return false;
    }
    if (c == '"') in_string_ = true;
    if (c == '{') ++depth_;
    return c == '}' && --depth_ <= 0;
  }

  long depth_ = 0;
  bool in_string_ = false, escaped_ = false;
};

struct Freer {
  void operator()(char* memory) const { std::free(memory); }
};

}  // namespace

struct DocumentStream::State {
  State(std::FILE* stream, std::string name, std::size_t limit) : source(stream, std::move(name)), most(limit) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  ByteSource source;
  std::size_t most;                     // that the buffer may have
  std::unique_ptr<char, Freer> buffer;  // [begin, end) is read and not yet given away
  std::size_t room = 0, begin = 0, end = 0;
  bool at_end = false;
  long frame = -1;
  long line = 1;                          // of buffer[begin]
  long first_line = 1;                    // of the document last returned
  std::int64_t byte = 0, first_byte = 0;  // the same
  void* mapped = MAP_FAILED;
  std::size_t mapped_size = 0;

  ~State() {
    if (mapped != MAP_FAILED) ::munmap(mapped, mapped_size);
  }

  /// Reads more behind `end`; false at the end of the stream.
  bool fill() {
    if (at_end) return false;
    if (begin > 0 && (end == begin || room == end)) {
      std::memmove(buffer.get(), buffer.get() + begin, end - begin);
      end -= begin;
      begin = 0;
    }
    if (room == end) grow();
    const std::size_t got = source.read(buffer.get() + end, room - end);
    end += got;
    at_end = got == 0;
    return got > 0;
  }

  /// By realloc, which moves pages rather than bytes and clears none.
  void grow() {
    const std::size_t wanted = std::min(std::max<std::size_t>(2 * room, 1 << 16), most);
    char* larger = wanted > room ? static_cast<char*>(std::realloc(buffer.get(), wanted)) : nullptr;
    if (larger == nullptr) throw DocumentTooLong(describe_excess());
    (void)buffer.release();
    buffer.reset(larger);
    room = wanted;
  }

  std::string describe_excess() const {
    const bool is_cbor = end > begin && begins_cbor(buffer.get()[begin]);
    const std::string compression = source.compressed_by();
    std::string text = source.name();
    if (frame >= 0)
      text += (is_cbor ? "" : ":" + std::to_string(first_line)) + ": frame " + std::to_string(frame) +
              ": the document that begins here";
    else
      text += ": the file";
    constexpr std::size_t megabyte = 1'000'000;
    return text + " has not ended after " + std::to_string((end - begin) / megabyte) + " MB" +
           (compression.empty() ? "" : " of what " + compression + " had compressed") +
           ", and there is no memory for more: a smaller one is wanted";
  }

  /// The bytes of a regular file that starts like this, unless something has been read; otherwise none.
  std::string_view map_file(std::string_view start) {
    struct stat status {};
    const int file = fileno(source.stream());
    std::string first(start.size(), '\0');
    if (file < 0 || ::fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || ::lseek(file, 0, SEEK_CUR) != 0 ||
        ::pread(file, first.data(), first.size(), 0) != static_cast<ssize_t>(first.size()) || first != start)
      return {};
    mapped_size = static_cast<std::size_t>(status.st_size);
    mapped = ::mmap(nullptr, mapped_size, PROT_READ, MAP_PRIVATE, file, 0);
    if (mapped == MAP_FAILED) return {};
    return {static_cast<const char*>(mapped), mapped_size};
  }

  void pass(std::size_t count) {
    const char* first = buffer.get() + begin;
    line += std::count(first, first + count, '\n');
    pass_binary(count);
  }
  void pass_binary(std::size_t count) {
    begin += count;
    byte += static_cast<std::int64_t>(count);
  }

  /// Frees the memory before `begin`.
  void release() {
    if (begin == 0) return;
    const std::size_t left = end - begin;
    std::unique_ptr<char, Freer> smaller;
    if (left > 0) {
      smaller.reset(static_cast<char*>(std::malloc(left)));
      if (smaller == nullptr) throw std::bad_alloc();
      std::memcpy(smaller.get(), buffer.get() + begin, left);
    }
    buffer = std::move(smaller);
    room = end = left;
    begin = 0;
  }

  /// Passes white space; false at the end of the stream.
  bool find_start() {
    for (;;) {
      const char* first = buffer.get() + begin;
      const char* last = buffer.get() + end;
      const char* start = std::find_if_not(first, last, is_space);
      pass(static_cast<std::size_t>(start - first));
      if (start != last) return true;
      if (!fill()) return false;
    }
  }

  /// The offset from `begin` behind the object that starts there (or where the stream ends first).
  std::size_t find_object_end() {
    ObjectEnd scanner;
    std::size_t scanned = 0;
    for (;;) {
      const char* first = buffer.get() + begin;
      const char* stop = scanner.scan(first + scanned, buffer.get() + end);
      if (stop != nullptr) return static_cast<std::size_t>(stop - first);
      scanned = end - begin;
      if (!fill()) return scanned;
    }
  }

  /// The same of an item of CBOR.
  std::size_t find_item_end() {
    CborItemEnd item;
    std::size_t scanned = 0;
    for (;;) {
      const char* first = buffer.get() + begin;
      scanned = static_cast<std::size_t>(item.scan(first + scanned, buffer.get() + end) - first);
      if (item.is_done()) return scanned;
      if (!fill()) return end - begin;
    }
  }

  /// The offset of the next line break at or behind `offset`, or of the end of the stream; on a line that goes on for
  /// long, of a place on it. What stands there is white space or will be refused, and need not be held in memory.
  std::size_t find_line_end(std::size_t offset) {
    constexpr std::size_t long_line = 1 << 16;
    const std::size_t limit = offset + long_line;
    for (;;) {
      const char* first = buffer.get() + begin;
      const std::size_t there = std::min(end - begin, limit);
      if (const void* found = std::memchr(first + offset, '\n', there - offset))
        return static_cast<std::size_t>(static_cast<const char*>(found) - first);
      offset = there;
      if (offset == limit || !fill()) return offset;
    }
  }
};

std::size_t DocumentStream::memory_for_a_document() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes_of_page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || bytes_of_page <= 0) return static_cast<std::size_t>(-1);
  return static_cast<std::size_t>(pages) / 4 * 3 * static_cast<std::size_t>(bytes_of_page);
}

DocumentStream::DocumentStream(std::FILE* stream, std::string name, std::size_t most)
    : state_(std::make_unique<State>(stream, std::move(name), most)) {}
DocumentStream::~DocumentStream() = default;

bool DocumentStream::next(std::string_view& document) {
  State& s = *state_;
  if (!s.find_start()) return false;
  ++s.frame;
  s.first_line = s.line;
  s.first_byte = s.byte;
  const char first = s.buffer.get()[s.begin];
  const bool is_cbor = begins_cbor(first);
  // What follows an object on its line, or is no object at all, goes to the reader, which refuses it.
  const std::size_t object = first == '{' ? s.find_object_end() : 0;
  const std::size_t size = is_cbor ? s.find_item_end() : s.find_line_end(object);
  document = {s.buffer.get() + s.begin, size};
  is_cbor ? s.pass_binary(size) : s.pass(size);
  return true;
}

void DocumentStream::release() { state_->release(); }

std::string_view DocumentStream::all_if(std::string_view start) {
  State& s = *state_;
  if (const std::string_view bytes = s.map_file(start); !bytes.empty()) return bytes;
  while (s.end - s.begin < start.size() && s.fill()) continue;
  if (std::string_view(s.buffer.get() + s.begin, s.end - s.begin).substr(0, start.size()) != start) return {};
  while (s.fill()) continue;
  return {s.buffer.get() + s.begin, s.end - s.begin};
}

std::string_view DocumentStream::head_unless_object(std::size_t most) {
  State& s = *state_;
  constexpr unsigned map = 5;  // of CBOR
  if (!s.find_start()) return {};
  const char first = s.buffer.get()[s.begin];
  if (first == '{' || static_cast<unsigned char>(first) >> 5 == map) return {};
  while (s.end - s.begin < most && s.fill()) continue;
  return std::string_view(s.buffer.get() + s.begin, s.end - s.begin).substr(0, most);
}

long DocumentStream::frame() const { return state_->frame; }
long DocumentStream::first_line() const { return state_->first_line; }
std::int64_t DocumentStream::first_byte() const { return state_->first_byte; }
const std::string& DocumentStream::name() const { return state_->source.name(); }

}  // namespace pliant
