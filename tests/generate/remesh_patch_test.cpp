// tests/generate/remesh_patch_test.cpp: tangled elements are taken out and meshed anew, and all around them stays.
#include "pliant/generate/remesh_patch.h"

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "improve/improve_meshes.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/refit.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Some refined mesh with a linear field and noise.
Mesh refined_mesh(const BoundaryComplex& boundary, int degree, int elements, bool by_face) {
  Mesh mesh = mesh_of(boundary, degree, by_face);
  RefineOptions options;
  double area = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) area += area_at(mesh, t);
  options.goals.max_area = area / elements;
  refine(mesh, options);
  MeshData data = mesh.to_data();
  data.fields.clear();
  add_fields(data, by_face);
  return Mesh(std::move(data));
}

/// Moves inner vertices, the control points around with them, by `reach` times the longest edge of their stars.
/// Field 0 is linear in the places where the points have come to.
Mesh tangled(Mesh mesh, std::uint64_t seed, int count, double reach) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(0, 6.28);
  std::vector<PointId> inner;
  Star star;
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    if (!mesh.is_vertex(v)) continue;
    find_star(mesh, v, star);
    if (!is_on_curve(mesh, star)) inner.push_back(v);
  }
  REQUIRE_FALSE(inner.empty());
  for (int k = 0; k < count; ++k) {
    const PointId v = inner[random() % inner.size()];
    find_star(mesh, v, star);
    double longest = 0;
    std::map<PointId, double> shares;
    for (const HalfEdgeId h : star.outgoing) {
      longest = std::max(longest, distance(mesh.point(v), mesh.point(mesh.target(h))));
      const TriangleId t = triangle_of(h);
      for (int i = 0; i < mesh.net_size(); ++i)
        shares[mesh.net(t)[at(i)]] = double(mesh.layout().exponents(i)[at(edge_of(h))]) / mesh.degree();
    }
    const double a = angle(random);
    for (const auto& [p, share] : shares)
      mesh.set_point(p, mesh.point(p) + share * reach * longest * Vector{std::cos(a), std::sin(a)});
  }
  MeshData data = mesh.to_data();
  for (std::size_t p = 0; p < data.points.size(); ++p)
    data.fields[0].values[p] = data.points[p].x + 2 * data.points[p].y - 3;
  return Mesh(std::move(data));
}

using Sums = std::map<std::array<int, 3>, std::array<double, 2>>;
/// The integral of each component, on each face if by face, and that of its absolute control values.
Sums integrals(const Mesh& mesh) {
  Sums sums;
  const std::size_t n = at(mesh.net_size());
  std::vector<Point> net(n);
  std::vector<double> weights(n);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    integral_weights(mesh.degree(), net, weights);
    for (int field = 0; field < static_cast<int>(mesh.fields().size()); ++field)
      for (int c = 0; c < mesh.fields()[at(field)].components; ++c) {
        auto& sum = sums[{field, c, mesh.fields()[at(field)].by_face ? mesh.face(t) : -1}];
        for (std::size_t k = 0; k < n; ++k) {
          const auto first = mesh.value_index(field, mesh.net(t)[k], mesh.face(t));
          const double part = weights[k] * mesh.fields()[at(field)].values[static_cast<std::size_t>(first) + at(c)];
          sum[0] += part;
          sum[1] += std::abs(part);
        }
      }
  }
  return sums;
}

std::vector<double> areas(const Mesh& mesh) {
  std::vector<double> sums(mesh.boundary().faces.size(), 0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) sums[at(mesh.face(t))] += area_at(mesh, t);
  return sums;
}

std::vector<double> coordinates(const Mesh& mesh, TriangleId t) {
  std::vector<double> all;
  for (const PointId p : mesh.net(t)) all.push_back(mesh.point(p).x), all.push_back(mesh.point(p).y);
  return all;
}

/// How many of the elements are in the other mesh, bit for bit.
int count_kept(const Mesh& was, const Mesh& mesh) {
  std::set<std::vector<double>> all;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) all.insert(coordinates(mesh, t));
  int count = 0;
  for (TriangleId t = 0; t < was.triangle_slots(); ++t) count += static_cast<int>(all.count(coordinates(was, t)));
  return count;
}

void check_remeshed(const Mesh& was, const Mesh& mesh, const RemeshPatchCounts& counts) {
  CHECK(counts.left == 0);
  CHECK(counts.patches > 0);
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
  const std::vector<double> before = areas(was), after = areas(mesh);
  for (std::size_t f = 0; f < before.size(); ++f) CHECK(after[f] == Approx(before[f]).epsilon(1e-12));
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    const Point& q = mesh.point(p);
    REQUIRE(mesh.fields()[0].values[at(p)] == Approx(q.x + 2 * q.y - 3).margin(1e-12 * (1 + mesh.size())));
  }
  const Sums sums = integrals(was), now = integrals(mesh);
  for (const auto& [key, sum] : sums) {
    CAPTURE(key[0], key[1], key[2]);
    CHECK(std::abs(now.at(key)[0] - sum[0]) <= 1e-12 * sum[1]);
  }
}

}  // namespace

TEST_CASE("vertices far out of their stars: the elements around are meshed anew, and all else stays", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto seed = GENERATE(range(std::uint64_t{0}, std::uint64_t{12}));
  const bool by_face = seed % 2 == 1;
  const std::vector<Sample> all = boundaries(degree);
  const Sample& sample = all[seed % all.size()];
  const int moved = seed % 3 == 0 ? 1 : 6;
  const Mesh was =
      tangled(refined_mesh(sample.boundary, degree, 60, by_face), seed, moved, 0.6 + 0.4 * double(seed % 4));
  CAPTURE(degree, seed, sample.name, moved, was.triangle_count());
  const InvalidElements invalid = find_invalid(was);
  if (invalid.empty()) return;
  Mesh mesh = was;
  const RemeshPatchCounts counts = remesh_invalid(mesh);
  CAPTURE(counts.patches, counts.triangles_before, counts.triangles_after, invalid.invalid.size());
  check_remeshed(was, mesh, counts);
  CHECK(count_kept(was, mesh) >= was.triangle_count() - counts.triangles_before - counts.edges_split);
  const std::string text = text_of(mesh);
  CHECK(remesh_invalid(mesh).patches == 0);
  const bool is_same = text_of(mesh) == text;
  CHECK(is_same);
}
