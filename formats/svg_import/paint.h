// formats/svg_import/paint.h: does a paint show anything? CSS colours in every spelling.
#pragma once
#include <string_view>

namespace pliant::svg {

enum class Paint {
  colour,          ///< one that shows
  invisible,       ///< none, or a colour of alpha 0
  current,         ///< the property `color`
  of_fill,         ///< context-fill
  of_stroke,       ///< context-stroke
  reference,       ///< url(...): a gradient or a pattern
  not_understood,  ///< var(...), or words of no paint: CSS passes over those
};

/// What a value of `fill`, `stroke` or `color` is; a colour of SVG 1.1 may have an icc-color behind it.
Paint classify_paint(std::string_view value);

/// Are the words the same but for the case of A to Z?
bool is_same_word(std::string_view a, std::string_view b);

/// The number at the start of a text, of a percentage the hundredth; `otherwise` where there is none.
double fraction_of(std::string_view text, double otherwise);

}  // namespace pliant::svg
