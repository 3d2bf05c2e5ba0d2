// tests/generate/hard_domains_test.cpp: near contacts, slivers, tiny features, sharp angles, and domains by the
// hundred.
#include <catch2/catch.hpp>
#include <random>

#include "generate/meshed_boundary.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/improve/refine.h"
#include "support/hard_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// A polygon of one face. A side with inner control points is curved, one without is straight.
BoundaryComplex polygon(const std::vector<Point>& corners, const std::vector<std::vector<Point>>& inner = {}) {
  BoundaryComplex b = with_faces({"polygon"});
  b.vertices = corners;
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i)
    b.curves.push_back(open_curve(b, "side " + std::to_string(i), i, (i + 1) % n,
                                  inner.empty() ? std::vector<Point>{} : inner[static_cast<std::size_t>(i)], 0));
  return b;
}

/// Two round cells side by side, this far apart where they are nearest.
BoundaryComplex neighbours(double gap) {
  BoundaryComplex b = with_faces({"plasma", "left", "right"});
  const BSpline right = circle(2, {}, 1, 12);
  double reach = 0;  // leftmost point
  for (int i = 0; i < 12; ++i) reach = std::max({reach, -right.evaluate(i).x, -right.evaluate(i + 0.5).x});
  for (const double side : {-1.0, 1.0}) {
    std::vector<Point> points = right.points();
    for (Point& p : points) p.x = side * (p.x + reach + gap / 2);
    if (side < 0) std::reverse(points.begin(), points.end());
    b.curves.push_back(closed_curve("cell", closed_spline(2, std::move(points)), side < 0 ? 1 : 2, 0));
  }
  add_walls(b, {-3, -2}, {3, 2}, 0);
  return b;
}

double value_of(const PassReport& report, const std::string& name) {
  for (const auto& [known, value] : report.values)
    if (known == name) return value;
  FAIL("no value " << name);
  return 0;
}

/// Refines the mesh and checks that it is valid, and that only elements opposite a small angle are left.
void refine_all(Mesh& mesh, const QualityGoals& goals = {}) {
  RefineOptions options;
  options.goals = goals;
  const PassReport report = refine(mesh, options);
  double excused = 0;
  for (const auto& [reason, times] : report.refusals) {
    UNSCOPED_INFO(times << " times " << reason);
    if (reason == "opposite a small angle") excused += static_cast<double>(times);
  }
  CHECK(find_invalid(mesh).empty());
  CHECK(value_of(report, "left") <= excused);
}

/// The length of an edge of the logical mesh.
double edge_length(const Mesh& mesh, HalfEdgeId h) {
  return distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)));
}

}  // namespace

TEST_CASE("two circles next to each other are meshed, with what lies between them", "[generate][hard]") {
  for (const double gap : {1e-3, 2e-7, 1e-8}) {
    CAPTURE(gap);
    meshed(neighbours(gap));
  }
}

TEST_CASE("slivers of aspect ratio ten thousand are meshed", "[generate][hard]") {
  const double h = 1e-4;
  meshed(polygon({{0, 0}, {1, 0}, {1, h}, {0, h}}));
  meshed(polygon({{0, 0}, {1, 0}, {0.5, h}}));
  meshed(polygon({{0, 0}, {1, 0}, {0.01, h}}));
  meshed(polygon({{0, 0}, {1, 0.3}, {1, 0.3 + h}, {0, h}}));
  // Bent like a strip of paper, and lenses that taper to both ends.
  meshed(polygon({{0, 0}, {1, 0}, {1, h}, {0, h}}, {{{0.5, 0.4}}, {}, {{0.5, 0.4 + h}}, {}}));
  meshed(polygon({{0, 0}, {1, 0}}, {{{0.5, 0.4}}, {{0.5, 0.4 + h}}}));
  meshed(polygon({{0, 0}, {1, 0}}, {{{0.5, 1.4}}, {{0.5, 1.4 + h}}}));
}

TEST_CASE("a feature of a millionth of the domain is meshed", "[generate][hard]") {
  const double h = 1e-6;
  meshed(polygon({{0, 0}, {1, 0}, {1, 1}, {0.5 + h, 1}, {0.5 + h, 1 - h}, {0.5, 1 - h}, {0.5, 1}, {0, 1}}));
  meshed(polygon({{0, 0}, {1, 0}, {1, 1}, {0.5 + h, 1}, {0.5, 1 - 1e3 * h}, {0.5 - h, 1}, {0, 1}}));
  meshed(polygon({{0, 0}, {1, 0}, {1, h}, {1 + h, h}, {1 + h, 0}, {2, 0}, {2, 1}, {0, 1}}));
  BoundaryComplex hole = square();
  hole.curves.push_back(closed_curve("hole", circle(2, {0.5, 0.5}, h), outside, 0));
  meshed(hole);
  BoundaryComplex near_wall = square();
  near_wall.curves.push_back(closed_curve("hole", circle(3, {0.3, 2 * h}, h), outside, 0));
  meshed(near_wall);
}

