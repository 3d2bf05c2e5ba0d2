// formats/svg_import/shapes.h: the outlines of path, rect, circle, ellipse, line, polyline and polygon.
#pragma once
#include <limits>

#include "formats/svg_import/areas/outline.h"
#include "formats/svg_import/element_tree.h"
#include "formats/svg_import/scanner.h"

namespace pliant::svg {

/// What relative lengths refer to, in user units: percentages to the viewport's width and height, em and rem to font
/// sizes, vw and vh to the window.
struct Viewport {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  ///< lengths that refer to it are refused
  static constexpr double medium = 16;  ///< font size where the drawing says none

  double width = unknown, height = unknown;
  double font_size = medium, root_font_size = medium;
  double window_width = unknown, window_height = unknown;
};
enum class Along { x, y, both };

/// The length in user units; NaN where it refers to a size that is unknown.
double resolve(const Length& length, Along along, const Viewport& viewport);

/// The length of an attribute in user units; `otherwise` where it is missing.
/// Throws      InputError with the element's line and column
double length_of(const Element& element, const char* attribute, Along along, const Viewport& viewport,
                 double otherwise = 0);

/// Is this the name of an element with an outline? (That of `line` has no interior.)
bool is_shape(std::string_view name);

/// The outline of a shape in its own coordinates, in the direction that SVG prescribes; empty where the shape is not
/// drawn (a width of 0).
/// Throws      InputError with the element's line and column: syntax, negative lengths
Outline outline_of(const Element& element, const Viewport& viewport);

/// The element's name and id: "path 'wing'".
std::string describe(const Element& element);
/// Throws an InputError with the element's place.
[[noreturn]] void refuse(const Element& element, const std::string& text);
/// Throws an InputError that says what is wrong with an attribute, and where in its value.
[[noreturn]] void refuse(const Element& element, const char* attribute, const SyntaxError& error);

}  // namespace pliant::svg
