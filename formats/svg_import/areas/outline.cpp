// formats/svg_import/areas/outline.cpp: the outline of a filled shape, as its commands, arcs by their centres.
#include "formats/svg_import/areas/outline.h"

#include <numbers>

namespace pliant::svg {

void Outline::transform(const Affine& map) {
  std::size_t next = 0;
  for (const Step step : steps) {
    Point* p = points.data() + next;
    const auto count = static_cast<std::size_t>(point_count(step));
    next += count;
    if (step == Step::arc) {
      p[0] = map(p[0]);
      p[1] = map.turn(p[1]);
      p[2] = map.turn(p[2]);
      p[4] = map(p[4]);  // p[3] holds angles, which a map does not change
    } else {
      for (std::size_t i = 0; i < count; ++i) p[i] = map(p[i]);
    }
  }
}

Box box_of(const Outline& outline, const Affine& map) {
  Box box;
  std::size_t next = 0;
  for (const Step step : outline.steps) {
    const Point* p = outline.points.data() + next;
    const auto count = static_cast<std::size_t>(point_count(step));
    next += count;
    if (step == Step::arc) {
      constexpr int parts = 8;
      for (int i = 0; i < parts; ++i) {
        const double t = p[3].x + p[3].y * i / parts;
        box.extend(map(p[0] + p[1] * std::cos(t) + p[2] * std::sin(t)));
      }
      box.extend(map(p[4]));
    } else {
      for (std::size_t i = 0; i < count; ++i) box.extend(map(p[i]));
    }
  }
  return box;
}

void add_arc(Outline& out, const Point& from, double rx, double ry, double turned, bool large, bool sweep,
             const Point& to) {
  constexpr double pi = std::numbers::pi;
  if (from == to) return;
  rx = std::abs(rx);
  ry = std::abs(ry);
  if (rx == 0 || ry == 0) return out.line(to);
  const double phi = std::remainder(turned, 360) * (pi / 180);
  const Vector axis = std::remainder(turned, 90) == 0 ? Vector{std::round(std::cos(phi)), std::round(std::sin(phi))}
                                                      : Vector{std::cos(phi), std::sin(phi)};
  // Half of the chord where the axes are scaled to 1, so that the ellipse is the unit circle.
  const Vector half = (from - to) / 2;
  const Vector h{dot(axis, half) / rx, cross(axis, half) / ry};
  const double length_squared = squared_length(h);
  const double toward = large == sweep ? -1 : 1;
  Vector middle;  // from the chord's middle to the centre, on the unit circle
  constexpr double nearly_flat = 1e-8;
  if (!large && length_squared < nearly_flat) {
    // The centre is so far away that rounding would show; a parabola is off by less than 1e-12 of the chord.
    const Vector bulge = -toward * std::sqrt(length_squared / (1 - length_squared)) * Vector{h.y, -h.x};
    return out.quadratic((from + to) / 2 + rx * bulge.x * axis + ry * bulge.y * perpendicular(axis), to);
  }
  if (length_squared >= 1) {
    const double grow = std::sqrt(length_squared);
    rx *= grow;
    ry *= grow;
  } else {
    middle = toward * std::sqrt((1 - length_squared) / length_squared) * Vector{h.y, -h.x};
  }
  const Vector start = h - middle, end = -h - middle;  // only the angles of these vectors matter
  const Vector u = rx * axis, v = ry * perpendicular(axis);
  const Point center = (from + to) / 2 + u * middle.x + v * middle.y;
  if (!is_finite(center)) return out.line(to);  // the radius is too large for a double
  const double angle = std::atan2(start.y, start.x);
  double turn = std::atan2(cross(start, end), dot(start, end));
  if (sweep && turn < 0) turn += 2 * pi;
  if (!sweep && turn > 0) turn -= 2 * pi;
  out.arc(center, u, v, angle, turn, to);
}

}  // namespace pliant::svg
