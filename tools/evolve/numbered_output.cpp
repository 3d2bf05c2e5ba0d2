// tools/evolve/numbered_output.cpp: frames as numbered files, each of which appears whole or not at all.
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "evolve/frame_output.h"
#include "formats/document/characters.h"
#include "formats/document/document_form.h"
#include "run/exit_status.h"
#include "run/output_file.h"

namespace pliant {
namespace {

/// A pattern, taken apart: what stands before the number, its least width, and what stands after it.
struct Pattern {
  std::string before, after;
  std::size_t width = 0;
  bool pads_with_zeros = false;

  std::string path(long number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < width) digits.insert(0, width - digits.size(), pads_with_zeros ? '0' : ' ');
    return before + digits + after;
  }
};

[[noreturn]] void refuse(const std::string& pattern) {
  throw UsageError("--frames: '" + pattern + "' needs one number for the frame, such as %05d in out/%05d.json");
}

Pattern parse(const std::string& text) {
  Pattern pattern;
  bool has_number = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string& part = has_number ? pattern.after : pattern.before;
    if (text[k] != '%') {
      part += text[k];
    } else if (k + 1 < text.size() && text[k + 1] == '%') {
      part += text[++k];
    } else {
      if (has_number) refuse(text);
      has_number = true;
      ++k;
      if (k < text.size() && text[k] == '0') pattern.pads_with_zeros = true;
      for (; k < text.size() && is_digit(text[k]); ++k)
        if ((pattern.width = 10 * pattern.width + static_cast<std::size_t>(text[k] - '0')) > 99) refuse(text);
      if (k == text.size() || text[k] != 'd') refuse(text);
    }
  }
  if (!has_number) refuse(text);
  return pattern;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  return text;
}

/// The first bytes of a file, enough to know how it begins, and the last two.
std::pair<std::string, std::string> read_ends(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  std::string begin(64, '\0'), end(2, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  file.seekg(-2, std::ios::end);
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  return {begin, end};
}

/// The numbers of the files that match the pattern and begin as frames do, in rising order. Other files are no
/// concern of evolve, whatever their names.
std::vector<long> find_frames(const Pattern& pattern) {
  const std::size_t slash = pattern.before.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : pattern.before.substr(0, slash + 1);
  const std::string stem = pattern.before.substr(folder.size());
  std::vector<long> numbers;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(stem)) continue;
    const std::size_t digits = std::min(name.find_first_not_of(' ', stem.size()), name.size());
    long number = -1;
    const auto read = std::from_chars(name.data() + digits, name.data() + name.size(), number);
    if (read.ec != std::errc() || number < 0) continue;
    const std::string path = pattern.path(number);
    const bool is_match = path == folder + name || path.starts_with(folder + name + "/");
    if (is_match && std::filesystem::is_regular_file(path, error) && begins_as_frame(read_ends(path).first))
      numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

class NumberedOutput : public FrameOutput {
 public:
  /// `next`: the number of the next frame; `is_fresh`: nothing of this pattern is to be kept.
  NumberedOutput(Pattern pattern, long next, bool is_fresh)
      : pattern_(std::move(pattern)), next_(next), is_fresh_(is_fresh) {}

  void write(std::string_view frame) override {
    const std::string path = pattern_.path(next_);
    if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty()) make_folders(folder.string());
    OutputFile file(path);
    file.write(frame);
    // Frames of an earlier, longer run would be taken for ours. The first one goes first: what a sudden end leaves is
    // never the beginning of a series.
    if (is_fresh_)
      for (const long number : find_frames(pattern_)) std::filesystem::remove(pattern_.path(number));
    is_fresh_ = false;
    file.commit();
    ++next_;
  }
  void replace_last() override { --next_; }

 private:
  Pattern pattern_;
  long next_;
  bool is_fresh_;
};

class EarlierFiles : public EarlierFrames {
 public:
  explicit EarlierFiles(Pattern pattern) : pattern_(std::move(pattern)) {
    while (std::filesystem::exists(pattern_.path(count_))) ++count_;
    refuse_gap();
    for (long k = 0; k < count_; ++k) look_at(k);
  }

  long count() const override { return count_; }
  std::string name(long k) const override { return pattern_.path(k); }
  std::string read(long k) const override { return read_file(pattern_.path(k)); }
  std::string remedy(long k) const override {
    return k == 0 ? "without it and those after it, evolve begins anew"
                  : "remove it and those after it, and --resume goes on from the frame before";
  }
  std::unique_ptr<FrameOutput> go_on(long kept) override {
    for (; count_ > kept; --count_) std::filesystem::remove(pattern_.path(count_ - 1));
    return std::make_unique<NumberedOutput>(pattern_, kept, false);
  }

 private:
  /// A frame after one that is missing would be left among those of this run, at a time of its own.
  void refuse_gap() const {
    const std::vector<long> numbers = find_frames(pattern_);
    const auto beyond = std::ranges::upper_bound(numbers, count_);
    if (beyond == numbers.end()) return;
    const auto left = numbers.end() - beyond;
    throw UsageError("--resume: there is no " + pattern_.path(count_) + ", but " + pattern_.path(*beyond) +
                     (left > 1 ? " and " + std::to_string(left - 1) + " after it are there" : " is there") +
                     "; bring it back, or remove those after it " +
                     (count_ > 0 ? "to go on from " + pattern_.path(count_ - 1) : "to begin anew"));
  }
  void look_at(long k) const {
    if (!std::filesystem::is_regular_file(pattern_.path(k))) refuse_frame(*this, k, "it is no file");
    const auto [begin, end] = read_ends(pattern_.path(k));
    if (!begins_as_frame(begin)) refuse_frame(*this, k, "it does not begin as a mesh document does");
    const bool is_whole = form_of(begin) == DocumentForm::cbor ? end.back() == '\xFF' : end == "}\n";
    if (!is_whole) refuse_frame(*this, k, "it does not end as a mesh document does");
  }

  Pattern pattern_;
  long count_ = 0;
};

}  // namespace

void check_pattern(const std::string& pattern) { parse(pattern); }

std::string beside_numbered(const std::string& pattern, const std::string& end) { return parse(pattern).before + end; }

std::vector<std::string> list_numbered(const std::string& pattern) {
  const Pattern parsed = parse(pattern);
  std::vector<std::string> paths;
  for (const long number : find_frames(parsed)) paths.push_back(parsed.path(number));
  return paths;
}

std::unique_ptr<FrameOutput> create_numbered(const std::string& pattern) {
  return std::make_unique<NumberedOutput>(parse(pattern), 0, true);
}

std::unique_ptr<EarlierFrames> find_numbered(const std::string& pattern) {
  auto frames = std::make_unique<EarlierFiles>(parse(pattern));
  if (frames->count() == 0) return {};
  return frames;
}

}  // namespace pliant
