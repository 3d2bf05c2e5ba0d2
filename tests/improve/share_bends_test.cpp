// tests/improve/share_bends_test.cpp: elements beside bent curves get a more even Jacobian, and stay valid.
#include "pliant/improve/smoothing/share_bends.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/smoothing/straighten_edges.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/level_jacobian.h"
#include "pliant/quality/element/element_quality.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

double least_scaled_jacobian(const Mesh& mesh) {
  double least = 1;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    least = std::min(least, scaled_jacobian(mesh.degree(), net));
  }
  return least;
}

/// The coefficients of det J of t and of the elements beyond its inner edges, one row each.
std::vector<std::vector<double>> jacobians_around(const Mesh& mesh, TriangleId t) {
  std::vector<TriangleId> around{t};
  for (int e = 0; e < 3; ++e)
    if (!mesh.is_constrained(half_edge(t, e)) && mesh.twin(half_edge(t, e)) != none)
      around.push_back(triangle_of(mesh.twin(half_edge(t, e))));
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  std::vector<std::vector<double>> rows;
  for (const TriangleId u : around) {
    mesh.gather_points(u, net);
    rows.emplace_back(static_cast<std::size_t>(net_size(jacobian_degree(mesh.degree()))));
    jacobian_net(mesh.degree(), net, rows.back());
  }
  return rows;
}

/// The sum that level_jacobian makes small: (C / mean C before - 1)^2 over the coefficients C of det J.
double unevenness(const std::vector<std::vector<double>>& rows, const std::vector<std::vector<double>>& before) {
  double sum = 0;
  for (std::size_t e = 0; e < rows.size(); ++e) {
    double mean = 0;
    for (const double c : before[e]) mean += c / double(before[e].size());
    for (const double c : rows[e]) sum += (c / mean - 1) * (c / mean - 1);
  }
  return sum;
}

Mesh refined(const Sample& sample, int degree, double parts) {
  Mesh mesh = mesh_of(sample.boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / parts;
  refine(mesh, options);
  straighten_edges(mesh);
  return mesh;
}

}  // namespace

TEST_CASE("sharing the bend of the curves raises the least scaled Jacobian and moves nothing on a curve", "[improve]") {
  const int degree = GENERATE(2, 3, 4);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    MeshData data = refined(sample, degree, 100).to_data();
    add_fields(data);
    Mesh mesh(std::move(data));
    const Mesh before = mesh;
    const double least = least_scaled_jacobian(mesh);
    const ShareCounts counts = share_bends(mesh);
    CHECK(find_invalid(mesh).empty());
    CHECK(check_mesh(mesh).empty());
    CHECK(least_scaled_jacobian(mesh) >= least);
    if (least < 0.9) CHECK(counts.levelled > 0);
    for (const HalfEdgeId h : mesh.half_edges())
      for (int k = 0; k <= degree; ++k)
        if (k == 0 || mesh.is_constrained(h))
          CHECK(mesh.point(mesh.edge_point(h, k)) == before.point(before.edge_point(h, k)));
    const Field& linear = mesh.fields()[0];
    for (std::size_t p = 0; p < linear.values.size(); ++p) {
      const Point& x = mesh.point(static_cast<PointId>(p));
      CHECK(linear.values[p] == Approx(x.x + 2 * x.y - 3).margin(1e-12));
    }
  }
}

TEST_CASE("sharing bends takes a round cell in fine elements at least half way to a constant det J", "[improve]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  Mesh mesh = refined({"one cell", samples::one_cell(degree)}, degree, 400);
  const double missing = 1 - least_scaled_jacobian(mesh);
  share_bends(mesh, 1.0);
  CHECK(1 - least_scaled_jacobian(mesh) < missing / 2);
}

TEST_CASE("levelling one element makes det J more even around it, or leaves the mesh as it was", "[improve]") {
  const int degree = GENERATE(2, 3, 5);
  long done = 0;
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree);
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      const auto before = jacobians_around(mesh, t);
      const MeshData old = mesh.to_data();
      if (level_jacobian(mesh, t) == Outcome::done) {
        ++done;
        CHECK(unevenness(jacobians_around(mesh, t), before) <= unevenness(before, before) * (1 + 1e-9) + 1e-20);
        CHECK(find_invalid(mesh).empty());
      } else {
        CHECK(mesh.to_data().points == old.points);
      }
    }
    CHECK(check_mesh(mesh).empty());
  }
  CHECK(done > 100);
}
