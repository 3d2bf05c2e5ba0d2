// tests/geometry/allocation_test.cpp: placement and small solves allocate nothing once scratch memory has grown.
#include <catch2/catch.hpp>
#include <vector>

#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "support/counted_malloc.h"
#include "support/placement_stars.h"

#ifdef PLIANT_COUNTS_MALLOC

using namespace pliant;

TEST_CASE("placement allocates nothing in the steady state", "[geometry]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  std::vector<samples::PlacementStar> stars;
  std::mt19937_64 random(4);
  for (int k = 0; k < 40; ++k)
    stars.push_back(
        random_star(degree, degree == 1 ? samples::StarKind::vertex : samples::StarKind::edge, 0.6, random));
  std::vector<std::vector<PlacementElement>> elements;
  for (const auto& star : stars) elements.push_back(star.elements());
  long allocated = 0;
  for (int round = 0; round < 2; ++round) {
    const long before = allocations;
    for (std::size_t k = 0; k < stars.size(); ++k)
      for (const auto measure : {PlacementMeasure::element, PlacementMeasure::control_mesh}) {
        untangle_point(degree, elements[k], stars[k].place(), measure);
        improve_point(degree, elements[k], stars[k].place(), measure);
      }
    allocated = allocations - before;
  }
  CHECK(allocated == 0);
}

TEST_CASE("systems of up to 96 unknowns are solved without allocation", "[geometry]") {
  const int n = GENERATE(1, 5, 8, 9, 17, 82, 96);
  CAPTURE(n);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  std::vector<double> matrix(index(n * n)), right(index(2 * n));
  for (double& value : matrix) value = entry(random);
  for (double& value : right) value = entry(random);
  const long before = allocations;
  solve_dense(n, matrix, 2, right);
  CHECK(allocations == before);
}

#endif
