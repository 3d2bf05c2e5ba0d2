// tools/run/doubts.cpp: texts that open with file, line and frame.
#include "run/doubts.h"

namespace pliant {

std::string where(const Frame& frame, long line) {
  return frame.source + ":" + std::to_string(line) + ": frame " + std::to_string(frame.index) + ": ";
}

std::string at_pointer(const std::string& pointer, const std::string& text) {
  return pointer.empty() ? text : pointer + ": " + text;
}

std::string describe_fault(const Frame& frame, std::string_view document, const std::string& pointer,
                           const std::string& text) {
  if (pointer.empty()) return where(frame, frame.line) + text;
  const DocumentPlace place = find_place(document, pointer);
  return where(frame, frame.line + place.line - 1) + at_pointer(pointer, with_column(text, place));
}

void Doubts::say_new(std::string_view document, const Frame& frame) {
  constexpr std::size_t most = 100;  // in a series each frame may have others
  for (const Doubt& doubt : found_) {
    const std::string member = doubt.pointer.substr(doubt.pointer.rfind('/'));
    if (said_.size() >= most || !said_.insert(member + doubt.text).second) continue;
    const std::string more = doubt.more > 0 ? " (and " + std::to_string(doubt.more) + " more)" : "";
    say(options_, describe_fault(frame, document, doubt.pointer, doubt.text + more));
  }
  found_.clear();
}

}  // namespace pliant
