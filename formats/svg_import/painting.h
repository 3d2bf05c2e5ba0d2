// formats/svg_import/painting.h: whether paints show, and how outlines are stroked.
#pragma once
#include "formats/svg_import/areas/stroke.h"
#include "formats/svg_import/context.h"

namespace pliant::svg {

/// Does the paint show? A reference to a missing element does not, unless a colour follows it.
bool paints(std::string_view paint, const Element& element, const Context& context, const ElementTree& tree,
            Notices& notices);

/// The width of an element's stroke in its own units; 1 where it is no length.
double stroke_width(const Element& element, const Context& context, Notices& notices);

/// Is that above zero? What is odd about it is said where the stroke is read.
bool has_stroke_width(const Element& element, const Context& context);

/// How the element's outline is stroked.
StrokeStyle stroke_style(const Element& element, const Declarations& declared, const Context& context,
                         Notices& notices);

/// Throws an InputError where a coordinate is greater than max_coordinate.
void check_coordinates(const Element& element, const Outline& outline);

}  // namespace pliant::svg
