// tests/ops/flip_thirds_test.cpp: flipped elements of a fine curved mesh keep small third derivatives, and their order.
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/mesh/mesh.h"
#include "pliant/ops/flip_edge.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// The longest third difference of a net along two of the sides.
double longest_third(int degree, std::span<const Point> net) {
  const NetLayout& layout = NetLayout::of(degree);
  double longest = 0;
  for (int i = 3; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      const auto at = [&](int b, int c) { return net[index(layout.index(i - b - c, j + b))]; };
      for (const auto& third :
           {at(3, 0) - 3 * at(2, 0) + 3 * at(1, 0) - at(0, 0), at(0, 3) - 3 * at(0, 2) + 3 * at(0, 1) - at(0, 0),
            (at(2, 1) - 2 * at(1, 1) + at(0, 1)) - (at(2, 0) - 2 * at(1, 0) + at(0, 0)),
            (at(1, 2) - 2 * at(1, 1) + at(1, 0)) - (at(0, 2) - 2 * at(0, 1) + at(0, 0))})
        longest = std::max(longest, length(third));
    }
  return longest;
}

/// The same over all elements, once the diagonals of all cells have been flipped, and flipped back every second one.
double longest_after_flips(int degree, int n) {
  Mesh mesh(mapped_square(degree, n, bend));
  int flips = 0;
  for (int round = 0; round < 2; ++round)
    for (int cell = round; cell < n * n; cell += 1 + round) {
      const TriangleId t = 2 * cell;  // as long as slots are used again, both triangles of a cell keep them
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(t, e);
        if (mesh.twin(h) == none || triangle_of(mesh.twin(h)) / 2 != cell) continue;
        if (flip_edge(mesh, h) == Outcome::done) ++flips;
        break;
      }
    }
  REQUIRE(flips > n * n);
  std::vector<Point> net(index(mesh.net_size()));
  double longest = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    longest = std::max(longest, longest_third(degree, net));
  }
  return longest;
}

}  // namespace

TEST_CASE("third derivatives of flipped elements fall with the third power of their size", "[ops][order]") {
  const int degree = GENERATE(3, 4, 5);
  CAPTURE(degree);
  const double coarse = longest_after_flips(degree, 12), fine = longest_after_flips(degree, 24);
  CAPTURE(coarse, fine);
  CHECK(std::log2(coarse / fine) > 2.7);
}
