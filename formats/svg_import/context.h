// formats/svg_import/context.h: what an element inherits from those around it, and its own place in the drawing.
#pragma once
#include <string>
#include <string_view>

#include "formats/svg_import/notices.h"
#include "formats/svg_import/shapes.h"
#include "formats/svg_import/style.h"

namespace pliant::svg {

/// What an element inherits from those around it: properties, the map to the result, the viewport.
struct Context {
  Affine map;
  Viewport viewport;
  std::string_view fill = "black", fill_rule = "nonzero", fill_opacity = "1", stroke = "none", visibility = "visible";
  std::string_view color = "black", marker_start = "none", marker_mid = "none", marker_end = "none";
  std::string_view clip_rule = "nonzero", stroke_width = "1", stroke_opacity = "1", stroke_linejoin = "miter";
  std::string_view stroke_linecap = "butt", stroke_miterlimit = "4", stroke_dasharray = "none", stroke_dashoffset = "0";
  std::string_view paint_order = "normal";
  std::string_view context_fill = "none", context_stroke = "none";  ///< fill and stroke of the innermost `use`
  bool transparent = false;
  const Element* shown_by = nullptr;  ///< the innermost `use` that shows the element, or null
  int depth = 0;

  bool has_markers() const { return marker_start != "none" || marker_mid != "none" || marker_end != "none"; }
};

/// Puts the inherited properties and the opacity that the element declares into `context`; values that are not
/// understood change nothing.
void inherit(Context& context, const Element& element, const Declarations& declared, Notices& notices);

/// The element's transform about its transform-origin. A transform in the style goes before the attribute.
/// Throws      InputError for an attribute that is no transform
Affine transform_of(const Element& element, const Declarations& declared, const Viewport& viewport, Notices& notices);

/// A copy of the element whose attributes for lengths and outline are replaced by what its style declares.
Element with_geometry_of_style(const Element& element, const Declarations& declared, Notices& notices);
/// Does the style declare a length or an outline?
bool has_geometry(const Declarations& declared);

/// Is the element shown to a reader of English by a program without extensions of SVG?
bool meets_conditions(const Element& element);

/// The value that the element itself declares, or "".
inline std::string_view own(const Declarations& declared, Property property) {
  return declared[static_cast<std::size_t>(property)];
}

}  // namespace pliant::svg
