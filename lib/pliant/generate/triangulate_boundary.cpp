// lib/pliant/generate/triangulate_boundary.cpp: hands points and segments to the class Delaunay.
#include "pliant/generate/triangulate_boundary.h"

#include <stdexcept>
#include <string>

#include "pliant/generate/delaunay.h"

namespace pliant {

std::vector<std::array<int, 3>> triangulate(std::span<const Point> points,
                                            std::span<const std::array<int, 2>> segments) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) throw std::invalid_argument("point " + std::to_string(i) + " is not finite");
  Delaunay delaunay(points);
  for (const auto& [a, b] : segments) delaunay.insert_segment(a, b);
  return delaunay.triangles();
}

}  // namespace pliant
