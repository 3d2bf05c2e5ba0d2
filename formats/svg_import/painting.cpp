// formats/svg_import/painting.cpp: whether paints show, and how outlines are stroked.
#include "formats/svg_import/painting.h"

#include <algorithm>
#include <cmath>

#include "formats/svg_import/paint.h"
#include "formats/svg_import/scene.h"

namespace pliant::svg {
namespace {

/// Does the element paint where it is referred to? Gradients and patterns do.
bool reference_paints(std::string_view paint, const Element& element, const Context& context, const ElementTree& tree,
                      Notices& notices) {
  const std::string id = referenced_id(paint);
  const int target = id.empty() ? no_element : tree.find(id);
  const std::string kind = target == no_element ? "" : tree[target].name;
  if (kind == "pattern" || kind == "hatch") {
    notices.add("a pattern is taken for a colour", element);
  } else if (kind == "linearGradient" || kind == "radialGradient" || kind == "meshgradient" || kind == "solidColor") {
    notices.add("a gradient is taken for a colour", element);
  } else {
    notices.add("a fill or stroke refers to a paint that does not exist", element);
    std::string_view behind = paint.substr(std::min(paint.find(')'), paint.size() - 1) + 1);
    while (!behind.empty() && behind.front() == ' ') behind.remove_prefix(1);
    return classify_paint(behind) != Paint::reference && paints(behind, element, context, tree, notices);
  }
  return true;
}

void read_dashes(const Element& element, const Context& context, StrokeStyle& style, Notices& notices) {
  if (is_same_word(context.stroke_dasharray, "none")) return;
  double sum = 0;
  try {
    const std::string_view rest = context.stroke_dasharray;
    constexpr std::string_view between = " \t\r\n\f,";
    for (std::size_t at = rest.find_first_not_of(between); at != std::string_view::npos;) {
      const std::size_t end = std::min(rest.find_first_of(between, at), rest.size());
      const double dash = resolve(parse_length(rest.substr(at, end - at)), Along::both, context.viewport);
      if (!(dash >= 0 && std::isfinite(dash))) throw SyntaxError(at, "expected a length");
      style.dashes.push_back(dash);
      sum += dash;
      at = rest.find_first_not_of(between, end);
    }
    style.dash_offset = resolve(parse_length(context.stroke_dashoffset), Along::both, context.viewport);
    if (!std::isfinite(style.dash_offset)) style.dash_offset = 0;
  } catch (const SyntaxError&) {
    notices.add("dashes that are no lengths are drawn through", element);
    style.dashes.clear();
    return;
  }
  if (style.dashes.size() % 2 != 0) {
    const std::vector<double> once = style.dashes;
    style.dashes.insert(style.dashes.end(), once.begin(), once.end());
  }
  if (!(sum > 0 && std::isfinite(2 * sum))) style.dashes.clear();  // as SVG says, a solid line
}

}  // namespace

bool paints(std::string_view paint, const Element& element, const Context& context, const ElementTree& tree,
            Notices& notices) {
  switch (classify_paint(paint)) {
    case Paint::colour:
      return true;
    case Paint::invisible:
    case Paint::not_understood:
      return false;
    case Paint::current:
      return classify_paint(context.color) == Paint::colour;
    case Paint::of_fill:
      return paints(context.context_fill, element, context, tree, notices);
    case Paint::of_stroke:
      return paints(context.context_stroke, element, context, tree, notices);
    case Paint::reference:
      return reference_paints(paint, element, context, tree, notices);
  }
  return true;
}

double stroke_width(const Element& element, const Context& context, Notices& notices) {
  try {
    const double width = resolve(parse_length(context.stroke_width), Along::both, context.viewport);
    if (std::isfinite(width) && width >= 0) return width;
  } catch (const SyntaxError&) {  // CSS passes over what it does not understand
  }
  notices.add("a stroke-width that is no length is taken for 1", element);
  return 1;
}

bool has_stroke_width(const Element& element, const Context& context) {
  Notices said_later;
  return stroke_width(element, context, said_later) > 0;
}

StrokeStyle stroke_style(const Element& element, const Declarations& declared, const Context& context,
                         Notices& notices) {
  constexpr double usual_miter_limit = 4;
  StrokeStyle style;
  style.width = stroke_width(element, context, notices);
  style.join = is_same_word(context.stroke_linejoin, "round")   ? LineJoin::round
               : is_same_word(context.stroke_linejoin, "bevel") ? LineJoin::bevel
                                                                : LineJoin::miter;
  if (is_same_word(context.stroke_linejoin, "arcs") || is_same_word(context.stroke_linejoin, "miter-clip"))
    notices.add("stroke-linejoin arcs and miter-clip are taken for miter", element);
  style.cap = is_same_word(context.stroke_linecap, "round")    ? LineCap::round
              : is_same_word(context.stroke_linecap, "square") ? LineCap::square
                                                               : LineCap::butt;
  style.miter_limit = fraction_of(context.stroke_miterlimit, usual_miter_limit);
  if (style.miter_limit < 1) style.miter_limit = usual_miter_limit;
  if (is_same_word(own(declared, Property::vector_effect), "non-scaling-stroke"))
    notices.add("vector-effect is not read: strokes are scaled with their shapes", element);
  if (element.find("pathLength") != nullptr && context.stroke_dasharray != "none")
    notices.add("pathLength does not scale dashes", element);
  read_dashes(element, context, style, notices);
  return style;
}

void check_coordinates(const Element& element, const Outline& outline) {
  for (const Point& p : outline.points)
    if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate))
      refuse(element, "a coordinate is beyond 1e60");
}

}  // namespace pliant::svg
