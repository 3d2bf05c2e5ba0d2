// formats/svg_import/shapes.cpp: the outlines of path, rect, circle, ellipse, line, polyline and polygon.
#include "formats/svg_import/shapes.h"

#include <algorithm>
#include <numbers>

#include "formats/svg_import/path_data.h"
#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

/// A quarter of an ellipse whose axes are parallel to the coordinate axes. Quarter 0 starts on the x axis and runs in
/// the direction of growing angles; 1, 2 and 3 follow it.
void add_quarter(Outline& out, const Point& center, double rx, double ry, int quarter, const Point& end) {
  constexpr double right = std::numbers::pi / 2;
  static constexpr Vector axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const Vector a = axes[quarter % 4], b = axes[(quarter + 1) % 4];
  out.arc(center, {rx * a.x, ry * a.y}, {rx * b.x, ry * b.y}, 0, right, end);
}

void add_ellipse(Outline& out, const Point& c, double rx, double ry) {
  if (rx == 0 || ry == 0) return;
  const Point ends[] = {{c.x + rx, c.y}, {c.x, c.y + ry}, {c.x - rx, c.y}, {c.x, c.y - ry}};
  out.move(ends[0]);
  for (int quarter = 0; quarter < 4; ++quarter) add_quarter(out, c, rx, ry, quarter, ends[(quarter + 1) % 4]);
  out.close();
}

/// The length of an attribute, which must not be negative; `otherwise` for "auto".
double extent(const Element& element, const char* attribute, Along along, const Viewport& viewport, double otherwise) {
  const std::string* value = element.find(attribute);
  if (value != nullptr && *value == "auto") return otherwise;
  const double length = length_of(element, attribute, along, viewport, otherwise);
  if (value != nullptr && length < 0) refuse(element, std::string(attribute) + " is negative: '" + *value + "'");
  return length;
}

void add_rect(Outline& out, const Element& element, const Viewport& viewport) {
  const double x = length_of(element, "x", Along::x, viewport), y = length_of(element, "y", Along::y, viewport);
  const double width = extent(element, "width", Along::x, viewport, 0);
  const double height = extent(element, "height", Along::y, viewport, 0);
  if (width == 0 || height == 0) return;
  double rx = extent(element, "rx", Along::x, viewport, -1), ry = extent(element, "ry", Along::y, viewport, -1);
  // Where only one radius is given, it is both.
  if (rx < 0) rx = ry;
  if (ry < 0) ry = rx;
  rx = std::clamp(rx, 0.0, width / 2);
  ry = std::clamp(ry, 0.0, height / 2);
  const double right = x + width, low = y + height;
  if (rx == 0 || ry == 0) {
    out.move({x, y});
    out.line({right, y});
    out.line({right, low});
    out.line({x, low});
    return out.close();
  }
  out.move({x + rx, y});
  out.line({right - rx, y});
  add_quarter(out, {right - rx, y + ry}, rx, ry, 3, {right, y + ry});
  out.line({right, low - ry});
  add_quarter(out, {right - rx, low - ry}, rx, ry, 0, {right - rx, low});
  out.line({x + rx, low});
  add_quarter(out, {x + rx, low - ry}, rx, ry, 1, {x, low - ry});
  out.line({x, y + ry});
  add_quarter(out, {x + rx, y + ry}, rx, ry, 2, {x + rx, y});
  out.close();
}

}  // namespace

std::string describe(const Element& element) {
  const std::string* id = element.find("id");
  return id == nullptr ? element.name : element.name + " '" + *id + "'";
}

void refuse(const Element& element, const std::string& text) {
  throw InputError(place_of(element), describe(element) + ": " + text);
}

void refuse(const Element& element, const char* attribute, const SyntaxError& error) {
  refuse(element, std::string(attribute) + ", offset " + std::to_string(error.offset()) + ": " + error.what());
}

double resolve(const Length& length, Along along, const Viewport& viewport) {
  switch (length.unit) {
    case Unit::user:
      return length.value;
    case Unit::percent: {
      const double whole = along == Along::x   ? viewport.width
                           : along == Along::y ? viewport.height
                                               : std::hypot(viewport.width, viewport.height) / std::numbers::sqrt2;
      return whole * length.value / 100;
    }
    case Unit::em:
      return length.value * viewport.font_size;
    case Unit::rem:
      return length.value * viewport.root_font_size;
    case Unit::vw:
      return length.value * viewport.window_width / 100;
    case Unit::vh:
      return length.value * viewport.window_height / 100;
    case Unit::vmin:
      return length.value * std::min(viewport.window_width, viewport.window_height) / 100;
    case Unit::vmax:
      return length.value * std::max(viewport.window_width, viewport.window_height) / 100;
  }
  return Viewport::unknown;
}

double length_of(const Element& element, const char* attribute, Along along, const Viewport& viewport,
                 double otherwise) {
  const std::string* value = element.find(attribute);
  if (value == nullptr) return otherwise;
  Length length;
  try {
    length = parse_length(*value);
  } catch (const SyntaxError& e) {
    refuse(element, attribute, e);
  }
  const double resolved = resolve(length, along, viewport);
  if (!std::isfinite(resolved))
    refuse(element, std::string(attribute) + " is '" + *value + "', but the drawing has " +
                        (length.unit == Unit::percent ? "neither a viewBox nor" : "not") +
                        " a width and height that a part could be of");
  return resolved;
}

bool is_shape(std::string_view name) {
  return name == "path" || name == "rect" || name == "circle" || name == "ellipse" || name == "polygon" ||
         name == "polyline" || name == "line";
}

Outline outline_of(const Element& element, const Viewport& viewport) {
  Outline out;
  if (element.name == "path" || element.name == "polygon" || element.name == "polyline") {
    const bool is_path = element.name == "path";
    const char* attribute = is_path ? "d" : "points";
    const std::string* value = element.find(attribute);
    if (value == nullptr) return out;
    try {
      return is_path ? parse_path_data(*value) : parse_points(*value);
    } catch (const SyntaxError& e) {
      refuse(element, attribute, e);
    }
  }
  if (element.name == "rect") {
    add_rect(out, element, viewport);
    return out;
  }
  if (element.name == "line") {
    out.move({length_of(element, "x1", Along::x, viewport), length_of(element, "y1", Along::y, viewport)});
    out.line({length_of(element, "x2", Along::x, viewport), length_of(element, "y2", Along::y, viewport)});
    return out;
  }
  const Point c{length_of(element, "cx", Along::x, viewport), length_of(element, "cy", Along::y, viewport)};
  if (element.name == "circle") {
    const double r = extent(element, "r", Along::both, viewport, 0);
    add_ellipse(out, c, r, r);
    return out;
  }
  double rx = extent(element, "rx", Along::x, viewport, -1), ry = extent(element, "ry", Along::y, viewport, -1);
  if (rx < 0) rx = std::max(ry, 0.0);
  if (ry < 0) ry = rx;
  add_ellipse(out, c, rx, ry);
  return out;
}

}  // namespace pliant::svg
