// tools/run/output_file.h: a result that appears whole or not at all.
#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace pliant {

/// The result of a tool: standard output, or a file that appears whole (`commit`) or not at all. An existing file that
/// is not a regular one (a device, a FIFO) is written in place.
class OutputFile {
 public:
  /// Opens a temporary file beside the target.   Throws std::system_error
  explicit OutputFile(const std::string& path);
  ~OutputFile();  ///< removes the temporary file unless committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Writes all of it, at once: it has left the process on return.
  void write(std::string_view bytes);
  /// Closes the file and gives it its name; nothing may be written after.
  void commit();
  /// Gives the file its name and leaves it open: what is written after is seen at once.
  void publish();
  int descriptor() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether the name of a file ends like this, in small letters or capitals.   Requires    an ending in small letters
bool has_ending(std::string_view path, std::string_view ending);

/// Removes the temporary files of this process; safe in a signal handler.
void remove_unfinished_files();

}  // namespace pliant
