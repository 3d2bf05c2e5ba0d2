// lib/pliant/improve/triangle_budget.h: how many triangles the goals of refinement ask for at least.
#pragma once
#include <stdexcept>
#include <string>

#include "pliant/improve/sizing.h"

namespace pliant {

/// More triangles than allowed: the text says how many, where and why, and what would ask for fewer.
class TooManyTriangles : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// The goals that ask for most triangles, and how many they ask for at least.
struct LeastCount {
  double triangles = 0;
  std::string why;  ///< "an area of at most 1e-12 in face 'disk'"
};

/// A lower bound of the number of triangles of any mesh of these faces and curves that meets the goals: by area (area
/// over bound), by size (no triangle exceeds an equilateral one of the longest edge allowed) and by turning (turning of
/// each curve over bound). Of the size function it sees some 100,000 places, and takes it to be the largest of the
/// values around each.   Complexity  O(mesh) and the places looked at
LeastCount least_triangles(const Mesh& mesh, const QualityGoals& goals);

/// Throws      TooManyTriangles where that is more than `max_triangles`
void require_within_budget(const Mesh& mesh, const QualityGoals& goals, long max_triangles);

}  // namespace pliant
