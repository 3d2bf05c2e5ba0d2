// tools/run/doubts.h: where in its document something is wrong, or probably not what was meant.
#pragma once
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/document/document_place.h"
#include "run/frame.h"
#include "run/tool_options.h"

namespace pliant {

/// A document of the input while it is worked on: it finds places, also once its text is gone.
class InputDocument {
 public:
  /// `free_text` frees the memory of the text.
  InputDocument(std::string_view text, const Frame& frame, std::function<void()> free_text)
      : text_(text), frame_(frame), free_text_(std::move(free_text)) {}
  std::string_view text() const { return text_; }
  const Frame& frame() const { return frame_; }
  DocumentPlace find(const std::string& pointer) const {
    return is_released_ ? outline_.find(pointer) : find_place(text_, pointer);
  }
  /// Frees the text; `arrays` are those of its reader.
  void release(const std::vector<NumberArray>& arrays);
  /// The same of a text whose places can be told as well without it.
  void release_if_exact(const std::vector<NumberArray>& arrays) {
    if (frame_.form == DocumentForm::cbor) release(arrays);
  }

 private:
  std::string_view text_;
  const Frame& frame_;
  std::function<void()> free_text_;
  DocumentOutline outline_;
  bool is_released_ = false;
};

/// "mesh.json:12: frame 0: ", at a place of the frame; of CBOR, which has no lines, "mesh.cbor: frame 0: "
std::string where(const Frame& frame, const DocumentPlace& place);
std::string at_pointer(const std::string& pointer, const std::string& text);
/// "mesh.json:12: frame 0: /points: TEXT (column 9)"
std::string describe_at(const Frame& frame, const DocumentPlace& place, const std::string& pointer,
                        const std::string& text);

/// A fault that a check found after reading, with the place of what it blames.
std::string describe_fault(const InputDocument& document, const std::string& pointer, const std::string& text);

/// Says which members of documents are probably not what was meant, each kind once a run.
class Doubts {
 public:
  explicit Doubts(const ToolOptions& options) : options_(options) {}
  /// Says those that a reader found, unless they have been said of another frame.
  void say_new(const InputDocument& document, std::vector<Doubt> found);

 private:
  const ToolOptions& options_;
  std::set<std::string> said_;
};

}  // namespace pliant
