// lib/pliant/fem/measures/sample_points.cpp: locates places, those on the boundary with some tolerance.
#include "pliant/fem/measures/sample_points.h"

#include <algorithm>

#include "pliant/geometry/index.h"
#include "pliant/mesh/location/nearest_boundary.h"

namespace pliant {
namespace {

/// The distance of the ends of the edge on which a location is.
double edge_length(const Mesh& mesh, const Location& location) {
  const auto apex = static_cast<int>(std::ranges::min_element(location.xi) - location.xi.begin());
  return length(mesh.point(mesh.corner(location.triangle, (apex + 1) % 3)) -
                mesh.point(mesh.corner(location.triangle, (apex + 2) % 3)));
}

}  // namespace

std::vector<std::optional<Location>> locate_places(const Mesh& mesh, std::span<const Point> places,
                                                   OutsidePlaces rule) {
  constexpr double near_part = 0.01;
  std::vector<Point> own(places.begin(), places.end());
  for (Point& place : own) place = place / mesh.boundary().unit;
  std::vector<std::optional<Location>> found(places.size());
  Locator(mesh).find_all(own, found);
  std::optional<NearestBoundary> boundary;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (found[k]) continue;
    if (!boundary) boundary.emplace(mesh);
    const NearestPlace nearest = boundary->find(own[k]);
    if (rule == OutsidePlaces::nearest || nearest.distance <= near_part * edge_length(mesh, nearest.location))
      found[k] = nearest.location;
  }
  return found;
}

}  // namespace pliant
