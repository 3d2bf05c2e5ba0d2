// formats/svg_import/viewport.cpp: viewBox, preserveAspectRatio, and the size of the page.
#include "formats/svg_import/viewport.h"

#include <algorithm>

namespace pliant::svg {
namespace {

/// Which part of the free room lies before the box: for "xMidYMax" 1/2 along x and 1 along y.
double share(const std::string& word, std::size_t at) {
  const std::string part = word.substr(at, 3);
  return part == "Min" ? 0 : part == "Max" ? 1 : 0.5;
}

}  // namespace

std::optional<ViewBox> view_box_of(const Element& element) {
  const std::string* value = element.find("viewBox");
  if (value == nullptr) return std::nullopt;
  ViewBox box{};
  try {
    Scanner in(*value);
    in.skip_space();
    for (double* number : {&box.x, &box.y, &box.width, &box.height}) {
      *number = in.number("a number (x, y, width and height)");
      in.skip_comma();
    }
    if (!in.at_end()) in.fail("the end behind four numbers");
  } catch (const SyntaxError& e) {
    refuse(element, "viewBox", e);
  }
  if (box.width < 0 || box.height < 0) refuse(element, "viewBox has a negative width or height: '" + *value + "'");
  return box;
}

Affine fit_view_box(const Element& element, const ViewBox& box, double width, double height) {
  double sx = width / box.width, sy = height / box.height;
  double x = 0, y = 0;
  std::string align = "xMidYMid";
  bool slice = false;
  if (const std::string* value = element.find("preserveAspectRatio")) {
    const std::size_t at = value->find('x');
    if (value->find("none") != std::string::npos)
      align = "none";
    else if (at != std::string::npos)
      align = value->substr(at, 8);
    slice = value->find("slice") != std::string::npos;
  }
  if (align != "none") {
    sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
    x = (width - sx * box.width) * share(align, 1);
    y = (height - sy * box.height) * (align.size() < 8 ? 0.5 : share(align, 5));
  }
  return {sx, 0, 0, sy, x - sx * box.x, y - sy * box.y};
}

Affine page_map(const Element& root, const Viewport& viewport) {
  const auto size = [&](const char* attribute) -> std::optional<double> {
    const std::string* value = root.find(attribute);
    if (value == nullptr || *value == "auto") return std::nullopt;
    Length length;
    try {
      length = parse_length(*value);
    } catch (const SyntaxError& e) {
      refuse(root, attribute, e);
    }
    if (length.unit == Unit::percent) return std::nullopt;
    const bool is_of_window =
        length.unit == Unit::vw || length.unit == Unit::vh || length.unit == Unit::vmin || length.unit == Unit::vmax;
    const double resolved = is_of_window ? Viewport::unknown : resolve(length, Along::x, viewport);
    if (!(resolved > 0 && std::isfinite(resolved)))
      refuse(root, std::string(attribute) + " is '" + *value + "', which gives the page no size; --unit needs " +
                       (is_of_window ? "lengths such as 100mm" : "a length above 0"));
    return resolved;
  };
  const std::optional<double> width = size("width"), height = size("height");
  const auto box = view_box_of(root);
  if (!box) return {};
  if (!(box->width > 0 && box->height > 0))
    refuse(root,
           "viewBox has no extent, so that a user unit has no length on the page; --unit needs a width and height "
           "above 0 there");
  if (!width && !height) return {1, 0, 0, 1, -box->x, -box->y};
  const double w = width.value_or(height.value_or(0) * (box->width / box->height));
  const double h = height.value_or(width.value_or(0) * (box->height / box->width));
  const Affine map = fit_view_box(root, *box, w, h);
  if (!(std::isfinite(map.a) && std::isfinite(map.d) && map.a > 0 && map.d > 0 && is_finite(Point{map.e, map.f})))
    refuse(root, "width, height and viewBox give a user unit no length on the page that a number could say");
  return map;
}

Viewport root_viewport(const Element& root, double font_size) {
  Viewport viewport;
  const auto size = [&](const char* attribute) {
    const std::string* value = root.find(attribute);
    if (value == nullptr || *value == "auto") return Viewport::unknown;
    try {
      const Length length = parse_length(*value);
      return length.unit == Unit::percent ? Viewport::unknown : resolve(length, Along::x, viewport);
    } catch (const SyntaxError& e) {
      refuse(root, attribute, e);
    }
  };
  viewport.font_size = viewport.root_font_size = font_size;
  viewport.window_width = size("width");
  viewport.window_height = size("height");
  viewport.width = viewport.window_width;
  viewport.height = viewport.window_height;
  if (const auto box = view_box_of(root)) {
    viewport.width = box->width;
    viewport.height = box->height;
  }
  return viewport;
}

double length_of_px(LengthUnit unit) {
  constexpr double px_in_an_inch = 96;
  switch (unit) {
    case LengthUnit::in:
      return 1 / px_in_an_inch;
    case LengthUnit::cm:
      return 2.54 / px_in_an_inch;
    case LengthUnit::mm:
      return 25.4 / px_in_an_inch;
    case LengthUnit::px:
    case LengthUnit::user:
      break;
  }
  return 1;
}

}  // namespace pliant::svg
