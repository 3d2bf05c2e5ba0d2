// tests/generate/remesh_patch_test.cpp: tangled elements are taken out and meshed anew, and all around them stays.
#include "pliant/generate/remesh_patch.h"

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "improve/tangled_meshes.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/refit/refit.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// A refined mesh with a linear field and noise.
Mesh refined_mesh(const BoundaryComplex& boundary, int degree, int elements, bool by_face) {
  Mesh mesh = mesh_of(boundary, degree, by_face);
  RefineOptions options;
  options.goals.emplace();
  double area = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) area += area_at(mesh, t);
  options.goals->max_area = area / elements;
  refine(mesh, options);
  MeshData data = mesh.to_data();
  data.fields.clear();
  add_fields(data, by_face);
  return Mesh(std::move(data));
}

double linear(const Point& p) { return p.x + 2 * p.y - 3; }

/// The mesh with field 0 made anew: the linear function of the places where its points are now.
Mesh with_linear_field(MeshData data) {
  for (std::size_t p = 0; p < data.points.size(); ++p) data.fields[0].values[p] = linear(data.points[p]);
  return Mesh(std::move(data));
}

/// Moves inner vertices, with the control points around them, by `reach` times the square root of an element's area.
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
  if (inner.empty()) return mesh;
  double area = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) area += area_at(mesh, t);
  const double way = reach * std::sqrt(area / mesh.triangle_count());
  for (int k = 0; k < count; ++k) {
    const PointId v = inner[random() % inner.size()];
    find_star(mesh, v, star);
    std::map<PointId, double> shares;
    for (const HalfEdgeId h : star.outgoing) {
      const TriangleId t = triangle_of(h);
      for (int i = 0; i < mesh.net_size(); ++i)
        shares[mesh.net(t)[index(i)]] = double(mesh.layout().exponents(i)[index(edge_of(h))]) / mesh.degree();
    }
    const double a = angle(random);
    for (const auto& [p, share] : shares)
      mesh.set_point(p, mesh.point(p) + share * way * Vector{std::cos(a), std::sin(a)});
  }
  return with_linear_field(mesh.to_data());
}

using Sums = std::map<std::array<int, 3>, std::array<double, 2>>;
/// The integrals of each component and of its absolute control values; on each face if the field is by face.
Sums integrals(const Mesh& mesh) {
  Sums sums;
  const std::size_t n = index(mesh.net_size());
  std::vector<Point> net(n);
  std::vector<double> weights(n);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    integral_weights(mesh.degree(), net, weights);
    for (int field = 0; field < static_cast<int>(mesh.fields().size()); ++field)
      for (int c = 0; c < mesh.fields()[index(field)].components; ++c) {
        auto& sum = sums[{field, c, mesh.fields()[index(field)].by_face ? mesh.face(t) : -1}];
        for (std::size_t k = 0; k < n; ++k) {
          const auto first = mesh.value_index(field, mesh.net(t)[k], mesh.face(t));
          const double part =
              weights[k] * mesh.fields()[index(field)].values[static_cast<std::size_t>(first) + index(c)];
          sum[0] += part;
          sum[1] += std::abs(part);
        }
      }
  }
  return sums;
}

std::vector<double> areas(const Mesh& mesh) {
  std::vector<double> sums(mesh.boundary().faces.size(), 0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) sums[index(mesh.face(t))] += area_at(mesh, t);
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

/// Meshes anew where the mesh is tangled. Checks that it is valid then, that nothing else has changed, and that a
/// second run does nothing.
RemeshPatchCounts check_remeshing(const Mesh& was, Mesh* result = nullptr) {
  Mesh mesh = was;
  const RemeshPatchCounts counts = remesh_invalid(mesh);
  CAPTURE(counts.patches, counts.triangles_before, counts.triangles_after, counts.edges_split);
  CHECK(counts.left == 0);
  CHECK(counts.patches > 0);
  CHECK(count_kept(was, mesh) >= was.triangle_count() - counts.triangles_before - counts.edges_split);
  check_left(mesh);
  const std::vector<double> before = areas(was), after = areas(mesh);
  for (std::size_t f = 0; f < before.size(); ++f) CHECK(after[f] == Approx(before[f]).epsilon(1e-12));
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    REQUIRE(mesh.fields()[0].values[index(p)] == Approx(linear(mesh.point(p))).margin(1e-12 * (1 + mesh.size())));
  const Sums sums = integrals(was), now = integrals(mesh);
  for (const auto& [key, sum] : sums) {
    CAPTURE(key[0], key[1], key[2]);
    CHECK(std::abs(now.at(key)[0] - sum[0]) <= 1e-12 * sum[1]);
  }
  const std::string text = text_of(mesh);
  CHECK(remesh_invalid(mesh).patches == 0);
  const bool is_same = text_of(mesh) == text;
  CHECK(is_same);
  if (result != nullptr) *result = std::move(mesh);
  return counts;
}

}  // namespace

