// lib/pliant/improve/triangle_budget.h: a lower bound of the number of triangles that the goals of refinement ask for.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "pliant/improve/sizing.h"

namespace pliant {

/// The goals ask for more triangles than allowed. The text says how many, where and why, and what would ask for fewer.
class TooManyTriangles : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// The goal that asks for the most triangles, and how many that is at least.
struct LeastCount {
  double triangles = 0;
  std::string why;  ///< for example "an area of at most 1e-12 in face 'disk'"
};

/// A lower bound of the number of triangles of any mesh of these faces and curves that meets the goals: the greatest of
/// three bounds, by area (area over its bound), by size (no triangle is larger than an equilateral one with the longest
/// edge allowed) and by turning (the turning of each curve over its bound). The size function is evaluated at about
/// 100,000 places, and around each of them taken to be the largest of the values near by.
///
/// Complexity  O(triangles + places)
LeastCount least_triangles(const Mesh& mesh, const QualityGoals& goals);

/// Does nothing where that bound is at most `max_triangles`, the size function evaluated in the triangles `bad` only:
/// each other one counts as one. Without any, nothing is looked at.
///
/// Requires    `bad` has every triangle that refinement attacks
/// Throws      TooManyTriangles where it is greater
/// Complexity  where `max_triangles` is more than the mesh has, and `bad` are few: a look at each half-edge, and for a
///             size function O(bad / triangles * places)
void require_within_budget(const Mesh& mesh, const QualityGoals& goals, long max_triangles,
                           const std::vector<TriangleId>& bad);

}  // namespace pliant
