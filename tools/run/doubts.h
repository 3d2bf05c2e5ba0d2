// tools/run/doubts.h: where in its document something is wrong, or probably not what was meant.
#pragma once
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_place.h"
#include "run/frame.h"
#include "run/tool_options.h"

namespace pliant {

/// "mesh.json:12: frame 0: "
std::string where(const Frame& frame, long line);
std::string at_pointer(const std::string& pointer, const std::string& text);

/// A fault that a check found after reading, with the line and column of what it blames.
std::string describe_fault(const Frame& frame, std::string_view document, const std::string& pointer,
                           const std::string& text);

/// Says which members of documents are probably not what was meant, each kind once a run.
class Doubts {
 public:
  explicit Doubts(const ToolOptions& options) : options_(options) {}
  /// Where a reader leaves them.
  std::vector<Doubt>* found() { return options_.quiet ? nullptr : &found_; }
  /// Says those found, unless they have been said of another frame.
  void say_new(std::string_view document, const Frame& frame);

 private:
  const ToolOptions& options_;
  std::vector<Doubt> found_;
  std::set<std::string> said_;
};

}  // namespace pliant