TEST_CASE("gears with fillets are meshed, down to fillets of a millionth", "[generate][hard]") {
  for (const double fillet : {0.3, 0.1, 1e-3, 1e-6}) {
    CAPTURE(fillet);
    meshed(filleted_gear(24, fillet));
  }
}

TEST_CASE("a wing's profile with its sharp trailing edge is meshed, inside and out to a far field",
          "[generate][hard]") {
  const double radius = GENERATE(20.0, 1e4);
  CHECK(meshed(in_far_field(profile(naca_0012, 60), radius)).boundary().cusps.empty());
  meshed(in_far_field(profile(naca_0012, 500), radius));
}

TEST_CASE("a Joukowski profile is meshed but for the cusp of its trailing edge, which is listed", "[generate][hard]") {
  BoundaryComplex b = with_faces({"air", "wing"});
  b.vertices = {{1, 0}, {0, 0}};
  b.curves.push_back(open_curve(b, "upper", 0, 1, {{0.5, 0}, {0, 0.25}}, 1, 0));
  b.curves.push_back(open_curve(b, "lower", 1, 0, {{0, -0.15}, {0.3, 0}}, 1, 0));
  b.curves.push_back(closed_curve("far field", circle(3, {}, 20, 16), 0));
  CHECK(meshed(b).boundary().cusps == std::vector<int>{0});
}

TEST_CASE("two hundred cells in a channel are meshed, whatever their shapes", "[generate][hard][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  BoundaryComplex b = with_faces({"plasma"});
  add_walls(b, {-1, -1}, {39, 19}, 0);
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 10; ++j) {
      // Control points at distances up to 0.999 from a centre on a grid of step 2: the cells may all but touch.
      const auto radius = [&](double) { return 0.75 + 0.249 * u(random); };
      const int face = static_cast<int>(b.faces.size());
      b.faces.push_back({"cell " + std::to_string(face), {}});
      b.curves.push_back(
          closed_curve("", polar_spline(2, 6 + face % 9, 2.0 * Point{double(i), double(j)}, radius), face, 0));
    }
  meshed(b);
}

TEST_CASE("star-shaped domains are meshed by the hundred", "[generate][hard][property]") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u(0, 1);
    const int degree = 2 + static_cast<int>(seed % 3), count = 5 + static_cast<int>(random() % 40);
    const double depth = u(random);
    const auto radius = [&](double) { return 1 - 0.97 * depth * u(random); };
    BoundaryComplex b = with_faces({"star"});
    b.curves.push_back(closed_curve("outline", polar_spline(degree, count, {}, radius), 0));
    meshed(b);
  }
}

TEST_CASE("polygons with curved sides are meshed by the hundred", "[generate][hard][property]") {
  int tried = 0, meshes = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    const int count = 3 + static_cast<int>(random() % 12), degree = 2 + static_cast<int>(seed % 2);
    std::vector<Point> corners;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.45 * u(random)) / count, radius = 0.55 + 0.45 * u(random);
      corners.push_back(radius * Point{std::cos(angle), std::sin(angle)});
    }
    std::vector<std::vector<Point>> inner;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point a = corners[i], d = corners[(i + 1) % corners.size()] - a;
      std::vector<Point> side;
      for (int k = 1; k < degree; ++k) side.push_back(a + double(k) / degree * d + 0.4 * u(random) * Point{-d.y, d.x});
      inner.push_back(std::move(side));
    }
    const BoundaryComplex b = polygon(corners, inner);
    ++tried;
    if (!check_boundary_geometry(b).empty()) continue;  // sides that cross
    ++meshes;
    meshed(b);
  }
  CHECK(2 * meshes > tried);
}

TEST_CASE("small angles between curved sides are meshed down to two billionths", "[generate][hard]") {
  for (const double angle : {1e-5, 1e-7, 1e-8, 4e-9, 2e-9}) {
    BoundaryComplex b = crescent(angle / 2);
    for (Point& p : b.vertices) p += Point{1, 1};
    for (Curve& curve : b.curves)
      for (int i = 0; i < 4; ++i)
        curve.spline.set_point(i, curve.spline.points()[static_cast<std::size_t>(i)] + Point{1, 1});
    CAPTURE(angle);
    for (const BoundaryComplex& moon : {crescent(angle / 2), b}) meshed(moon);
    CHECK(meshed(crescent(angle / 2)).boundary().cusps.empty());
  }
  // Two parabolas with nearly the same tangent, of the same and of different lengths, anywhere.
  for (const double angle : {1e-2, 1e-4, 1e-6, 1e-7})
    for (const double reach : {0.5, 0.993, 1.0}) {
      CAPTURE(angle, reach);
      BoundaryComplex b = with_faces({"horn"});
      b.vertices = {{0, 0}, {1, 1}, {reach, reach * (reach + angle)}};
      for (Point& p : b.vertices) p += Point{0.3, 1};
      b.curves.push_back(open_curve(b, "lower", 0, 1, {{0.8, 1}}, 0));
      b.curves.push_back(open_curve(b, "end", 1, 2, {}, 0));
      b.curves.push_back(open_curve(b, "upper", 2, 0, {{0.3 + reach / 2, 1 + angle * reach / 2}}, 0));
      meshed(b);
    }
}

