// tools/evolve/numbered_output.cpp: frames as numbered files, each of which appears whole or not at all.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "evolve/frame_output.h"
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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

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
    file.commit();
    ++next_;
    if (is_fresh_) remove_from(next_);
    is_fresh_ = false;
  }
  void replace_last() override { --next_; }

 private:
  /// Frames of an earlier, longer run would be taken for ours.
  void remove_from(long number) const {
    while (std::filesystem::remove(pattern_.path(number))) ++number;
  }

  Pattern pattern_;
  long next_;
  bool is_fresh_;
};

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  return text;
}

}  // namespace

void make_folders(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::system_error(error, path);
}

void check_pattern(const std::string& pattern) { parse(pattern); }

std::string beside_numbered(const std::string& pattern, const std::string& end) { return parse(pattern).before + end; }

std::unique_ptr<FrameOutput> create_numbered(const std::string& pattern) {
  return std::make_unique<NumberedOutput>(parse(pattern), 0, true);
}

std::optional<ResumedOutput> resume_numbered(const std::string& pattern) {
  Pattern parsed = parse(pattern);
  long next = 0;
  while (std::filesystem::exists(parsed.path(next))) ++next;
  if (next == 0) return {};
  ResumedOutput resumed;
  resumed.frames.first = read_file(parsed.path(0));
  resumed.frames.last_name = parsed.path(next - 1);
  resumed.frames.last = read_file(resumed.frames.last_name);
  resumed.output = std::make_unique<NumberedOutput>(std::move(parsed), next, false);
  return resumed;
}

}  // namespace pliant
