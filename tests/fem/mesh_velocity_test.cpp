// tests/fem/mesh_velocity_test.cpp: laws of the velocity of the mesh between curves that follow the flow and curves
// that stay.
#include "pliant/fem/navier_stokes/mesh_velocity.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "pliant/fem/edge_map.h"
#include "pliant/flow/advect.h"
#include "solve_matrices.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

constexpr MeshMotion all_motions[] = {MeshMotion::lagrangian, MeshMotion::harmonic, MeshMotion::blend,
                                      MeshMotion::fixed};

/// Two drops in a channel, the second one near a wall; walls stay, drops follow.
struct DropsInChannel {
  Mesh mesh;
  std::vector<CurveMotion> motions{6, CurveMotion::stays};

  explicit DropsInChannel(int degree, double area = 0.05) {
    mesh_from_boundary(samples::interface(degree), {degree}, mesh);
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = area;
    refine(mesh, options);
    mesh.compact();
    motions[4] = motions[5] = CurveMotion::follows;
  }
};

/// Control points on curves of a motion; a point on curves of both is of those that stay.
std::vector<char> points_on(const Mesh& mesh, const std::vector<CurveMotion>& motions, CurveMotion motion) {
  std::vector<char> result(index(mesh.point_slots()), 0);
  for (const bool stays : {false, true})
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!mesh.is_constrained(h)) continue;
      const CurveMotion here = motions[index(mesh.constraint_curve(mesh.constraint(h)))];
      if ((here == CurveMotion::stays) != stays) continue;
      for (int k = 0; k <= mesh.degree(); ++k) result[index(mesh.edge_point(h, k))] = here == motion ? 1 : 0;
    }
  return result;
}

std::vector<double> random_velocity(const Mesh& mesh, unsigned seed) {
  return random_values(2 * mesh.point_slots(), seed);
}

std::vector<double> linear_velocity(const Mesh& mesh) {
  std::vector<double> result;
  for (const Point& at : mesh.points()) {
    result.push_back(0.3 + 2 * at.x - 0.7 * at.y);
    result.push_back(-1.1 + 0.4 * at.x + 0.9 * at.y);
  }
  return result;
}

std::vector<double> component(const std::vector<double>& values, std::size_t c) {
  std::vector<double> result;
  for (std::size_t k = c; k < values.size(); k += 2) result.push_back(values[k]);
  return result;
}

double distance_from(const Point& p, const Point& a, const Point& b) {
  const double s = std::clamp(pliant::dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
  return distance(p, a + s * (b - a));
}

}  // namespace

