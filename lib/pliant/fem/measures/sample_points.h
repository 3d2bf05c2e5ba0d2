// lib/pliant/fem/measures/sample_points.h: in which elements places lie where fields are read.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "pliant/mesh/locate.h"

namespace pliant {

/// What becomes of places outside the mesh.
enum class OutsidePlaces {
  empty,   ///< they have no location, but for those so near to the boundary that they are meant to be on it
  nearest  ///< they have that of the nearest point of the boundary
};

/// The location of each place. One that is outside the mesh by no more than a hundredth of the nearest boundary edge
/// counts as the boundary's nearest point: curves are seldom exactly what they stand for.
///
/// Requires    a mesh with triangles; finite places in the document's units
/// Complexity  as Locator::find_all, and O(outer edges) for each place outside
std::vector<std::optional<Location>> locate_places(const Mesh& mesh, std::span<const Point> places, OutsidePlaces rule);

}  // namespace pliant
