// formats/svg_import/viewport.h: viewBox, preserveAspectRatio, and the size of the page.
#pragma once
#include <optional>

#include "formats/svg_import/affine.h"
#include "formats/svg_import/shapes.h"
#include "formats/svg_import/svg_reader.h"

namespace pliant::svg {

struct ViewBox {
  double x, y, width, height;
};

/// The attribute viewBox; empty where there is none. Throws InputError.
std::optional<ViewBox> view_box_of(const Element& element);

/// The map from a viewBox to the box (0, 0, width, height) that the element's preserveAspectRatio asks for.
Affine fit_view_box(const Element& element, const ViewBox& box, double width, double height);

/// What relative lengths at the top of a drawing refer to, where the root's font has this size.
Viewport root_viewport(const Element& root, double font_size);

/// The map from the root's user units to px on its page, whose origin is the page's upper left corner. A width or
/// height that is missing, auto or a percentage follows from the other one and the viewBox; where both are, a user unit
/// is a px.
/// Throws      InputError where the page has no size: a width or height of 0 or less, or in parts of a window; a
///             viewBox without extent
Affine page_map(const Element& root, const Viewport& viewport);

/// A px in the unit.
double length_of_px(LengthUnit unit);

}  // namespace pliant::svg
