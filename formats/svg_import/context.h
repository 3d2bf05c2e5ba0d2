// formats/svg_import/context.h: what an element inherits from those around it, and its own place in the drawing.
#pragma once
#include <string>
#include <string_view>

#include "formats/svg_import/notices.h"
#include "formats/svg_import/shapes.h"
#include "formats/svg_import/style.h"

namespace pliant::svg {

/// What is inherited, and where we are.
struct Context {
  Affine map;
  Viewport viewport;
  std::string_view fill = "black", fill_rule = "nonzero", fill_opacity = "1", stroke = "none", visibility = "visible";
  std::string_view color = "black", marker_start = "none", marker_mid = "none", marker_end = "none";
  std::string_view context_fill = "none", context_stroke = "none";  ///< of the innermost `use`
  bool transparent = false;
  const Element* shown_by = nullptr;  ///< the innermost `use`
  int depth = 0;

  bool has_markers() const { return marker_start != "none" || marker_mid != "none" || marker_end != "none"; }
};

/// Takes over what the element declares of inherited properties, and its opacity; passes over what is no value.
void inherit(Context& context, const Element& element, const Declarations& declared, Notices& notices);

/// The element's transform, about its origin: the style's if that has one.
/// Throws      InputError for an attribute that is no transform
Affine transform_of(const Element& element, const Declarations& declared, const Viewport& viewport, Notices& notices);

/// The element with the lengths and the outline that its style declares in place of its attributes.
Element with_geometry_of_style(const Element& element, const Declarations& declared, Notices& notices);
/// Does the style declare any?
bool has_geometry(const Declarations& declared);

/// Is the element shown to a reader of English, without extensions of SVG?
bool meets_conditions(const Element& element);

/// The value that the element itself declares, or "".
inline std::string_view own(const Declarations& declared, Property property) {
  return declared[static_cast<std::size_t>(property)];
}

}  // namespace pliant::svg
