// tools/run/doubts.cpp: texts that open with file, line and frame.
#include "run/doubts.h"

namespace pliant {

void InputDocument::release(const std::vector<NumberArray>& arrays) {
  if (is_released_) return;
  outline_ = DocumentOutline(text_, arrays);
  is_released_ = true;
  text_ = {};
  free_text_();
}

std::string where(const Frame& frame, const DocumentPlace& place) {
  const std::string line = place.byte >= 0 ? "" : ":" + std::to_string(frame.line + place.line - 1);
  return frame.source + line + ": frame " + std::to_string(frame.index) + ": ";
}

std::string at_pointer(const std::string& pointer, const std::string& text) {
  return pointer.empty() ? text : pointer + ": " + text;
}

std::string describe_at(const Frame& frame, const DocumentPlace& place, const std::string& pointer,
                        const std::string& text) {
  DocumentPlace in_file = place;
  if (place.byte >= 0) in_file.byte += frame.byte;
  return where(frame, place) + at_pointer(pointer, with_offset(text, in_file));
}

std::string describe_fault(const InputDocument& document, const std::string& pointer, const std::string& text) {
  const Frame& frame = document.frame();
  if (!pointer.empty()) return describe_at(frame, document.find(pointer), pointer, text);
  DocumentPlace start;
  if (frame.form == DocumentForm::cbor) start.byte = 0;
  return where(frame, start) + text;
}

void Doubts::say_new(const InputDocument& document, std::vector<Doubt> found) {
  constexpr std::size_t most = 100;  // in a series each frame may have others
  if (options_.quiet) return;
  for (const Doubt& doubt : found) {
    const std::string member = doubt.pointer.substr(doubt.pointer.rfind('/'));
    if (said_.size() >= most || !said_.insert(member + doubt.text).second) continue;
    const std::string more = doubt.more > 0 ? " (and " + std::to_string(doubt.more) + " more)" : "";
    say(options_, describe_fault(document, doubt.pointer, doubt.text + more));
  }
}

}  // namespace pliant
