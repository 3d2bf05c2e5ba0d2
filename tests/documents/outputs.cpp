// tests/documents/outputs.cpp: reads a command line for the options that name outputs.
#include "outputs.h"

#include <sys/stat.h>

#include <filesystem>
#include <system_error>
#include <tuple>

namespace {

namespace fs = std::filesystem;

bool was_written(const std::string& path, timespec since) {
  struct stat file {};
  return stat(path.c_str(), &file) == 0 && S_ISREG(file.st_mode) &&
         std::tie(file.st_mtim.tv_sec, file.st_mtim.tv_nsec) >= std::tie(since.tv_sec, since.tv_nsec);
}

/// The value of an option at the kth word: in the word itself, behind "=" or behind a short option, or in the next one.
bool has_value(const std::vector<std::string>& words, std::size_t k, const std::string& option, std::string& value) {
  const std::string& word = words[k];
  std::size_t end = 0;
  if (option.size() == 2) {  // flags may stand before it: -qo FILE, -qoFILE
    end = word.find_first_not_of("qv", 1);
    if (word[0] != '-' || end == std::string::npos || word[end] != option[1]) return false;
    ++end;
  } else {
    end = option.size();
    if (!word.starts_with(option) || (word.size() > end && word[end++] != '=')) return false;
  }
  if (end == word.size() && k + 1 == words.size()) return false;
  value = end < word.size() ? word.substr(end) : words[k + 1];
  return true;
}

/// The files of a pattern such as out/%05d.json, whatever their numbers.
std::vector<std::string> numbered_files(const std::string& pattern) {
  std::vector<std::string> files;
  const std::size_t begin = pattern.find('%'), end = pattern.find('d', begin);
  if (end == std::string::npos) return files;
  const std::string before = pattern.substr(0, begin), after = pattern.substr(end + 1);
  const fs::path folder = fs::path(before).parent_path();
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, none)) {
    const std::string path = (folder / entry.path().filename()).string();
    if (path.starts_with(before) && path.ends_with(after)) files.push_back(path);
  }
  return files;
}

}  // namespace

std::vector<NamedFile> files_written(const std::vector<std::string>& words, const std::string& kind, timespec since) {
  std::vector<NamedFile> files;
  const auto add = [&](const std::string& kind_of_file, const std::string& path) {
    if (was_written(path, since)) files.push_back({kind_of_file, path});
  };
  for (std::size_t k = 0; k < words.size(); ++k) {
    std::string value;
    if (words[k].empty()) continue;
    if (has_value(words, k, "-o", value) || has_value(words, k, "--output", value)) add(kind, value);
    if (has_value(words, k, "--report", value)) add("pass_report", value);
    if (has_value(words, k, "--log", value)) add("evolve_log", value);
    if (has_value(words, k, "--frames", value))
      for (const std::string& path : numbered_files(value)) add(kind, path);
  }
  return files;
}
