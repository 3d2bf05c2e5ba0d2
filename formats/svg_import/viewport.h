// formats/svg_import/viewport.h: viewBox and preserveAspectRatio.
#pragma once
#include <optional>

#include "formats/svg_import/affine.h"
#include "formats/svg_import/shapes.h"

namespace pliant::svg {

struct ViewBox {
  double x, y, width, height;
};

/// The attribute viewBox; empty where there is none. Throws InputError.
std::optional<ViewBox> view_box_of(const Element& element);

/// From a viewBox to the box (0, 0, width, height), as the element's preserveAspectRatio says.
Affine fit_view_box(const Element& element, const ViewBox& box, double width, double height);

/// What percentages and units at the top of a drawing refer to, whose font has that size.
Viewport root_viewport(const Element& root, double font_size);

}  // namespace pliant::svg
