// lib/pliant/geometry/linear_triangle.h: straight triangles: area, circumcentre, shape (paper §5.5).
#pragma once
#include "pliant/geometry/point.h"

namespace pliant {

/// Signed area, counter-clockwise positive.
double triangle_area(const Point& a, const Point& b, const Point& c);
/// Centre of the circumcircle; not finite for a flat triangle.
Point circumcenter(const Point& a, const Point& b, const Point& c);
/// tau = 4 sqrt(3) A / (l1^2 + l2^2 + l3^2) (paper §5.5): 1 for an equilateral triangle, 0 for a flat one, negative for
/// one that is turned over.
double triangle_shape(const Point& a, const Point& b, const Point& c);
/// The least angle in radians (0 for a flat triangle).
double least_angle(const Point& a, const Point& b, const Point& c);
/// Circumradius over the shortest edge; infinite for a flat triangle.
double radius_edge_ratio(const Point& a, const Point& b, const Point& c);
/// Barycentric coordinates of p in the straight triangle a, b, c.
Barycentric barycentric(const Point& a, const Point& b, const Point& c, const Point& p);

}  // namespace pliant
