// formats/document/characters.h: bytes and characters of documents: digits and white space, whatever the locale; UTF-8;
// names in JSON pointers.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

constexpr unsigned byte_of(char c) { return static_cast<unsigned char>(c); }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// The white space of JSON, and of MSH files.
constexpr bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// Behind the character of several bytes that starts at `p`; null if it is no UTF-8.
inline const char* skip_utf8(const char* p, const char* end) {
  const unsigned lead = byte_of(*p);
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  bool right = lead >= 0xC2 && lead <= 0xF4 && end - p > more;
  for (int i = 1; right && i <= more; ++i) right = (byte_of(p[i]) & 0xC0) == 0x80;
  if (right) {
    const unsigned second = byte_of(p[1]);  // overlong forms, surrogates, beyond U+10FFFF
    right = !(lead == 0xE0 && second < 0xA0) && !(lead == 0xED && second > 0x9F) && !(lead == 0xF0 && second < 0x90) &&
            !(lead == 0xF4 && second > 0x8F);
  }
  return right ? p + more + 1 : nullptr;
}

/// The first byte that is no UTF-8; null if all is.
inline const char* find_no_utf8(std::string_view text) {
  const char* const end = text.data() + text.size();
  for (const char* p = text.data(); p != end;) {
    const char* const next = byte_of(*p) < 0x80 ? p + 1 : skip_utf8(p, end);
    if (next == nullptr) return p;
    p = next;
  }
  return nullptr;
}

/// One step of a JSON pointer (RFC 6901) as the name that it stands for.
inline std::string unescape_step(std::string_view step) {
  std::string name;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const bool is_escape = step[i] == '~' && i + 1 < step.size();
    name += !is_escape ? step[i] : step[++i] == '1' ? '/' : '~';
  }
  return name;
}

}  // namespace pliant
