// formats/svg_import/context.cpp: what an element inherits from those around it, and its own place in the drawing.
#include "formats/svg_import/context.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "formats/svg_import/paint.h"

namespace pliant::svg {
namespace {

/// The words of a text, which white space and commas separate.
std::vector<std::string_view> words(std::string_view text) {
  constexpr std::string_view between = " \t\r\n\f,";
  std::vector<std::string_view> out;
  for (std::size_t at = text.find_first_not_of(between); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    out.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(between, end);
  }
  return out;
}

/// Replaces the inherited value by the declared one. Where nothing or "inherit" is declared, it stays.
void take(std::string_view& value, std::string_view declared, std::string_view initial) {
  if (declared.empty()) return;
  for (const char* word : {"inherit", "unset", "revert", "revert-layer"})
    if (is_same_word(declared, word)) return;
  value = is_same_word(declared, "initial") ? initial : declared;
}

void take_paint(std::string_view& value, std::string_view declared, std::string_view initial, const Element& element,
                Notices& notices) {
  std::string_view taken = value;
  take(taken, declared, initial);
  if (!declared.empty() && classify_paint(taken) == Paint::not_understood)
    return notices.add("a paint that is not understood is passed over", element);
  value = taken;
}

/// Throws      SyntaxError
double font_size_of(std::string_view text, const Viewport& viewport) {
  static constexpr std::array<std::pair<std::string_view, double>, 8> named{{{"xx-small", 9},
                                                                             {"x-small", 10},
                                                                             {"small", 13},
                                                                             {"medium", Viewport::medium},
                                                                             {"large", 18},
                                                                             {"x-large", 24},
                                                                             {"xx-large", 32},
                                                                             {"xxx-large", 48}}};
  constexpr double step = 1.2;
  for (const auto& [name, size] : named)
    if (is_same_word(text, name)) return size;
  if (is_same_word(text, "larger")) return viewport.font_size * step;
  if (is_same_word(text, "smaller")) return viewport.font_size / step;
  const Length length = parse_length(text);
  const double size =
      length.unit == Unit::percent ? viewport.font_size * length.value / 100 : resolve(length, Along::y, viewport);
  if (!(std::isfinite(size) && size >= 0)) throw SyntaxError(0, "expected a size of at least 0");
  return size;
}

void take_font_size(Context& context, const Element& element, const Declarations& declared, Notices& notices) {
  std::string_view text = own(declared, Property::font_size);
  if (text.empty())
    for (const std::string_view word : words(own(declared, Property::font))) {
      // "bold 12px/14px serif": the size is the first that has a unit.
      const std::string_view size = word.substr(0, word.find('/'));
      const std::size_t unit = size.find_first_not_of("0123456789.");
      if (unit != 0 && unit != std::string_view::npos) text = size;
      if (!text.empty()) break;
    }
  std::string_view value;
  take(value, text, "medium");
  if (value.empty()) return;
  Viewport& viewport = context.viewport;
  try {
    viewport.font_size = font_size_of(value, viewport);
    if (context.depth <= 1) viewport.root_font_size = viewport.font_size;
  } catch (const SyntaxError&) {
    notices.add("a font-size that is not understood is passed over", element);
  }
}

/// One coordinate of a transform-origin; empty for a word that is no coordinate along this axis.
std::optional<double> origin_along(std::string_view word, Along along, const Viewport& viewport) {
  Length length;
  if (is_same_word(word, along == Along::x ? "left" : "top"))
    length = {0, Unit::percent};
  else if (is_same_word(word, "center"))
    length = {50, Unit::percent};
  else if (is_same_word(word, along == Along::x ? "right" : "bottom"))
    length = {100, Unit::percent};
  else if (Scanner(word).at_number())
    length = parse_length(word);
  else
    return std::nullopt;
  if (length.unit == Unit::percent && length.value == 0) return 0;
  return resolve(length, along, viewport);
}

/// Throws      SyntaxError
Point origin_of(std::string_view text, const Viewport& viewport) {
  std::vector<std::string_view> parts = words(text);
  if (parts.empty() || parts.size() > 3) throw SyntaxError(0, "expected one to three lengths");
  if (parts.size() == 1) parts.push_back("center");
  auto x = origin_along(parts[0], Along::x, viewport), y = origin_along(parts[1], Along::y, viewport);
  if (!x || !y) {  // the order is y x in "top left", and "top" stands alone
    x = origin_along(parts[1], Along::x, viewport);
    y = origin_along(parts[0], Along::y, viewport);
  }
  if (!x || !y) throw SyntaxError(0, "expected lengths, or left, center, right, top, bottom");
  if (!std::isfinite(*x) || !std::isfinite(*y))
    throw SyntaxError(0, "it is a part of the drawing's size, but the drawing has neither a viewBox nor a size");
  return {*x, *y};
}

Affine about(const Affine& map, const Point& origin) {
  return Affine{1, 0, 0, 1, origin.x, origin.y} * map * Affine{1, 0, 0, 1, -origin.x, -origin.y};
}

}  // namespace

void inherit(Context& context, const Element& element, const Declarations& declared, Notices& notices) {
  take_font_size(context, element, declared, notices);
  if (!is_same_word(own(declared, Property::color), "currentcolor"))
    take_paint(context.color, own(declared, Property::color), "black", element, notices);
  take_paint(context.fill, own(declared, Property::fill), "black", element, notices);
  take_paint(context.stroke, own(declared, Property::stroke), "none", element, notices);
  take(context.fill_rule, own(declared, Property::fill_rule), "nonzero");
  take(context.clip_rule, own(declared, Property::clip_rule), "nonzero");
  take(context.stroke_width, own(declared, Property::stroke_width), "1");
  take(context.stroke_opacity, own(declared, Property::stroke_opacity), "1");
  take(context.stroke_linejoin, own(declared, Property::stroke_linejoin), "miter");
  take(context.stroke_linecap, own(declared, Property::stroke_linecap), "butt");
  take(context.stroke_miterlimit, own(declared, Property::stroke_miterlimit), "4");
  take(context.stroke_dasharray, own(declared, Property::stroke_dasharray), "none");
  take(context.stroke_dashoffset, own(declared, Property::stroke_dashoffset), "0");
  take(context.paint_order, own(declared, Property::paint_order), "normal");
  take(context.fill_opacity, own(declared, Property::fill_opacity), "1");
  take(context.visibility, own(declared, Property::visibility), "visible");
  for (auto [value, property] :
       {std::pair(&context.marker_start, Property::marker_start), std::pair(&context.marker_mid, Property::marker_mid),
        std::pair(&context.marker_end, Property::marker_end)}) {
    take(*value, own(declared, Property::marker), "none");
    take(*value, own(declared, property), "none");
  }
  if (const auto opacity = own(declared, Property::opacity); !opacity.empty() && fraction_of(opacity, 1) <= 0)
    context.transparent = true;
}

Affine transform_of(const Element& element, const Declarations& declared, const Viewport& viewport, Notices& notices) {
  const auto is_set = [&](Property property) {
    const std::string_view value = own(declared, property);
    return !value.empty() && value != "none" && value != "initial" && value != "unset";
  };
  for (const Property property : {Property::translate, Property::rotate, Property::scale, Property::offset_path})
    if (is_set(property)) notices.add(std::string(name_of(property)) + " in a style moves nothing", element);
  Affine map;
  const std::string* attribute = element.find("transform");
  if (const std::string_view style = own(declared, Property::transform); !style.empty()) {
    try {
      map = is_set(Property::transform) ? parse_style_transform(style) : Affine{};
    } catch (const SyntaxError& e) {
      notices.add("a transform in a style is not read", element);
      return map;
    }
  } else if (attribute != nullptr) {
    try {
      map = parse_transform(*attribute);
    } catch (const SyntaxError& e) {
      refuse(element, "transform", e);
    }
  } else {
    return map;
  }
  // A transform-box moves the default origin too, so it counts also without a transform-origin.
  if (is_set(Property::transform_box) && !is_same_word(own(declared, Property::transform_box), "view-box"))
    notices.add("transform-box is taken for view-box", element);
  if (!is_set(Property::transform_origin)) return map;
  try {
    const Point origin = origin_of(own(declared, Property::transform_origin), viewport);
    return origin.x == 0 && origin.y == 0 ? map : about(map, origin);
  } catch (const SyntaxError& e) {
    refuse(element, "transform-origin", e);
  }
}

bool has_geometry(const Declarations& declared) {
  return std::any_of(declared.begin() + static_cast<long>(first_of_geometry), declared.end(),
                     [](std::string_view value) { return !value.empty(); });
}

Element with_geometry_of_style(const Element& element, const Declarations& declared, Notices& notices) {
  Element out = element;
  for (std::size_t i = static_cast<std::size_t>(first_of_geometry); i < property_count; ++i) {
    std::string value(declared[i]);
    if (value.empty()) continue;
    const std::string name(name_of(static_cast<Property>(i)));
    if (name == "d") {
      const std::size_t first = value.find_first_of("\"'"), last = value.find_last_of("\"'");
      if (value == "none")
        value.clear();
      else if (value.substr(0, 4) == "path" && first < last && last != std::string::npos)
        value = value.substr(first + 1, last - first - 1);
      else {
        notices.add("an outline in a style is not read (d)", element);
        continue;
      }
    }
    const bool has_unit =
        name == "d" || value.find_first_not_of("+-0123456789.eE") != std::string::npos || fraction_of(value, 1) == 0;
    if (!has_unit) {
      notices.add("a length without a unit in a style is passed over (" + name + ")", element);
      continue;
    }
    const auto same = std::find_if(out.attributes.begin(), out.attributes.end(),
                                   [&](const auto& attribute) { return attribute.first == name; });
    if (same != out.attributes.end())
      same->second = value;
    else
      out.attributes.emplace_back(name, value);
  }
  return out;
}

bool meets_conditions(const Element& element) {
  if (element.find("requiredExtensions") != nullptr) return false;
  const std::string* languages = element.find("systemLanguage");
  if (languages == nullptr) return true;
  const std::vector<std::string_view> tags = words(*languages);
  return std::any_of(tags.begin(), tags.end(), [](std::string_view tag) {
    return is_same_word(tag.substr(0, 2), "en") && (tag.size() == 2 || tag[2] == '-');
  });
}

}  // namespace pliant::svg
