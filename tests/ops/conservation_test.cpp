// tests/ops/conservation_test.cpp: each operation by itself keeps areas of faces, integrals and linear functions.
#include "ops/carried_domains.h"
#include "pliant/ops/level_jacobian.h"

using namespace pliant;

namespace {

constexpr std::array names{"insert", "split", "flip", "remove", "remove on a curve", "smooth", "straighten", "level"};

/// An operation of this kind, which keeps the curves, at a random place.
Outcome operate(Mesh& mesh, std::size_t kind, std::mt19937_64& random, const RefitOptions& options) {
  TriangleId t;
  do t = static_cast<TriangleId>(random() % static_cast<unsigned>(mesh.triangle_slots()));
  while (!mesh.is_alive(t));
  const HalfEdgeId h = half_edge(t, static_cast<int>(random() % 3));
  switch (kind) {
    case 0:
      return insert_point(mesh, t, {0.25, 0.4, 0.35}).outcome;
    case 1:
      return split_edge(mesh, h, 0.4).outcome;
    case 2:
      return flip_edge(mesh, h, options);
    case 3:
      return remove_inner_vertex(mesh, mesh.origin(h), options);
    case 4: {
      // A split is not just undone: edges around the new vertex are flipped first, so that its removal fits fields.
      const HalfEdgeId on = mesh.is_constrained(h) ? h : mesh.is_constrained(next(h)) ? next(h) : none;
      if (on == none) return Outcome::corner;
      const InsertResult inserted = split_edge(mesh, on, 0.5);
      if (inserted.outcome != Outcome::done) return inserted.outcome;
      flip_edge(mesh, next(on), options);
      return remove_curve_vertex(mesh, inserted.vertex, {1e-12 * mesh.size()}, options).outcome;
    }
    case 5:
      return smooth_edge(mesh, h, random() % 2 ? SmoothGoal::improve : SmoothGoal::untangle, options);
    case 6:
      return straighten_edge(mesh, h, 0.8, options);
    default:
      return level_jacobian(mesh, t, 0.5, options);
  }
}

}  // namespace

TEST_CASE("each operation that keeps the curves keeps areas, integrals and linear functions by itself",
          "[ops][property]") {
  static std::array<int, names.size()> totals{};  // over all sections
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Domain& domain = GENERATE(from_range(std::begin(domains), std::end(domains)));
  const Projection projection = GENERATE(Projection::conservative, Projection::limited);
  CAPTURE(degree, domain.name, static_cast<int>(projection));
  Mesh mesh = carried(domain, degree, 3);
  std::mt19937_64 random(13);
  const std::size_t faces = mesh.boundary().faces.size();
  const double scale = box_area(mesh);
  std::array<int, names.size()> done{};
  const int most = 2 * mesh.triangle_count();
  for (int k = 0; k < (degree < 4 ? 160 : 60); ++k) {
    const std::size_t kind = random() % names.size();
    if (kind < 2 && mesh.triangle_count() > most) continue;
    CAPTURE(k, names[kind]);
    const std::vector<double> before = kept_sums(mesh);
    const double linear = linear_error(mesh);
    if (operate(mesh, kind, random, {projection}) != Outcome::done) continue;
    ++done[kind];
    const std::vector<double> after = kept_sums(mesh);
    double largest = 1;  // the largest value: integrals round in proportion to it
    for (std::size_t field = 1; field < 3; ++field)
      for (const double value : mesh.fields()[field].values) largest = std::max(largest, std::abs(value));
    double area = 0, integral = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
      (i < faces ? area : integral) = std::max(i < faces ? area : integral, std::abs(after[i] - before[i]));
    CHECK(area <= 1e-13 * scale);
    CHECK(integral <= 1e-13 * scale * largest);
    // Without limits, fits enlarge rounding errors of linear functions, as they enlarge all noise.
    CHECK(linear_error(mesh) <= linear + (projection == Projection::limited ? 1e-13 : 1e-10) * (3 + mesh.size()));
  }
  require_every_invariant(mesh);
  for (std::size_t kind = 0; kind < names.size(); ++kind) totals[kind] += done[kind];
  CAPTURE(totals);
  if (degree == 5 && domain.boundary == std::end(domains)[-1].boundary)  // the last sections
    for (const int total : totals) CHECK(total > 60);
}
