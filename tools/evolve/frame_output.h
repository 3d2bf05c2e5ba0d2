// tools/evolve/frame_output.h: where the frames of a simulation go: standard output, a series, or numbered files.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

class FrameOutput {
 public:
  FrameOutput() = default;
  virtual ~FrameOutput() = default;
  FrameOutput(const FrameOutput&) = delete;
  FrameOutput& operator=(const FrameOutput&) = delete;

  /// Adds a frame, whole or not at all.   Throws std::system_error
  virtual void write(std::string_view frame) = 0;
  /// After `EarlierFrames::go_on`: the next frame takes the place of the last one that is there.
  virtual void replace_last() = 0;
};

/// What a fresh simulation writes to: an old series is replaced, and old frames of the same pattern are removed, when
/// the first frame is written.
std::unique_ptr<FrameOutput> create_series(const std::string& path);  ///< "-": standard output
std::unique_ptr<FrameOutput> create_numbered(const std::string& pattern);

/// The complete frames that an earlier run has left, at least one.
class EarlierFrames {
 public:
  EarlierFrames() = default;
  virtual ~EarlierFrames() = default;
  EarlierFrames(const EarlierFrames&) = delete;
  EarlierFrames& operator=(const EarlierFrames&) = delete;

  virtual long count() const = 0;
  /// The kth frame, from 0, as messages name it, and its text.   Throws std::system_error
  virtual std::string name(long k) const = 0;
  virtual std::string read(long k) const = 0;
  /// What the user can do where the kth frame is damaged.
  virtual std::string remedy(long k) const = 0;
  /// Removes all but the first `kept` frames, and what was half written, and writes on from there.
  /// Throws std::system_error
  virtual std::unique_ptr<FrameOutput> go_on(long kept) = 0;
};

/// Null where there is no frame. Nothing is changed, and of each frame only its beginning and its end are looked at.
/// Throws      std::system_error; Placed (bad input) where a frame is not what evolve writes; UsageError where a file
/// cannot be continued, or a frame between others is missing
std::unique_ptr<EarlierFrames> find_series(const std::string& path);
std::unique_ptr<EarlierFrames> find_numbered(const std::string& pattern);

/// Does a text begin as frames do, in either form? `frame_begin` bytes tell.
inline constexpr std::size_t frame_begin = 24;
bool begins_as_frame(std::string_view text);
/// Ends with bad input, for a frame that evolve has not written, or that something has damaged since.
[[noreturn]] void refuse_frame(const EarlierFrames& frames, long k, const std::string& fault);

/// Makes a folder and those above it.   Throws std::system_error that names it
void make_folders(const std::string& path);

/// A pattern such as out/%05d.json, with one number.   Throws UsageError
void check_pattern(const std::string& pattern);
/// The files of a pattern that begin as frames do.   Throws std::system_error
std::vector<std::string> list_numbered(const std::string& pattern);
/// The name of a file that stands beside numbered frames: the pattern up to its number, then `end`.
std::string beside_numbered(const std::string& pattern, const std::string& end);

}  // namespace pliant
