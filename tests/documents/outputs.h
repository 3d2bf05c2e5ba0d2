// tests/documents/outputs.h: which files a command line makes.
#pragma once
#include <ctime>
#include <string>
#include <vector>

/// A file, and the kind of its documents.
struct NamedFile {
  std::string kind, path;
};

/// The files that options name (-o, --output, --report, --log, and the numbered ones of --frames), however they are
/// spelled, as far as they are there and have been written since then.
std::vector<NamedFile> files_written(const std::vector<std::string>& words, const std::string& kind, timespec since);
