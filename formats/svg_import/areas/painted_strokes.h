// formats/svg_import/areas/painted_strokes.h: how far shapes reach, and the areas that strokes of a scene paint.
#pragma once
#include "formats/svg_import/scene.h"

namespace pliant::svg {

/// The box of the shape's control points; that of a stroke as if all joins were round, without sharp corners.
Box box_of(const Shape& shape, const Affine& map = {});

/// Replaces the strokes of a scene by the outlines of what they paint.
/// Returns     the tolerance that is left for fitting, as a length
/// Throws      InputError for coordinates beyond max_coordinate, and outlines of more than max_steps in all
double paint_strokes(Scene& scene, double tolerance);

}  // namespace pliant::svg
