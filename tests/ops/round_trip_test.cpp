// tests/ops/round_trip_test.cpp: the removal of a vertex undoes its insertion, or the split that made it, to rounding.
#include "ops/carried_domains.h"
#include "pliant/geometry/index.h"

using namespace pliant;

namespace {

/// The rows of the triangle of h in an order that starts at the origin of h, so that the first corner of the triangle
/// does not matter.
std::vector<double> rows_from(const Mesh& mesh, HalfEdgeId h) {
  const int p = mesh.degree(), width = mesh.width();
  const NetLayout& layout = mesh.layout();
  std::vector<double> rows(index(mesh.net_size() * width)), out;
  mesh.gather(triangle_of(h), rows);
  const std::size_t e = index(edge_of(h));
  for (int i = 0; i <= p; ++i)
    for (int j = 0; i + j <= p; ++j) {
      std::array<int, 3> exponents{};
      exponents[e] = i, exponents[(e + 1) % 3] = j, exponents[(e + 2) % 3] = p - i - j;
      const int k = layout.index(exponents[0], exponents[1]);
      out.insert(out.end(), rows.begin() + k * width, rows.begin() + (k + 1) * width);
    }
  return out;
}

/// The largest difference between the rows of two elements. Positions are relative to the size of the mesh, values to
/// 3, about the largest value.
double difference(const Mesh& mesh, const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    worst = std::max(worst, std::abs(a[k] - b[k]) / (k % index(mesh.width()) < 2 ? mesh.size() : 3));
  return worst;
}

/// What was before: the triangles beside an edge that is split, or the triangle into which a point is inserted.
struct Before {
  std::array<PointId, 2> from{none, none}, to{none, none};
  std::array<std::vector<double>, 2> rows;

  void note(const Mesh& mesh, int side, HalfEdgeId h) {
    if (h == none) return;
    from[index(side)] = mesh.origin(h);
    to[index(side)] = mesh.target(h);
    rows[index(side)] = rows_from(mesh, h);
  }
  double change(const Mesh& mesh) const {
    double worst = 0;
    for (std::size_t k = 0; k < 2; ++k)
      if (from[k] != none)
        worst = std::max(worst, difference(mesh, rows[k], rows_from(mesh, find_half_edge(mesh, from[k], to[k]))));
    return worst;
  }
};

}  // namespace

TEST_CASE("an insertion or a split, then the removal of its vertex, give back geometry and fields to rounding",
          "[ops][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  CAPTURE(degree, domain.name);
  Mesh mesh = carried(domain, degree, 5);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Mesh original = mesh;
  std::array<double, 4> worst{};  // by kind: insertion, inner edge, interface, outer boundary
  std::array<int, 4> trips{};
  for (int k = 0; k < 400; ++k) {
    CAPTURE(k);
    const auto t = static_cast<TriangleId>(random() % index(mesh.triangle_slots()));
    if (!mesh.is_alive(t)) continue;
    HalfEdgeId h = half_edge(t, static_cast<int>(random() % 3));
    Before before;
    InsertResult inserted;
    int kind = 0;
    if (random() % 3 == 0) {
      Barycentric xi{0.1 + uniform(random), 0.1 + uniform(random), 0.1 + uniform(random)};
      const double sum = xi[0] + xi[1] + xi[2];
      for (double& x : xi) x /= sum;
      before.note(mesh, 0, h);
      inserted = insert_point(mesh, t, xi);
      REQUIRE(inserted.outcome == Outcome::done);
      REQUIRE(remove_inner_vertex(mesh, inserted.vertex) == Outcome::done);
    } else {
      for (int e = 0; e < 3 && random() % 2; ++e)
        if (mesh.is_constrained(half_edge(t, e))) h = half_edge(t, e);
      before.note(mesh, 0, next(h));
      if (mesh.twin(h) != none) before.note(mesh, 1, next(mesh.twin(h)));
      kind = !mesh.is_constrained(h) ? 1 : mesh.twin(h) != none ? 2 : 3;
      inserted = split_edge(mesh, h, 0.1 + 0.8 * uniform(random));
      REQUIRE(inserted.outcome == Outcome::done);
      const Outcome outcome = kind == 1 ? remove_inner_vertex(mesh, inserted.vertex)
                                        : remove_curve_vertex(mesh, inserted.vertex, {1e-10}).outcome;
      REQUIRE(outcome == Outcome::done);
    }
    ++trips[index(kind)];
    worst[index(kind)] = std::max(worst[index(kind)], before.change(mesh));
  }
  require_every_invariant(mesh);
  CHECK(mesh.triangle_count() == original.triangle_count());
  double drift = 0;
  for (TriangleId t = 0; t < original.triangle_slots(); ++t) {
    const HalfEdgeId h = half_edge(t, 0);
    const HalfEdgeId now = find_half_edge(mesh, original.origin(h), original.target(h));
    REQUIRE(now != none);
    drift = std::max(drift, difference(mesh, rows_from(original, h), rows_from(mesh, now)));
  }
  CAPTURE(trips, worst, drift, linear_error(mesh));
  for (const double each : worst) CHECK(each < 1e-13);
  CHECK(drift < 1e-12);
  CHECK(linear_error(mesh) < 1e-13 * mesh.size());
}
