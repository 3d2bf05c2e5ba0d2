// tests/documents/keep.h: keeps the smallest document of each shape.
#pragma once
#include <string>
#include <string_view>

/// Where documents come from: whose they are, and what they are ("document" where they say so themselves).
struct Source {
  std::string folder, kind, tool;
};

/// What a tool wrote.
struct Output {
  std::string text;
  bool is_whole = true;  ///< else the tool, or who reads it, stopped early, and the end may be half a document
};

/// Keeps the documents of the output, if it is one of documents, as KIND-TOOL-HASH.json or .cbor, where there is no
/// smaller one of that shape. Of one that is too long to be validated a note is kept, KIND-TOOL-HASH.large.
void keep_documents(const Source& source, const Output& output);

/// At most so much of an output is read.
constexpr std::size_t most_read = 64 << 20;
