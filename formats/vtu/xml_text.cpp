// formats/vtu/xml_text.cpp: characters of XML 1.0, and their escapes in attributes.
#include "formats/vtu/xml_text.h"

#include <algorithm>
#include <cstddef>

#include "formats/document/characters.h"

namespace pliant {
namespace {

/// How many bytes the character at the start of a text takes; 0 if it is no UTF-8, or none of XML's characters.
std::size_t character_size(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const char* const next = skip_utf8(text.data(), text.data() + text.size());
  // U+FFFE and U+FFFF are UTF-8, but no characters.
  if (next == nullptr || text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF")) return 0;
  return static_cast<std::size_t>(next - text.data());
}

}  // namespace

bool is_xml_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string escape_attribute(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    if (size == 0)
      result += "\xEF\xBF\xBD";
    else if (text[0] == '&')
      result += "&amp;";
    else if (text[0] == '<')
      result += "&lt;";
    else if (text[0] == '>')
      result += "&gt;";
    else if (text[0] == '"')
      result += "&quot;";
    else if (text[0] < ' ' && size == 1)  // white space that a reader would take for a blank
      result += "&#" + std::to_string(static_cast<int>(text[0])) + ";";
    else
      result += text.substr(0, size);
    text.remove_prefix(std::max(size, std::size_t{1}));
    // One replacement stands for all bytes of what is no character.
    while (size == 0 && !text.empty() && (static_cast<unsigned char>(text[0]) & 0xc0) == 0x80) text.remove_prefix(1);
  }
  return result;
}

}  // namespace pliant