TEST_CASE("the mesh moves with curves that follow, bit for bit, and not at all on curves that stay", "[fem]") {
  const int p = GENERATE(1, 2, 3);
  const DropsInChannel drops(p);
  const Mesh& mesh = drops.mesh;
  const std::vector<double> u = random_velocity(mesh, 5);
  const std::vector<char> following = points_on(mesh, drops.motions, CurveMotion::follows);
  const std::vector<char> staying = points_on(mesh, drops.motions, CurveMotion::stays);
  for (const MeshMotion motion : all_motions) {
    CAPTURE(p, static_cast<int>(motion));
    const std::vector<double> w = MeshVelocity(mesh, drops.motions, motion).extend(u);
    REQUIRE(w.size() == u.size());
    int wrong = 0, moving = 0;
    for (std::size_t k = 0; k < w.size(); ++k) {
      if (staying[k / 2] != 0 || motion == MeshMotion::fixed)
        wrong += w[k] != 0 || std::signbit(w[k]) ? 1 : 0;
      else if (following[k / 2] != 0 || motion == MeshMotion::lagrangian)
        wrong += w[k] != u[k] ? 1 : 0;
      else
        moving += w[k] != 0 ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK((moving > 0) == (motion == MeshMotion::harmonic || motion == MeshMotion::blend));
  }
}

TEST_CASE("the velocity of the mesh is linear in that of the flow, 0 for 0, and has the same bits again", "[fem]") {
  const int p = GENERATE(2, 3);
  const DropsInChannel drops(p);
  const std::vector<double> u = random_velocity(drops.mesh, 1), v = random_velocity(drops.mesh, 2);
  std::vector<double> both;
  for (std::size_t k = 0; k < u.size(); ++k) both.push_back(2 * u[k] - 3 * v[k]);
  for (const MeshMotion motion : all_motions) {
    CAPTURE(p, static_cast<int>(motion));
    const MeshVelocity extension(drops.mesh, drops.motions, motion);
    const std::vector<double> wu = extension.extend(u), wv = extension.extend(v);
    std::vector<double> sum;
    for (std::size_t k = 0; k < u.size(); ++k) sum.push_back(2 * wu[k] - 3 * wv[k]);
    CHECK(greatest_difference(extension.extend(both), sum) < 1e-11);
    const std::vector<double> zero = extension.extend(std::vector<double>(u.size(), 0.0));
    CHECK(std::ranges::all_of(zero, [](double each) { return each == 0; }));
    const std::vector<double> again = MeshVelocity(drops.mesh, drops.motions, motion).extend(u);
    CHECK(std::memcmp(again.data(), wu.data(), wu.size() * sizeof(double)) == 0);
  }
}

TEST_CASE("a harmonic velocity is the linear one that all curves have", "[fem]") {
  const int p = GENERATE(1, 2, 3, 4, 6);
  const bool is_divided = GENERATE(false, true);
  CAPTURE(p, is_divided);
  const Mesh mesh(mapped_square(p, 4, bend, is_divided));
  const std::vector<CurveMotion> follow(mesh.boundary().curves.size(), CurveMotion::follows);
  const std::vector<double> linear = linear_velocity(mesh), random = random_velocity(mesh, 3);
  const std::vector<bool> given = on_curves(mesh);
  std::vector<double> u = linear;  // what the flow does off the curves does not matter
  for (std::size_t k = 0; k < u.size(); ++k)
    if (!given[k / 2]) u[k] = random[k];
  CHECK(greatest_difference(MeshVelocity(mesh, follow, MeshMotion::harmonic).extend(u), linear) < 1e-11);
}

TEST_CASE("a harmonic velocity has the least Dirichlet energy, and hardly leaves the range on curves",
          "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3);
  CAPTURE(p);
  const DropsInChannel drops(p, 0.01);
  const std::vector<double> u(2 * index(drops.mesh.point_slots()), 1.0);
  const std::vector<double> w = MeshVelocity(drops.mesh, drops.motions, MeshMotion::harmonic).extend(u);
  const std::vector<bool> given = on_curves(drops.mesh);
  const CsrMatrix stiffness = mass_and_stiffness(drops.mesh).stiffness;
  for (const std::size_t c : {0U, 1U}) {
    const std::vector<double> gradient = product(stiffness, component(w, c));
    double greatest = 0;
    for (std::size_t i = 0; i < gradient.size(); ++i)
      if (!given[i]) greatest = std::max(greatest, std::abs(gradient[i]));
    CHECK(greatest < 1e-6);  // both assemblies have quadrature errors, for curved elements
    if (p == 1) CHECK(greatest < 1e-12);
  }
  const auto [least, most] = std::ranges::minmax(w);
  CHECK(least > -0.02);
  CHECK(most < 1.02);
}

TEST_CASE("a harmonic velocity of many unknowns agrees with the one that two levels find", "[fem][oracle]") {
  const DropsInChannel drops(2, 0.002);
  const Mesh& mesh = drops.mesh;
  const std::vector<double> u = random_velocity(mesh, 7);
  const std::vector<double> w = component(MeshVelocity(mesh, drops.motions, MeshMotion::harmonic).extend(u), 1);
  const std::vector<bool> given = on_curves(mesh);
  CsrMatrix a = mass_and_stiffness(mesh).stiffness;
  std::vector<double> known = w, b(w.size());
  for (std::size_t i = 0; i < w.size(); ++i)
    if (!given[i]) known[i] = 0;
  multiply(a, known, b);
  for (std::size_t i = 0; i < w.size(); ++i) b[i] = given[i] ? 0 : -b[i];
  fix(a, given);
  const auto solver = make_two_level(hats(mesh));
  REQUIRE(solver->factor(a).empty());
  std::vector<double> x(b.size(), 0);
  REQUIRE(solver->solve(b, x, solver_tolerance).converged);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += known[i];
  CHECK(greatest_difference(x, w) < 1e-7);
}

TEST_CASE("a blended velocity fades as the distances from curves say", "[fem][oracle]") {
  const DropsInChannel drops(1, 0.002);  // edges are straight, so that distances are plain
  const Mesh& mesh = drops.mesh;
  const std::vector<double> u = random_velocity(mesh, 9);
  const std::vector<double> w = MeshVelocity(mesh, drops.motions, MeshMotion::blend).extend(u);
  const std::vector<bool> given = on_curves(mesh);
  const auto edges = curve_edges(mesh);
  int faded = 0, untouched = 0;
  double greatest = 0;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    if (given[index(p)]) continue;
    double staying = 100, following = 100, buffer = 1;
    for (std::size_t c = 0; c < edges.size(); ++c)
      for (const HalfEdgeId h : edges[c]) {
        const Point a = mesh.point(mesh.origin(h)), b = mesh.point(mesh.target(h));
        const double d = distance_from(mesh.point(p), a, b);
        if (drops.motions[c] == CurveMotion::follows) following = std::min(following, d);
        if (drops.motions[c] == CurveMotion::follows) continue;
        staying = std::min(staying, d);
        buffer = std::min(buffer, d / (blend_width * distance(a, b)));
      }
    const double t = std::max(buffer, staying / (staying + following)), chi = t * t * (3 - 2 * t);
    for (std::size_t k = 2 * index(p); k < 2 * index(p) + 2; ++k)
      greatest = std::max(greatest, std::abs(w[k] - (t < 1 ? chi : 1) * u[k]));
    ++(t < 1 ? faded : untouched);
  }
  CHECK(greatest < 1e-14);
  CHECK(faded > 50);
  CHECK(untouched > 50);
}

