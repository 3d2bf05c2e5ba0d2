// formats/svg_import/areas/painted_strokes.h: the strokes of a scene become the areas that they paint.
#pragma once
#include "formats/svg_import/scene.h"

namespace pliant::svg {

/// Replaces the strokes of a scene by the outlines of what they paint.
/// Returns     the tolerance that is left for fitting, as a length
/// Throws      InputError for coordinates beyond max_coordinate, and outlines of more than max_steps in all
double paint_strokes(Scene& scene, double tolerance);

}  // namespace pliant::svg