TEST_CASE("where vertices are far out of their stars the elements around are meshed anew, and all else stays",
          "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  long patches = 0, splits = 0;
  for (std::uint64_t seed = 0; seed < 18; ++seed) {
    const std::vector<Sample> all = boundaries(degree);
    const Sample& sample = all[seed % all.size()];
    const int moved = seed % 3 == 0 ? 3 : 8;
    const Mesh was =
        tangled(refined_mesh(sample.boundary, degree, 80, seed % 2 == 1), seed, moved, 1.5 + double(seed % 4));
    CAPTURE(degree, seed, sample.name, moved, was.triangle_count());
    REQUIRE_FALSE(find_invalid(was).empty());
    const RemeshPatchCounts counts = check_remeshing(was);
    patches += counts.patches;
    splits += counts.edges_split;
  }
  CHECK(patches > 18);
  if (degree > 1) CHECK(splits > 0);  // borders that turn too much are split
}

TEST_CASE("where all inner points are moved at random, faces are meshed anew from their curves", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::vector<Sample> all = boundaries(degree);
    const Sample& sample = all[seed % all.size()];
    const Mesh start = refined_mesh(sample.boundary, degree, 60, seed % 2 == 1);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> both(-1, 1);
    const double step = std::sqrt(area_of(start) / start.triangle_count());
    const Mesh was = with_linear_field(moved(start, true, [&](const Point&) {
      return step * Vector{both(random), both(random)};
    }));
    CAPTURE(degree, seed, sample.name, was.triangle_count());
    REQUIRE_FALSE(find_invalid(was).empty());
    check_remeshing(was);
  }
}

TEST_CASE("regions around a slit and a vertex without curves keep both", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  BoundaryComplex boundary = samples::with_faces({"square"});
  boundary.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.3, 0.3}, {0.7, 0.4}, {0.4, 0.7}};
  for (int c = 0; c < 4; ++c) boundary.curves.push_back(straight_curve(boundary, degree, 2, c, (c + 1) % 4, 0));
  boundary.curves.push_back(straight_curve(boundary, degree, 2, 4, 5, 0, 0));
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Mesh was = tangled(refined_mesh(boundary, degree, 60, seed % 2 == 1), seed, 10, 3);
    CAPTURE(degree, seed, was.triangle_count());
    REQUIRE_FALSE(find_invalid(was).empty());
    Mesh mesh;
    check_remeshing(was, &mesh);
    REQUIRE(mesh.lone_vertices().size() == 1);
    REQUIRE(mesh.lone_vertices().front().point != none);
    CHECK(mesh.point(mesh.lone_vertices().front().point) == Point{0.4, 0.7});
  }
}

TEST_CASE("values stay within their range where regions are meshed anew, and smooth ones stay near", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const auto smooth = [](const Point& p) { return std::sin(p.x) * std::cos(p.y); };
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Mesh start = refined_mesh(samples::one_cell(degree), degree, 200, false);
    MeshData data = tangled(std::move(start), seed, 1, 1.5).to_data();
    // Control values of a function at the control points represent it up to second order in the size of elements.
    samples::add_field(data, "smooth", 1, [&](const Point& p) { return std::vector<double>{smooth(p)}; });
    const Mesh was(std::move(data));
    CAPTURE(degree, seed);
    Mesh mesh = was;
    if (remesh_invalid(mesh).patches == 0) continue;
    double low = 1, high = -1;
    for (const double v : was.fields()[2].values) low = std::min(low, v), high = std::max(high, v);
    for (PointId p = 0; p < mesh.point_slots(); ++p) {
      const double v = mesh.fields()[2].values[index(p)];
      CHECK(v >= low - 1e-12);
      CHECK(v <= high + 1e-12);
      CHECK(v == Approx(smooth(mesh.point(p))).margin(0.1));
    }
  }
}

TEST_CASE("where curves cross, the elements stay as they are and are counted", "[generate]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const Mesh start = refined_mesh(samples::annulus(degree, 0.4), degree, 60, false);
  MeshData data = start.to_data();
  // The inner curve goes across the outer one, with the elements beside it.
  const auto is_inner = [](const Point& p) { return distance(p, Point{}) < 0.65; };
  const auto shift = [&](const Point& p) { return is_inner(p) ? p + Vector{0.9, 0} : p; };
  for (Point& p : data.points) p = shift(p);
  for (Curve& curve : data.boundary.curves)
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, shift(curve.spline.points()[index(i)]));
  const Mesh was(std::move(data));
  const InvalidElements invalid = find_invalid(was);
  REQUIRE_FALSE(invalid.empty());
  Mesh mesh = was;
  const RemeshPatchCounts counts = remesh_invalid(mesh);
  CHECK(counts.left > 0);
  CHECK(counts.left <= static_cast<long>(invalid.invalid.size() + invalid.degenerate.size()));
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
}
