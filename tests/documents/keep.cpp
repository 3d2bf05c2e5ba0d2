// tests/documents/keep.cpp: splits an output into documents, and writes those of new shapes.
#include "keep.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <system_error>

#include "shape.h"

namespace {

namespace fs = std::filesystem;
constexpr std::size_t longest = 16 << 20;  // of a document that is kept; a megabyte takes python3-jsonschema a second

/// Another process may do the same at the same time, and no half of a file is ever to be seen.
void write_whole(const fs::path& path, std::string_view text) {
  const fs::path beside = path.string() + "." + std::to_string(getpid());
  if (!(std::ofstream(beside, std::ios::binary) << text).flush())
    throw std::system_error(errno, std::generic_category(), beside);
  fs::rename(beside, path);
}

void keep(const Source& source, std::uint64_t hash, std::string_view text, const std::string& ending) {
  char name[18];
  std::snprintf(name, sizeof name, "-%016llx", static_cast<unsigned long long>(hash));
  const fs::path path = fs::path(source.folder) / (source.kind + "-" + source.tool + name + ending);
  std::error_code none;
  if (text.size() > longest) return write_whole(path.string() + ".large", std::to_string(text.size()) + "\n");
  const std::uintmax_t size = fs::file_size(path, none);
  if (none || size > text.size()) write_whole(path, text);
}

/// What cannot be read is kept as well, so that it is refused, but not if the rest of it may only not have been
/// written.
void keep_lines(const Source& source, std::string_view text, bool is_whole) {
  while (text.starts_with('{')) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && !is_whole) return;
    const std::string_view line = text.substr(0, end);
    const Shape shape = shape_of_json(line);
    const bool is_document = shape.size == line.size() && end != std::string_view::npos;
    keep(source, is_document ? shape.hash : std::hash<std::string_view>()(line), line, ".json");
    text.remove_prefix(std::min(end, text.size() - 1) + 1);
  }
}

void keep_items(const Source& source, std::string_view text, bool is_whole) {
  while (!text.empty()) {
    const Shape shape = shape_of_cbor(text);
    if (shape.size == 0) {
      if (is_whole) keep(source, std::hash<std::string_view>()(text), text, ".cbor");
      return;
    }
    keep(source, shape.hash, text.substr(0, shape.size), ".cbor");
    text.remove_prefix(shape.size);
  }
}

}  // namespace

void keep_documents(const Source& source, const Output& output) {
  const std::string_view text = output.text;
  if (text.starts_with('{'))
    keep_lines(source, text, output.is_whole);
  else if (!text.empty() && (text[0] == '\xd9' || (text[0] & '\xe0') == '\xa0'))  // a tag, or an object
    keep_items(source, text, output.is_whole);
}
