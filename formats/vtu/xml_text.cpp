// formats/vtu/xml_text.cpp: characters of XML 1.0, and their escapes in attributes.
#include "formats/vtu/xml_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pliant {
namespace {

/// How many bytes the character at the start of a text takes; 0 if it is no UTF-8, or none of XML's characters.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  std::uint32_t code = first & (0xffU >> (size + 1));
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(k) & 0x3f);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_character =
      code >= least[size] && code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000) && code != 0xfffe && code != 0xffff;
  return is_character ? size : 0;
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
