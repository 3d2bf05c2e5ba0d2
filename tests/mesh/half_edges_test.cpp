// tests/mesh/half_edges_test.cpp: both ways to pair half-edges agree, and meshes that are not sound are found.
#include "pliant/mesh/half_edges.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "pliant/mesh/check_mesh.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

bool has_topological_faults(const MeshData& data) {
  const std::vector<Fault> faults = check_structure(data, HalfEdges::by_vertices(data), 1000);
  return std::ranges::any_of(faults, [](const Fault& f) { return f.invariant == "M1" || f.invariant == "M2"; });
}

/// Spoils a document in one of several ways, at random: a triangle names another point, is dropped, repeated or turned
/// over, or two vertices become one.
void spoil(MeshData& data, std::mt19937& random) {
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  const auto below = [&random](std::size_t bound) { return random() % bound; };
  const std::size_t t = below(data.triangle_faces.size());
  const auto net = data.triangles.begin() + static_cast<std::ptrdiff_t>(t * n);
  switch (below(6)) {
    case 0:
      net[static_cast<std::ptrdiff_t>(below(n))] = static_cast<PointId>(below(data.points.size()));
      break;
    case 1:
      data.triangles.erase(net, net + static_cast<std::ptrdiff_t>(n));
      data.triangle_faces.erase(data.triangle_faces.begin() + static_cast<std::ptrdiff_t>(t));
      break;
    case 2: {
      const std::vector<PointId> copy(net, net + static_cast<std::ptrdiff_t>(n));
      data.triangles.insert(data.triangles.end(), copy.begin(), copy.end());
      data.triangle_faces.push_back(data.triangle_faces[t]);
      break;
    }
    case 3:
      std::swap(net[0], net[1]);
      break;
    case 4: {  // two vertices become one: pinched stars, or edges with the same ends
      const PointId from = net[0], to = data.triangles[below(data.triangle_faces.size()) * n + 1];
      std::ranges::replace(data.triangles, from, to);
      data.points[static_cast<std::size_t>(from)] = {0, 0};
      for (PointId& p : data.triangles) p -= p > from ? 1 : 0;
      data.points.erase(data.points.begin() + from);
      break;
    }
    default:
      data.points.push_back({1, 2});
      break;
  }
}

}  // namespace

TEST_CASE("half-edges are paired alike by inner points and by vertices", "[mesh]") {
  const int degree = GENERATE(2, 3, 5);
  CAPTURE(degree);
  const MeshData data = samples::three_disks(degree);
  const HalfEdges fast(data), slow = HalfEdges::by_vertices(data);
  CHECK(fast.is_sound());
  CHECK_FALSE(slow.is_sound());
  for (const HalfEdgeId h : data.half_edges()) {
    CHECK(fast.twin(h) == slow.twin(h));
    CHECK(fast.is_border(h) == slow.is_border(h));
  }
  for (const ConstrainedEdge& edge : data.constrained_edges) CHECK(fast.along(edge.points) == slow.along(edge.points));
}

TEST_CASE("what pairing calls sound has no fault of M1 or M2", "[mesh][property]") {
  const int degree = GENERATE(2, 3, 4);
  int sound = 0, broken = 0;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    CAPTURE(degree, seed);
    std::mt19937 random(seed);
    MeshData data = samples::three_disks(degree);
    data.constrained_edges.clear();
    for (unsigned k = 0; k < seed % 3; ++k) spoil(data, random);
    REQUIRE(check_arrays(data).empty());
    const bool has_faults = has_topological_faults(data);
    if (HalfEdges(data).is_sound()) {
      REQUIRE_FALSE(has_faults);
      ++sound;
    }
    broken += has_faults ? 1 : 0;
  }
  CHECK(sound >= 500);
  CHECK(broken > 500);
}

TEST_CASE("two edges with the same ends are no sound mesh", "[mesh]") {
  // A lens of two edges between two vertices, each with a triangle on the outer side.
  MeshData data;
  data.degree = 2;
  data.boundary.faces.push_back({"all", {}});
  data.points = {{0, 0}, {2, 0}, {1, 2}, {1, -2}, {1, 0.5}, {1.5, 1}, {0.5, 1}, {1, -0.5}, {0.5, -1}, {1.5, -1}};
  data.triangles = {0, 1, 2, 4, 5, 6, 1, 0, 3, 7, 8, 9};
  data.triangle_faces = {0, 0};
  CHECK_FALSE(HalfEdges(data).is_sound());
  CHECK(has_topological_faults(data));
}
