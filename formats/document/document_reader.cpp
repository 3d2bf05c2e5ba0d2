// formats/document/document_reader.cpp: what readers of every form share: pointers, faults, doubts and names.
#include "formats/document/document_reader.h"

#include <algorithm>

#include "formats/document/cbor/read_cbor.h"
#include "formats/document/document_form.h"
#include "formats/document/read_json.h"

namespace pliant {
namespace {

/// The pointer's text of a member name (RFC 6901).
void append_escaped(std::string& pointer, std::string_view name) {
  for (const char c : name) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
}

}  // namespace

std::string DocumentReader::pointer() const {
  std::string pointer;
  for (const Step& step : path_) {
    pointer += '/';
    if (step.index < 0)
      append_escaped(pointer, step.name);
    else
      pointer += std::to_string(step.index);
  }
  return pointer;
}

void DocumentReader::fail(const std::string& text, const std::string& below) const {
  const std::string pointer = this->pointer() + below;
  throw DocumentError(pointer, text, place_of(pointer));
}

void DocumentReader::doubt(std::string_view member, const std::string& text) {
  constexpr std::size_t most = 20;
  std::string place;
  append_escaped(place, member);
  for (char& c : place)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';  // a terminal would act on it
  const auto is_same = [&](const Doubt& old) { return old.text == text && old.pointer.ends_with("/" + place); };
  if (const auto old = std::find_if(doubts_.begin(), doubts_.end(), is_same); old != doubts_.end())
    ++old->more;
  else if (doubts_.size() < most)
    doubts_.push_back({pointer() + "/" + place, text, 0});
  else
    ++doubts_.back().more;
}

bool DocumentReader::Names::add(std::string_view name) {
  constexpr std::size_t linear = 16;  // above, a hostile object would cost the square of its size
  if (few.size() < linear) {
    if (std::find(few.begin(), few.end(), name) != few.end()) return false;
    if (few.empty()) few.reserve(8);
    few.push_back(name);
    if (few.size() == linear) many.insert(few.begin(), few.end());
    return true;
  }
  return many.insert(name).second;
}

std::unique_ptr<DocumentReader> reader_of(std::string_view document) {
  if (form_of(document) == DocumentForm::cbor) return std::make_unique<CborReader>(document);
  return std::make_unique<JsonReader>(document);
}

}  // namespace pliant
