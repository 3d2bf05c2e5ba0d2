// tools/evolve/series_output.cpp: frames as a series, a line a frame, which a later run continues.
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "evolve/frame_output.h"
#include "run/exit_status.h"
#include "run/growing_file.h"

namespace pliant {
namespace {

class SeriesOutput : public FrameOutput {
 public:
  explicit SeriesOutput(GrowingFile file) : file_(std::move(file)) {}
  SeriesOutput(GrowingFile file, std::int64_t last) : file_(std::move(file)), last_(last) {}

  void write(std::string_view frame) override {
    if (replaces_) file_.cut(last_);
    replaces_ = false;
    last_ = file_.size();
    file_.append(frame);
  }
  void replace_last() override { replaces_ = true; }

 private:
  GrowingFile file_;
  std::int64_t last_ = 0;  // where the last frame begins
  bool replaces_ = false;
};

/// The place of the last line feed before `end`; -1 if there is none.
std::int64_t find_line_feed_before(std::ifstream& file, std::int64_t end) {
  std::string block(1 << 16, '\0');
  while (end > 0) {
    const std::int64_t begin = std::max<std::int64_t>(0, end - static_cast<std::int64_t>(block.size()));
    file.seekg(begin);
    file.read(block.data(), end - begin);
    if (!file) return -1;
    const std::size_t found = std::string_view(block).substr(0, static_cast<std::size_t>(end - begin)).rfind('\n');
    if (found != std::string_view::npos) return begin + static_cast<std::int64_t>(found);
    end = begin;
  }
  return -1;
}

std::string read_part(std::ifstream& file, std::int64_t begin, std::int64_t end) {
  std::string text(static_cast<std::size_t>(end - begin), '\0');
  file.seekg(begin);
  file.read(text.data(), end - begin);
  return text;
}

}  // namespace

std::unique_ptr<FrameOutput> create_series(const std::string& path) {
  return std::make_unique<SeriesOutput>(GrowingFile::create(path));
}

std::optional<ResumedOutput> resume_series(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  if (!std::filesystem::is_regular_file(path, error))
    throw UsageError("--resume needs a file that can be read again, and '" + path + "' is none");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path));
  const std::int64_t end = find_line_feed_before(file, size) + 1;  // what comes after it is half a frame
  if (end == 0) return {};
  const std::int64_t last = find_line_feed_before(file, end - 1) + 1;
  ResumedOutput resumed;
  file.seekg(0);
  std::getline(file, resumed.frames.first);
  resumed.frames.last = read_part(file, last, end);
  resumed.frames.last_name = path + ", the last frame";
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  resumed.output = std::make_unique<SeriesOutput>(GrowingFile::reopen(path, end), last);
  return resumed;
}

}  // namespace pliant
