// tests/ops/long_sequences_test.cpp: very many random operations in a row, on several domains, for several degrees.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "ops/carried_domains.h"

using namespace pliant;

namespace {

/// How many operations are made: 10^5 in the long run of `tests/run --all`, fewer otherwise. At degree 3 it is a fifth
/// of that, at higher degrees a twentieth, since a refused flip takes milliseconds of search there.
int operation_count(int degree) {
  const char* const text = std::getenv("PLIANT_OPERATIONS");
  return (text ? std::atoi(text) : 2000) / (degree > 3 ? 20 : degree == 3 ? 5 : 1);
}

long euler(const Mesh& mesh) {
  long vertices = 0, edges = 0, triangles = 0;
  for (PointId p = 0; p < mesh.point_slots(); ++p) vertices += mesh.is_point_alive(p) && mesh.is_vertex(p);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    ++triangles;
    for (int e = 0; e < 3; ++e) edges += mesh.twin(half_edge(t, e)) < half_edge(t, e);
  }
  return vertices - edges + triangles;
}

}  // namespace

TEST_CASE("any number of operations that keep the curves keeps areas, linear functions, integrals and all invariants",
          "[ops][property][long]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  CAPTURE(degree, domain.name);
  Mesh mesh = carried(domain, degree);
  const std::vector<double> before = kept_sums(mesh);
  const double scale = box_area(mesh);
  const long characteristic = euler(mesh);
  RandomOperations operations(mesh, 17, 2 * mesh.triangle_count());
  const int count = operation_count(degree), blocks = 20;
  for (int block = 1; block <= blocks; ++block) {
    operations.run(count / blocks);
    require_every_invariant(mesh);
    REQUIRE(euler(mesh) == characteristic);
    const std::vector<double> after = kept_sums(mesh);
    double worst = 0;
    for (std::size_t k = 0; k < after.size(); ++k) worst = std::max(worst, std::abs(after[k] - before[k]));
    CHECK(worst < 1e-10 * scale);
    CHECK(linear_error(mesh) < 1e-12 * std::max(1.0, mesh.size()));
  }
  CHECK(operations.done > count / 20);
}

TEST_CASE("the largest value of a noisy field does not grow over any number of flips", "[ops][property][long]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  CAPTURE(degree, domain.name);
  Mesh mesh = carried(domain, degree);
  for (TriangleId t = 0, n = mesh.triangle_slots(); t < n; ++t) insert_point(mesh, t, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  const auto largest = [&](std::size_t field) {
    double most = 0;
    for (PointId p = 0; p < mesh.point_slots(); ++p)
      if (mesh.is_point_alive(p))
        for (std::size_t c = 0; c < 2; ++c)
          most = std::max(most, std::abs(mesh.fields()[field].values[2 * static_cast<std::size_t>(p) + c]));
    return most;
  };
  const double before = largest(1);
  const std::vector<double> sums = kept_sums(mesh);
  std::mt19937_64 random(11);
  long flips = 0;
  double most = 0;
  const int count = operation_count(degree);
  for (int k = 0; k < count; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    if (flip_edge(mesh, h) != Outcome::done) continue;
    ++flips;
    most = std::max(most, largest(1));  // checked after every flip, since later flips may average a large value away
  }
  CHECK(flips > count / 20);
  CHECK(most <= before * (1 + 1e-12));
  const std::vector<double> after = kept_sums(mesh);
  for (std::size_t k = 0; k < after.size(); ++k) CHECK(after[k] == Approx(sums[k]).margin(1e-10 * box_area(mesh)));
}
