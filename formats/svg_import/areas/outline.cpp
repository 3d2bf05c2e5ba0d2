// formats/svg_import/areas/outline.cpp: the outline of a filled shape, as its commands, arcs by their centres.
#include "formats/svg_import/areas/outline.h"

#include <array>
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

Box tight_box_of(const Outline& outline, const Affine& map) {
  Outline mapped = outline;
  mapped.transform(map);
  Box box;
  Point at;
  std::size_t next = 0;
  for (const Step step : mapped.steps) {
    const Point* p = mapped.points.data() + next;
    const auto count = static_cast<std::size_t>(point_count(step));
    next += count;
    if (count == 0) continue;
    const Point end = p[count - 1];
    box.extend(end);
    if (step == Step::arc) {
      // Along x the arc is u.x cos t + v.x sin t, greatest and least at the angle of (u.x, v.x) and opposite to it.
      for (const double top : {std::atan2(p[2].x, p[1].x), std::atan2(p[2].y, p[1].y)})
        for (int half = 0; half < 2; ++half) {
          const double turn = std::remainder(top + half * std::numbers::pi - p[3].x, 2 * std::numbers::pi);
          for (const double t : {turn - 2 * std::numbers::pi, turn, turn + 2 * std::numbers::pi})
            if (t * p[3].y > 0 && std::abs(t) < std::abs(p[3].y))
              box.extend(p[0] + p[1] * std::cos(p[3].x + t) + p[2] * std::sin(p[3].x + t));
        }
    } else if (step == Step::quadratic || step == Step::cubic) {
      const bool is_cubic = step == Step::cubic;
      const std::array<Point, 4> c{at, is_cubic ? p[0] : at + (2.0 / 3) * (p[0] - at),
                                   is_cubic ? p[1] : p[1] + (2.0 / 3) * (p[0] - p[1]), end};
      const auto extend_at = [&](double t) {
        if (!(t > 0 && t < 1)) return;
        const double s = 1 - t;
        box.extend(s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3]);
      };
      for (const auto along : {&Point::x, &Point::y}) {
        const double d0 = c[1].*along - c[0].*along, d1 = c[2].*along - c[1].*along, d2 = c[3].*along - c[2].*along;
        const double discriminant = d1 * d1 - d0 * d2;  // of d0 (1-t)^2 + 2 d1 t (1-t) + d2 t^2
        if (discriminant < 0) continue;
        const double q = -(d1 + std::copysign(std::sqrt(discriminant), d1));
        extend_at(q / (q + d2));
        extend_at(d0 / (d0 + q));
      }
    }
    at = end;
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
