// formats/svg_import/areas/painted_strokes.cpp: how far shapes reach, and the areas that strokes of a scene paint.
#include "formats/svg_import/areas/painted_strokes.h"

#include "pliant/boundary/fault.h"

namespace pliant::svg {

Box box_of(const Shape& shape, const Affine& map) {
  if (!shape.stroke) return box_of(shape.outline, map);
  const Affine all = map * shape.map;
  Box box = box_of(shape.outline, all);
  if (!(box.low.x <= box.high.x)) return box;
  const double half = shape.stroke->width / 2;
  const Vector reach{half * std::hypot(all.a, all.c), half * std::hypot(all.b, all.d)};
  box.low -= reach;
  box.high += reach;
  return box;
}

double paint_strokes(Scene& scene, double tolerance) {
  constexpr double for_strokes = 0.25;  // a part of the tolerance
  bool is_any = false;
  std::size_t steps = 0;
  for (Shape& shape : scene.shapes) {
    if (!shape.stroke) continue;
    is_any = true;
    const Affine& m = shape.map;
    const double stretch = std::hypot(std::hypot(m.a, m.b), std::hypot(m.c, m.d));  // at least the greatest one
    if (stretch == 0 || m.determinant() == 0) {
      shape.outline = {};
      continue;
    }
    try {
      shape.outline = stroke_area(shape.outline, *shape.stroke, for_strokes * tolerance / stretch);
    } catch (const InputError& e) {
      throw InputError("", "'" + shape.name + "' (line " + std::to_string(shape.line) + "): " + e.what());
    }
    steps += shape.outline.steps.size();
    if (steps > max_steps)
      throw InputError("", "the outlines of strokes need more than " + std::to_string(max_steps) +
                               " segments; a greater --tolerance, or fewer dashes, takes fewer");
    shape.outline.transform(m);
    for (const Point& p : shape.outline.points)
      if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate))
        throw InputError("", "'" + shape.name + "' (line " + std::to_string(shape.line) +
                                 "): the outline of its stroke is beyond 1e60");
  }
  return is_any ? (1 - for_strokes) * tolerance : tolerance;
}

}  // namespace pliant::svg
