// tests/ops/long_sequences_test.cpp: very many random operations in a row, on several domains, at every degree
#include <catch2/catch.hpp>
#include <cstdlib>

#include "ops/random_operations.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_boundaries.h"

using namespace pliant;

namespace {

/// How many operations: 10^5 in the long run of `tests/run --all`, fewer otherwise. At degree 3 a fifth of them and
/// above a twentieth: there a refused flip takes milliseconds of search.
int operation_count(int degree) {
  const char* const text = std::getenv("PLIANT_OPERATIONS");
  return (text ? std::atoi(text) : 2000) / (degree > 3 ? 20 : degree == 3 ? 5 : 1);
}

struct Domain {
  const char* name;
  BoundaryComplex (*boundary)(int degree);
};
const Domain domains[] = {{"cell", samples::one_cell},
                          {"annulus, a hole", [](int degree) { return samples::annulus(degree); }},
                          {"cells in a channel, interfaces", samples::interface},
                          {"gear, corners", [](int) { return samples::gear(6); }}};

/// Field 0 linear, field 1 noise of two components, field 2 noise by face.
Mesh carried(const Domain& domain, int degree) {
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(domain.boundary(degree), {degree}, mesh);
  if (!outcome.ok) FAIL(outcome.failure);
  MeshData data = mesh.to_data();
  samples::add_field(data, "linear", 1, [](const Point& p) { return std::vector<double>{p.x + 2 * p.y - 3}; });
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> noise(-1, 1);
  samples::add_field(data, "noise", 2, [&](const Point&) { return std::vector<double>{noise(random), noise(random)}; });
  Field field;
  field.name = "by face";
  field.by_face = true;
  const auto n = static_cast<std::size_t>(net_size(degree));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    field.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::sort(field.places.begin(), field.places.end());
  field.places.erase(std::unique(field.places.begin(), field.places.end()), field.places.end());
  for (std::size_t k = 0; k < field.places.size(); ++k) field.values.push_back(noise(random));
  data.fields.push_back(std::move(field));
  return Mesh(std::move(data));
}

/// Area of each face, then the integral of each component of the fields 1 and 2.
std::vector<double> kept(const Mesh& mesh) {
  std::vector<double> sums(mesh.boundary().faces.size() + 3);
  const std::size_t faces = mesh.boundary().faces.size();
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  std::vector<double> weights(net.size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    sums[static_cast<std::size_t>(mesh.face(t))] += element_area(mesh.degree(), net);
    integral_weights(mesh.degree(), net, weights);
    for (std::size_t k = 0; k < net.size(); ++k) {
      const auto value = [&](int field, int c) {
        return mesh.fields()[static_cast<std::size_t>(field)]
            .values[static_cast<std::size_t>(mesh.value_index(field, mesh.net(t)[k], mesh.face(t)) + c)];
      };
      sums[faces] += weights[k] * value(1, 0);
      sums[faces + 1] += weights[k] * value(1, 1);
      sums[faces + 2] += weights[k] * value(2, 0);
    }
  }
  return sums;
}

double box_area(const Mesh& mesh) {
  const Box box = mesh.box();
  return (box.high.x - box.low.x) * (box.high.y - box.low.y);
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

TEST_CASE(
    "any number of operations that keep the curves keeps areas, linear functions, integrals and the checker happy",
    "[ops][property][long]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  CAPTURE(degree, domain.name);
  Mesh mesh = carried(domain, degree);
  const std::vector<double> before = kept(mesh);
  const double scale = box_area(mesh);
  const long characteristic = euler(mesh);
  RandomOperations operations(mesh, 17, 2 * mesh.triangle_count());
  const int count = operation_count(degree), blocks = 20;
  for (int block = 1; block <= blocks; ++block) {
    operations.run(count / blocks);
    for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
    REQUIRE(find_invalid(mesh).empty());
    REQUIRE(euler(mesh) == characteristic);
    const std::vector<double> after = kept(mesh);
    double worst = 0;
    for (std::size_t k = 0; k < after.size(); ++k) worst = std::max(worst, std::abs(after[k] - before[k]));
    CHECK(worst < 1e-10 * scale);
    // At degree 5 parents are extrapolated from their pieces, which costs digits: 7e-12 after 5,000 operations.
    CHECK(linear_error(mesh) < (degree < 5 ? 1e-12 : 1e-10) * std::max(1.0, mesh.size()));
  }
  CHECK(operations.done > count / 20);
}

TEST_CASE("the largest value of a noisy field does not grow over any number of flips", "[ops][property][long]") {
  const int degree = GENERATE(1, 2, 3);
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
  const std::vector<double> sums = kept(mesh);
  std::mt19937_64 random(11);
  long flips = 0;
  const int count = operation_count(degree);
  for (int k = 0; k < count; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    flips += flip_edge(mesh, h) == Refusal::done;
  }
  CHECK(flips > count / 20);
  CHECK(largest(1) <= before * (1 + 1e-12));
  const std::vector<double> after = kept(mesh);
  for (std::size_t k = 0; k < after.size(); ++k) CHECK(after[k] == Approx(sums[k]).margin(1e-10 * box_area(mesh)));
}
