// lib/pliant/geometry/spline/restore_area.cpp: a closed curve offset until it encloses the area wanted.
#include "pliant/geometry/spline/restore_area.h"

#include <cmath>
#include <utility>
#include <vector>

namespace pliant {

double restore_area(BSpline& spline, double area) {
  // Control points move linearly with the offset, so that the area is a quadratic polynomial of the offset. Its
  // coefficients follow from three areas, and Newton's steps converge to rounding.
  Box box;
  for (const Point& p : spline.points()) box.extend(p);
  if (!(box.size() > 0)) return 0;
  // Offsets are counted in a unit of the curve's size, so that the scale of the mesh does not matter.
  const double unit = std::ldexp(1.0, std::ilogb(box.size()));
  std::vector<Vector> normals;
  for (const double g : spline.greville()) {
    const Vector along = spline.derivative(g);
    const double speed = length(along);
    if (!(speed > 0)) return 0;
    normals.push_back(-(unit / speed) * perpendicular(along));
  }
  BSpline direction = spline;
  if (!direction.interpolate(normals)) return 0;
  const BSpline before = spline;
  BSpline sum = spline;
  sum.add(direction, 1);
  const double second = direction.area();
  const double first = sum.area() - spline.area() - second;
  double offset = 0;
  double miss = area - spline.area();
  for (int step = 0; step < 6; ++step) {
    const double slope = first + 2 * second * offset;
    // With a slope this small the quadratic term may undo the step: the curve encloses next to nothing, and no offset
    // would help.
    if (!(std::abs(slope) > 4 * std::abs(second) * (std::abs(miss) / std::abs(slope)))) break;
    const double next = offset + miss / slope;
    BSpline trial = before;
    trial.add(direction, next);
    const double next_miss = area - trial.area();
    if (!(std::abs(next_miss) < std::abs(miss))) break;
    offset = next;
    miss = next_miss;
    spline = std::move(trial);
  }
  return offset * unit;
}

}  // namespace pliant
