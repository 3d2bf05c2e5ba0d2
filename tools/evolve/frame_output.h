// tools/evolve/frame_output.h: where the frames of a simulation go: standard output, a series, or numbered files.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// What an earlier run left: the texts of its first and last complete frame, and a name of the latter for messages.
struct EarlierFrames {
  std::string first, last;
  std::string last_name;
};

class FrameOutput {
 public:
  FrameOutput() = default;
  virtual ~FrameOutput() = default;
  FrameOutput(const FrameOutput&) = delete;
  FrameOutput& operator=(const FrameOutput&) = delete;

  /// Adds a frame, whole or not at all.   Throws std::system_error
  virtual void write(std::string_view frame) = 0;
  /// After `resume`: the next frame takes the place of the last one that is there.
  virtual void replace_last() = 0;
};

/// What a fresh simulation writes to: an old series is replaced, and old files of the same pattern are removed, when
/// the first frame is written.
std::unique_ptr<FrameOutput> create_series(const std::string& path);  ///< "-": standard output
std::unique_ptr<FrameOutput> create_numbered(const std::string& pattern);

/// What an earlier run has left, if there is a complete frame, and where to write on; a frame that was half written is
/// cut off. Null if there is nothing to go on from.   Throws std::system_error
struct ResumedOutput {
  EarlierFrames frames;
  std::unique_ptr<FrameOutput> output;
};
std::optional<ResumedOutput> resume_series(const std::string& path);
std::optional<ResumedOutput> resume_numbered(const std::string& pattern);

/// Makes a folder and those above it.   Throws std::system_error that names it
void make_folders(const std::string& path);

/// A pattern such as out/%05d.json, with one number.   Throws UsageError
void check_pattern(const std::string& pattern);
/// The name of a file that stands beside numbered frames: the pattern up to its number, then `end`.
std::string beside_numbered(const std::string& pattern, const std::string& end);

}  // namespace pliant
