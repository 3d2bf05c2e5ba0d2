// formats/svg_import/paint.h: does a paint show anything? CSS colours in every spelling.
#pragma once
#include <string>
#include <string_view>

namespace pliant::svg {

enum class Paint {
  colour,          ///< a colour that shows
  invisible,       ///< "none", or a colour of alpha 0
  current,         ///< currentColor: the paint is the property `color`
  of_fill,         ///< context-fill: the fill of the `use` around it
  of_stroke,       ///< context-stroke: the stroke of the `use` around it
  reference,       ///< url(...): a gradient or a pattern
  not_understood,  ///< var(...), or words that are no paint: CSS passes over both
};

/// The kind of a value of `fill`, `stroke` or `color`. In SVG 1.1 an icc-color may follow a colour.
Paint classify_paint(std::string_view value);

/// Are the words equal if A to Z count as a to z?
bool is_same_word(std::string_view a, std::string_view b);

/// The id in "url(#id)", which may have quotes and something behind it; empty where the value is no such reference.
std::string referenced_id(std::string_view value);

/// The number at the start of a text (50% is 0.5); `otherwise` where no number stands there.
double fraction_of(std::string_view text, double otherwise);

}  // namespace pliant::svg
