// tools/evolve/series_output.cpp: frames as a series, lines of JSON or items of CBOR, which a later run continues.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <vector>

#include "evolve/frame_output.h"
#include "formats/document/cbor/cbor_items.h"
#include "formats/document/document_form.h"
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

/// What is seen of a line while it goes by in pieces.
class LineLook {
 public:
  void take(std::string_view piece) {
    if (piece.empty()) return;
    constexpr std::size_t enough = 64;  // to know how it begins
    if (begin_.size() < enough) begin_ += piece.substr(0, enough - begin_.size());
    last_ = piece.back();
    has_zero_ = has_zero_ || piece.find('\0') != std::string_view::npos;
  }
  /// What is wrong with the line, as a frame; null: nothing is to be seen.
  const char* fault() const {
    if (!begins_as_frame(begin_)) return "it does not begin as a mesh document does";
    if (has_zero_) return "it holds bytes that are zero";
    return last_ == '}' ? nullptr : "it does not end as a mesh document does";
  }

 private:
  std::string begin_;
  char last_ = 0;
  bool has_zero_ = false;
};

class EarlierSeries : public EarlierFrames {
 public:
  explicit EarlierSeries(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) fail();
    is_cbor_ = begins_cbor(static_cast<char>(file_.peek()));
    file_.clear();
    is_cbor_ ? look_at_items() : look_at_lines();
  }

  long count() const override { return static_cast<long>(ends_.size()); }
  std::string name(long k) const override {
    return path_ + (is_cbor_ ? ": frame " + std::to_string(k) : ":" + std::to_string(k + 1));
  }
  std::string read(long k) const override {
    std::string text(static_cast<std::size_t>(ends_[at(k)] - begin(k)), '\0');
    file_.clear();
    file_.seekg(begin(k));
    file_.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file_) fail();
    return text;
  }
  std::string remedy(long k) const override {
    if (k == 0) return "without it, evolve begins anew";
    const std::string cut = is_cbor_ ? "this frame and those after it (head -c " + std::to_string(begin(k))
                                     : "this line and those after it (head -n " + std::to_string(k);
    return "cut off " + cut + " gives the others), and --resume goes on from the frame before";
  }
  std::unique_ptr<FrameOutput> go_on(long kept) override {
    return std::make_unique<SeriesOutput>(GrowingFile::reopen(path_, ends_[at(kept - 1)]), begin(kept - 1));
  }

 private:
  static std::size_t at(long k) { return static_cast<std::size_t>(k); }
  std::int64_t begin(long k) const { return k == 0 ? 0 : ends_[at(k - 1)]; }
  [[noreturn]] void fail() const { throw std::system_error(errno, std::generic_category(), path_); }
  /// As many bytes as there are.
  void read_block(std::string& block) {
    file_.read(block.data(), static_cast<std::streamsize>(block.size()));
    if (file_.bad()) fail();
  }
  void look_at_lines() {
    std::string block(1 << 18, '\0');
    LineLook look;
    std::int64_t place = 0;
    do {
      read_block(block);
      std::string_view left(block.data(), static_cast<std::size_t>(file_.gcount()));
      for (std::size_t end; (end = left.find('\n')) != std::string_view::npos; left.remove_prefix(end + 1)) {
        look.take(left.substr(0, end));
        place += static_cast<std::int64_t>(end) + 1;
        end_line(look, place);
      }
      look.take(left);
      place += static_cast<std::int64_t>(left.size());
    } while (file_);
  }
  /// Frames of CBOR: only heads are read, since they tell what follows.
  void look_at_items() {
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path_));
    std::string block(1 << 12, '\0');
    std::int64_t place = 0;
    while (place < size) {
      CborItemEnd item;
      const std::int64_t start = place;
      while (!item.is_done()) {
        file_.clear();
        file_.seekg(place);
        read_block(block);
        const auto got = static_cast<std::size_t>(file_.gcount());
        if (place == start && !begins_as_frame(std::string_view(block.data(), got))) {
          if (static_cast<std::size_t>(size - start) < frame_begin) return;  // half written
          ends_.push_back(size);
          refuse_frame(*this, count() - 1, "it does not begin as a mesh document does");
        }
        const char* const next = item.scan(block.data(), block.data() + got);
        const auto left = static_cast<std::int64_t>(
            std::min(item.left_of_string(), static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 2)));
        const std::int64_t passed = (next - block.data()) + left;
        if (passed == 0 || place + passed > size) return;  // half written
        if (left > 0) item.pass_string();
        place += passed;
      }
      ends_.push_back(place);
    }
  }
  void end_line(LineLook& look, std::int64_t end) {
    ends_.push_back(end);
    if (const char* const fault = look.fault()) refuse_frame(*this, count() - 1, fault);
    look = {};
  }

  std::string path_;
  mutable std::ifstream file_;
  bool is_cbor_ = false;
  std::vector<std::int64_t> ends_;  // of each frame, with its line feed
};

}  // namespace

std::unique_ptr<FrameOutput> create_series(const std::string& path) {
  return std::make_unique<SeriesOutput>(GrowingFile::create(path));
}

std::unique_ptr<EarlierFrames> find_series(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  if (!std::filesystem::is_regular_file(path, error))
    throw UsageError("--resume needs a file that can be read again, and '" + path + "' is none");
  auto frames = std::make_unique<EarlierSeries>(path);
  if (frames->count() == 0) return {};
  return frames;
}

}  // namespace pliant