TEST_CASE("a blended velocity is between 0 and that of the flow, and changes little between near places", "[fem]") {
  const int p = GENERATE(2, 3, 5);
  CAPTURE(p);
  const DropsInChannel drops(p, 0.02);
  const Mesh& mesh = drops.mesh;
  const std::vector<double> u(2 * index(mesh.point_slots()), 1.0);
  const std::vector<double> w = MeshVelocity(mesh, drops.motions, MeshMotion::blend).extend(u);
  CHECK(std::ranges::all_of(w, [](double each) { return each >= 0 && each <= 1; }));
  double shortest = 100, gap = 0.05;  // of the first drop and the walls
  const auto edges = curve_edges(mesh);
  for (std::size_t c = 0; c < 4; ++c)
    for (const HalfEdgeId h : edges[c])
      shortest = std::min(shortest, distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h))));
  const std::vector<bool> given = on_curves(mesh);
  const double steepest = 1.5 * std::max(1 / (blend_width * shortest), 1.2 / gap);
  int wrong = 0;
  for (PointId a = 0; a < mesh.point_slots(); ++a)
    for (PointId b = 0; b < a; ++b)
      if (!given[index(a)] && !given[index(b)] &&
          std::abs(w[2 * index(a)] - w[2 * index(b)]) > steepest * distance(mesh.point(a), mesh.point(b)) + 1e-12)
        ++wrong;
  CHECK(wrong == 0);
}

TEST_CASE("an interface that ends on a curve that stays has an end that stays", "[fem]") {
  const int p = GENERATE(2, 3);
  CAPTURE(p);
  const Mesh mesh(mapped_square(p, 4, bend, true));
  const auto& curves = mesh.boundary().curves;
  std::vector<CurveMotion> motions(curves.size(), CurveMotion::stays);
  CurveId middle = 0;
  while (curves[index(middle)].name != "middle") ++middle;
  motions[index(middle)] = CurveMotion::follows;
  const std::vector<double> u(2 * index(mesh.point_slots()), 1.0);
  for (const MeshMotion motion : {MeshMotion::lagrangian, MeshMotion::harmonic, MeshMotion::blend}) {
    const std::vector<double> w = MeshVelocity(mesh, motions, motion).extend(u);
    int still = 0, moving = 0;
    const auto edges = curve_edges(mesh);
    for (const HalfEdgeId h : edges[index(middle)])
      for (int k = 0; k < p; ++k) ++(w[2 * index(mesh.edge_point(h, k))] == 0 ? still : moving);
    CHECK(still == 1);  // the last vertex is not the first point of an edge
    CHECK(moving == 4 * p - 1);
    CHECK(std::ranges::all_of(w, [](double each) { return std::isfinite(each); }));
  }
}

TEST_CASE("meshes without curves that follow, without curves that stay, and without free points are extended",
          "[fem]") {
  const int p = GENERATE(1, 2, 4);
  const int n = GENERATE(1, 3);
  CAPTURE(p, n);
  const Mesh mesh(mapped_square(p, n, bend));
  const std::vector<double> u = random_velocity(mesh, 4);
  for (const CurveMotion all : {CurveMotion::follows, CurveMotion::stays})
    for (const MeshMotion motion : all_motions) {
      CAPTURE(static_cast<int>(all), static_cast<int>(motion));
      const std::vector<CurveMotion> motions(4, all);
      const std::vector<double> w = MeshVelocity(mesh, motions, motion).extend(u);
      CHECK(std::ranges::all_of(w, [](double each) { return std::isfinite(each); }));
      if (all == CurveMotion::stays && motion == MeshMotion::harmonic)
        CHECK(std::ranges::all_of(w, [](double each) { return each == 0; }));
      if (all == CurveMotion::follows && motion == MeshMotion::blend) CHECK(w == u);
    }
}

TEST_CASE("a drop that moves by its radius leaves a harmonic mesh valid, without passes", "[fem]") {
  const int p = GENERATE(2, 3);
  CAPTURE(p);
  BoundaryComplex boundary = samples::square();
  boundary.faces.push_back({"drop", {}});
  boundary.curves.push_back(closed_curve("drop", circle(p, {0.375, 0.5}, 0.25, 16), 1, 0));
  Mesh mesh;
  mesh_from_boundary(boundary, {p}, mesh);
  RefineOptions goals;
  goals.goals.emplace();
  goals.goals->max_area = 0.02;
  refine(mesh, goals);
  mesh.compact();
  std::vector<CurveMotion> motions(4, CurveMotion::stays);
  motions.push_back(CurveMotion::follows);
  for (int step = 0; step < 20; ++step) {
    Field field;
    field.name = "mesh_velocity";
    field.components = 2;
    std::vector<double> u;
    for (PointId k = 0; k < mesh.point_slots(); ++k) u.insert(u.end(), {1.0, 0.0});
    field.values = MeshVelocity(mesh, motions, MeshMotion::harmonic).extend(u);
    mesh.set_field(std::move(field));
    AdvectOptions options;
    options.dt = 0.0125;  // certified, or refused
    REQUIRE(advect_by_field(mesh, 0, options).status == AdvectOutcome::Status::done);
  }
}
