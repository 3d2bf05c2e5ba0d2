// formats/picture/svg/text.cpp: words in a picture, and the room that they take.
#include "formats/picture/svg/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "formats/document/characters.h"

namespace pliant {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD", ellipsis = "\xE2\x80\xA6";

// Widths of U+0020 to U+007E in DejaVu Sans, in hundredths of the font's size.
constexpr std::array<unsigned char, 95> ascii_widths{
    32, 40, 46, 84, 64, 95, 78, 27, 39,  39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 77, 75, 29, 29, 66, 56, 86, 75, 79,
    60, 79, 69, 63, 61, 73, 68, 99, 69,  61, 69, 39, 34, 39, 84, 50, 50, 61, 63, 55, 63, 62, 35, 63,
    63, 28, 28, 58, 28, 97, 63, 61, 63,  63, 41, 52, 39, 63, 59, 82, 59, 59, 52, 64, 34, 64, 84};

/// The bytes of the character that begins at `at`, and its number; 0 for bytes that are not UTF-8, one by one.
struct Character {
  std::size_t bytes;
  char32_t code;
};
Character character_at(std::string_view text, std::size_t at) {
  const char* const p = text.data() + at;
  const auto first = static_cast<unsigned char>(*p);
  if (first < 0x80) return {1, first};
  const char* const next = skip_utf8(p, text.data() + text.size());
  if (next == nullptr) return {1, 0};
  char32_t code = first & (0x7Fu >> (next - p));
  for (const char* more = p + 1; more != next; ++more) code = code << 6 | (static_cast<unsigned char>(*more) & 0x3F);
  return {static_cast<std::size_t>(next - p), code};
}

double character_width(char32_t code) {
  if (code >= 0x20 && code <= 0x7E) return ascii_widths[code - 0x20] / 100.0;
  if (code >= 0x300 && code < 0x370) return 0;  // marks on the letter before
  return code >= 0x1100 ? 1 : 0.8;
}

}  // namespace

double text_width(std::string_view text, double font_size, bool bold) {
  double width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    width += character_width(c.code);
    at += c.bytes;
  }
  return width * font_size * (bold ? 1.12 : 1);
}

std::string shortened(const std::string& text, double width, double font_size, bool bold) {
  if (text_width(text, font_size, bold) <= width) return text;
  std::string kept;
  const double room = width - text_width(ellipsis, font_size, bold);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_at(text, at).bytes;
    const std::string longer = kept + text.substr(at, bytes);
    if (text_width(longer, font_size, bold) > room) break;
    kept = longer;
    at += bytes;
  }
  while (!kept.empty() && kept.back() == ' ') kept.pop_back();
  return kept.append(ellipsis);
}

std::vector<std::string> wrapped(const std::string& text, double width, double font_size, bool bold, std::size_t most) {
  std::vector<std::string> lines;
  std::string rest = text;
  std::replace_if(
      rest.begin(), rest.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  while (!rest.empty()) {
    if (lines.size() + 1 == most || text_width(rest, font_size, bold) <= width) {
      lines.push_back(shortened(rest, width, font_size, bold));
      break;
    }
    std::size_t fits = 0, word_end = 0;
    for (std::size_t at = 0; at < rest.size();) {
      const std::size_t next = at + character_at(rest, at).bytes;
      if (text_width(std::string_view(rest).substr(0, next), font_size, bold) > width && at > 0) break;
      if (rest[at] == ' ') word_end = at;
      fits = at = next;
    }
    if (fits < rest.size() && rest[fits] == ' ') word_end = fits;
    const std::size_t end = word_end > 0 ? word_end : fits;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, rest.find_first_not_of(' ', end));
  }
  return lines;
}

std::string escape_xml(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    switch (c.code) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default: {
        const bool held = (c.code >= 0x20 || c.code == '\n' || c.code == '\t') && c.code != 0xFFFE && c.code != 0xFFFF;
        result.append(held ? text.substr(at, c.bytes) : replacement);
      }
    }
    at += c.bytes;
  }
  return result;
}

namespace {
std::string with_digits(double value, int digits) {
  std::array<char, 40> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}
}  // namespace

std::string short_number(double value) { return with_digits(value, 6); }

std::string exact_number(double value) {
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0).ptr;
  return {text.data(), end};
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
  double step = HUGE_VAL, largest = 0;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    largest = std::max(largest, std::abs(ticks[k]));
    if (k > 0) step = std::min(step, ticks[k] - ticks[k - 1]);
  }
  int digits = 6;
  // A tick is a multiple of one digit times a power of ten, so the digits down to the step's first one are enough.
  if (largest > 0 && step > 0 && std::isfinite(step))
    digits = std::clamp(2 + static_cast<int>(std::floor(std::log10(largest)) - std::floor(std::log10(step))), 1, 17);
  std::vector<std::string> labels;
  for (const double tick : ticks)
    labels.push_back(with_digits(std::isfinite(step) && std::abs(tick) < 1e-9 * step ? 0 : tick, std::max(digits, 6)));
  return labels;
}

void write_text(std::string& out, double x, double y, std::string_view attributes, std::string_view text) {
  out += "<text x=\"" + short_number(x) + "\" y=\"" + short_number(y) + "\"";
  out.append(attributes).append(">").append(escape_xml(text)).append("</text>\n");
}

}  // namespace pliant