TEST_CASE("what is too close to be meshed is refused by names, parameters and coordinates", "[generate][hard]") {
  const std::vector<Fault> faults = check_boundary_geometry(neighbours(0));
  REQUIRE_FALSE(faults.empty());
  CHECK_THAT(faults.front().text, Catch::Contains("curve 'cell' (0) at parameter") &&
                                      Catch::Contains("curve 'cell' (1) at parameter") && Catch::Contains("at ("));

  // A hairpin is a curve that turns back, here within less than 1e-9 of its length.
  const BoundaryComplex hairpin = polygon({{0, 0}, {1, 0.5}, {0, 1e-10}}, {{{0.5, -0.5}}, {{0.5, 1}}, {{-1, 5e-11}}});
  CHECK(check_boundary_geometry(hairpin).empty());
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(hairpin, {}, mesh);
  CHECK_FALSE(outcome.ok);
  CHECK_THAT(outcome.failure, Catch::Contains("curve 'side 2' (2), parameters 0.") && Catch::Contains("near (-0.") &&
                                  Catch::Contains("turns too sharply"));
}

TEST_CASE("five hundred cells close together in a box are refined, none of their elements left poor",
          "[generate][hard][refine]") {
  const double angle = GENERATE(20.7, 28.0);
  for (const double gap : {0.02, 1e-4}) {
    CAPTURE(angle, gap);
    Mesh mesh = meshed(cells_in_box(500, gap, 7));
    const int first = mesh.triangle_count();
    QualityGoals goals;
    goals.min_angle = angle;
    refine_all(mesh, goals);
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
                  &c = mesh.point(mesh.corner(t, 2));
      if (!(least_angle(a, b, c) * 180 / std::numbers::pi >= angle - 1e-9) || triangle_area(a, b, c) <= 0) {
        CAPTURE(t, a.x, a.y);
        CHECK(false);
      }
    }
    CHECK(mesh.triangle_count() <= (angle < 21 ? 2 : 3) * first);
  }
}

TEST_CASE("the number of triangles grows with the logarithm of how small rounded corners are",
          "[generate][hard][refine]") {
  double before = 0;
  for (const double fillet : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    CAPTURE(fillet);
    Mesh mesh = meshed(filleted_gear(24, fillet));
    refine_all(mesh);
    if (before > 0)
      CHECK(mesh.triangle_count() <=
            before + 96 * 40);  // fillets ten times smaller: at most 40 triangles more for each of 96
    before = mesh.triangle_count();
  }
}

TEST_CASE("sizes grow away from a small feature, and nothing is smaller than needed", "[generate][hard][refine]") {
  for (const double size : {1e-2, 1e-4, 1e-6}) {
    CAPTURE(size);
    BoundaryComplex b = square();
    b.curves.push_back(closed_curve("hole", circle(2, {0.4, 0.55}, size), outside, 0));
    Mesh mesh = meshed(b);
    refine_all(mesh);
    // The hole's own edges are 0.7 of its radius long. No edge is shorter than 0.2 of its distance from the centre.
    double worst = HUGE_VAL;
    for (const HalfEdgeId h : mesh.half_edges()) {
      const double away = std::min(distance(mesh.point(mesh.origin(h)), {0.4, 0.55}),
                                   distance(mesh.point(mesh.target(h)), {0.4, 0.55}));
      worst = std::min(worst, edge_length(mesh, h) / away);
    }
    CHECK(worst >= 0.2);
    CHECK(mesh.triangle_count() <= 60 + 20 * std::log2(1 / size));
  }
}

TEST_CASE(
    "a wing in a far field is refined to sizes that grow ten thousandfold, with as many triangles as they ask for",
    "[generate][hard][refine]") {
  constexpr double finest = 1e-3, growth = 0.1;
  Mesh mesh = meshed(in_far_field(profile(naca_0012, 60), 100));
  QualityGoals goals;
  goals.size = [&](const Point& p, double) {
    return finest + growth * std::hypot(p.x - std::clamp(p.x, 0.0, 1.0), p.y);
  };
  refine_all(mesh, goals);
  // The wanted sizes h ask for equilateral triangles of area sqrt(3)/4 h^2.
  double asked = 0, shortest = HUGE_VAL, longest = 0;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    const double size = goals.size((net[0] + net[1] + net[2]) / 3, 0);
    asked += element_area(mesh.degree(), net) / (std::numbers::sqrt3 / 4 * size * size);
    for (int e = 0; e < 3; ++e) {
      const double side = edge_length(mesh, half_edge(t, e));
      shortest = std::min(shortest, side / size);
      longest = std::max(longest, side / size);
    }
  }
  CAPTURE(asked, shortest, longest);
  CHECK(mesh.triangle_count() < 1.15 * asked);
  CHECK(mesh.triangle_count() > 0.85 * asked);
  CHECK(longest <= 1.5);
  CHECK(shortest >= 0.2);
}
