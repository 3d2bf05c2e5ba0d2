// formats/picture/svg/text.h: words in a picture, and the room that they take.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The fonts of all words: the first that a viewer has.
inline constexpr std::string_view font_family =
    "system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', Helvetica, Arial, sans-serif";

/// The width of a line of text in DejaVu Sans, which is wider than most fonts without serifs.
double text_width(std::string_view text, double font_size, bool bold = false);
/// The text, its end replaced by "…" if it is wider than `width`.
std::string shortened(const std::string& text, double width, double font_size, bool bold = false);
/// The text in lines no wider than `width`, broken between words where there are any; the last line is shortened if
/// there would be more than `most`.
std::vector<std::string> wrapped(const std::string& text, double width, double font_size, bool bold, std::size_t most);

/// The text with &, <, > and " escaped; what XML cannot hold (control characters, bytes that are not UTF-8) becomes
/// U+FFFD.
std::string escape_xml(std::string_view text);
/// The number with six significant digits.
std::string short_number(double value);
/// The number with the fewest digits that read back as the same number.
std::string exact_number(double value);
/// Numbers with as many significant digits as it takes to tell those of steps apart.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// Appends a text element; `attributes` begin with a space.
void write_text(std::string& out, double x, double y, std::string_view attributes, std::string_view text);

}  // namespace pliant
