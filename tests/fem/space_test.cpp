// tests/fem/space_test.cpp: how many unknowns there are, where functions are continuous, patterns of matrices.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>

#include "pliant/fem/element_values.h"
#include "pliant/fem/sparsity.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "support/mapped_meshes.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// Entities of the n x n square with its two faces: unknowns of degree q where "middle" lets nothing, or all, jump.
int expected(int n, int q, bool jumps) {
  const int vertices = (n + 1) * (n + 1) + (jumps ? n + 1 : 0);
  const int edges = n * (n + 1) * 2 + n * n + (jumps ? n : 0);
  return vertices + (q - 1) * edges + interior_size(q) * 2 * n * n;
}

std::vector<double> random_controls(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> values(index(count));
  for (double& each : values) each = std::uniform_real_distribution(-1.0, 1.0)(random);
  return values;
}

}  // namespace

TEST_CASE("spaces have one unknown for each vertex, each inner point of edges and of elements", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4, 5);
  const Mesh mesh(mapped_square(p, 4, bend, true));
  CHECK(Space::continuous(mesh).size() == mesh.point_slots());
  CHECK(Space::continuous(mesh).size() == expected(4, p, false));
  const std::vector<char> nowhere(mesh.boundary().curves.size(), 0), everywhere(mesh.boundary().curves.size(), 1);
  for (int q = 1; q <= p; ++q) {
    CAPTURE(p, q);
    CHECK(Space::by_face(mesh, q, nowhere).size() == expected(4, q, false));
    CHECK(Space::by_face(mesh, q, everywhere).size() == expected(4, q, true));
  }
}

TEST_CASE("a function of lower degree is continuous within faces, and comes back from its elevation",
          "[fem][property]") {
  const int p = GENERATE(2, 3, 4, 5);
  const int q = GENERATE_REF(p - 1, 1);
  CAPTURE(p, q);
  Mesh mesh(mapped_square(p, 4, bend, true));
  const std::vector<char> everywhere(mesh.boundary().curves.size(), 1);
  const Space space = Space::by_face(mesh, q, everywhere);
  const std::vector<double> unknowns = random_controls(space.size(), 7);
  const std::vector<double> values = elevated_values(space, unknowns, p);
  const std::vector<double> back = restricted_unknowns(space, values, p);
  for (std::size_t i = 0; i < back.size(); ++i) CHECK(back[i] == Approx(unknowns[i]).margin(1e-12));
  // The elevated values are a field by face: one value for each place.
  std::map<std::pair<PointId, FaceId>, double> places;
  bool jumps = false;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int k = 0; k < mesh.net_size(); ++k) {
      const double value = values[index(t * mesh.net_size() + k)];
      const auto [at, is_new] = places.emplace(std::pair(mesh.net(t)[index(k)], mesh.face(t)), value);
      CHECK(at->second == Approx(value).margin(1e-13));
      const auto other = places.find({mesh.net(t)[index(k)], 1 - mesh.face(t)});
      if (other != places.end() && std::abs(other->second - value) > 1e-3) jumps = true;
    }
  CHECK(jumps);
}

TEST_CASE("fields become unknowns and unknowns fields, by face too", "[fem]") {
  const int p = GENERATE(1, 2, 3);
  const bool by_face = GENERATE(false, true);
  Mesh mesh(mapped_square(p, 4, bend, true));
  Field field;
  field.name = "c";
  field.by_face = by_face;
  if (by_face) field.places = field_places(mesh);
  field.values.assign(by_face ? field.places.size() : index(mesh.point_slots()), 0.0);
  mesh.set_field(field);
  const std::vector<char> everywhere(mesh.boundary().curves.size(), 1);
  const Space space = by_face ? Space::by_face(mesh, p, everywhere) : Space::continuous(mesh);
  const std::vector<double> unknowns = random_controls(space.size(), 3);
  mesh.set_field(with_unknowns(mesh, 0, space, unknowns));
  CHECK(unknowns_of(space, element_values(mesh, 0, 0)) == unknowns);
  CHECK(element_values(mesh, 0, 0) == element_values(space, unknowns));
}

TEST_CASE("the pattern joins just the unknowns of common groups, and places point at their entries", "[fem][oracle]") {
  std::mt19937_64 random(11);
  const int unknowns = 40;
  std::vector<int> triples, pairs;
  for (int i = 0; i < unknowns; ++i) triples.push_back(i);
  while (triples.size() % 3 != 0) triples.push_back(0);
  const auto draw = [&] { return static_cast<int>(random() % unknowns); };
  for (int k = 0; k < 60; ++k)
    for (int m = 0; m < 3; ++m) triples.push_back(draw());
  for (int k = 0; k < 20; ++k) pairs.insert(pairs.end(), {draw(), draw()});
  const Groups kinds[] = {{3, triples}, {2, pairs}};
  const Sparsity sparsity = make_sparsity(unknowns, kinds);
  std::set<std::pair<int, int>> wanted;
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const int size = kinds[kind].size;
    for (int g = 0; g < kinds[kind].count(); ++g)
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
          const int row = kinds[kind].members[index(g * size + i)], column = kinds[kind].members[index(g * size + j)];
          wanted.emplace(row, column);
          CHECK(sparsity.places[kind][index((g * size + i) * size + j)] == sparsity.pattern->find(row, column));
        }
  }
  std::set<std::pair<int, int>> found;
  for (int i = 0; i < unknowns; ++i)
    for (int k = sparsity.pattern->starts[index(i)]; k < sparsity.pattern->starts[index(i) + 1]; ++k) {
      found.emplace(i, sparsity.pattern->columns[index(k)]);
      if (k > sparsity.pattern->starts[index(i)])
        CHECK(sparsity.pattern->columns[index(k)] > sparsity.pattern->columns[index(k - 1)]);
    }
  CHECK(found == wanted);
}
