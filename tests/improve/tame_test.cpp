// tests/improve/tame_test.cpp: a known map makes valid elements whose straight triangles are turned over; taming mends
// them.
#include "pliant/improve/refining/tame.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/smoothing/straighten_together.h"
#include "pliant/mesh/turned_over.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// The polar form, at as many places as the degree, of the map that moves P by s u (n - u) along (-k, 1), where
/// u = x + k y: it shears along the lines on which u is constant, so that det J stays what it was, and the image of a
/// straight mesh is a mesh of degree 2 or more, exactly.
Point sheared(std::span<const Point> places, double s, double n) {
  constexpr double k = 0.37;
  const auto u = [](const Point& p) { return p.x + k * p.y; };
  Point mean;
  double square = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    mean += (1.0 / static_cast<double>(places.size())) * places[i];
    for (std::size_t j = i + 1; j < places.size(); ++j) square += u(places[i]) * u(places[j]);
  }
  square /= static_cast<double>(places.size() * (places.size() - 1)) / 2;
  return mean + s * (n * u(mean) - square) * Vector{-k, 1};
}

/// The straight grid [0, n]^2 under the map above: its sides are parabolas.
Mesh sheared_grid(int degree, int n, double s) {
  const Mesh straight = grid(degree, n, 3);
  MeshData data = straight.to_data();
  const NetLayout& layout = NetLayout::of(degree);
  const auto size = static_cast<std::size_t>(net_size(degree));
  const std::vector<Point> old = data.points;
  for (std::size_t first = 0; first < data.triangles.size(); first += size)
    for (std::size_t k = 0; k < size; ++k) {
      std::vector<Point> places;
      for (std::size_t c = 0; c < 3; ++c)
        for (int times = 0; times < layout.exponents(static_cast<int>(k))[c]; ++times)
          places.push_back(old[static_cast<std::size_t>(data.triangles[first + c])]);
      data.points[static_cast<std::size_t>(data.triangles[first + k])] = sheared(places, s, n);
    }
  for (Point& v : data.boundary.vertices) v = sheared(std::vector<Point>(static_cast<std::size_t>(degree), v), s, n);
  for (Curve& curve : data.boundary.curves) {
    const BSpline& line = curve.spline;
    const Point a = line.points().front(), along = line.points().back() - a;
    const double last = line.knots().back();
    std::vector<double> knots(line.knots().begin(), line.knots().end());
    std::vector<Point> points;
    for (std::size_t i = 0; i < line.points().size(); ++i) {
      std::vector<Point> places;
      for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k)
        places.push_back(a + (knots[i + k] / last) * along);
      points.push_back(sheared(places, s, n));
    }
    curve.spline = BSpline(degree, false, std::move(knots), std::move(points));
  }
  return Mesh(std::move(data));
}

std::vector<TriangleId> find_turned_over(const Mesh& mesh) {
  std::vector<TriangleId> found;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t) && is_turned_over(mesh, t)) found.push_back(t);
  return found;
}

}  // namespace

TEST_CASE("triangles that are turned over are cut, straightened and flipped until none is, but in narrow wedges",
          "[improve][property]") {
  const int degree = GENERATE(2, 3, 4);
  const double shear = GENERATE(3.0, 6.0, 12.0);
  CAPTURE(degree, shear);
  Mesh mesh = sheared_grid(degree, 3, shear);
  check_left(mesh);
  const std::vector<TriangleId> turned_over = find_turned_over(mesh);
  REQUIRE(turned_over.size() > 2);
  const double area = area_of(mesh);
  const RefitOptions refit;
  LegalizeCounts flips;
  const TameCounts counts = Tamer(mesh, refit, flips).tame(turned_over, 100000);
  mesh.compact();
  CHECK(counts.left == 0);
  if (shear > 5) CHECK(counts.splits + counts.curve_splits > 0);  // at less shear flips suffice
  const SharpCorners corners(mesh);  // the shear makes corners of the square sharp; refinement mends narrow wedges
  for (const TriangleId t : find_turned_over(mesh)) {
    bool is_in_wedge = false;
    for (int c = 0; c < 3; ++c)
      is_in_wedge =
          is_in_wedge || corners.narrow_wedge(mesh, mesh.corner(t, c), mesh.corner(t, (c + 1) % 3), 0) != none;
    CHECK(is_in_wedge);
  }
  CHECK(mesh.triangle_count() < 4000);
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
  check_left(mesh);
}

TEST_CASE("no more triangles are made than allowed", "[improve]") {
  Mesh mesh = sheared_grid(2, 3, 12);
  LegalizeCounts flips;
  const RefitOptions refit;
  const TameCounts counts = Tamer(mesh, refit, flips).tame(find_turned_over(mesh), 25);
  CHECK(counts.left > 0);
  CHECK(mesh.triangle_count() <= 27);  // the last cut may make two
}

TEST_CASE("a bent edge is straightened together with those that are in its way", "[improve]") {
  const int degree = GENERATE(2, 3);
  Mesh mesh = sheared_grid(degree, 4, 0.4);
  const auto bends = [](const Mesh& m, HalfEdgeId h) {
    const Point &a = m.point(m.origin(h)), &b = m.point(m.target(h));
    double off = 0;
    for (int k = 1; k < m.degree(); ++k)
      off = std::max(off, distance(m.point(m.edge_point(h, k)), a + (double(k) / m.degree()) * (b - a)));
    return off > 1e-9;
  };
  REQUIRE(find_turned_over(mesh).empty());
  HalfEdgeId inner = none;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (inner != none) break;
    bool is_inside = !mesh.is_constrained(h);
    for (const HalfEdgeId side : {next(h), previous(h)}) is_inside = is_inside && !mesh.is_constrained(side);
    if (is_inside && bends(mesh, h)) inner = h;
  }
  REQUIRE(inner != none);
  const double area = area_of(mesh);
  CHECK(straighten_together(mesh, inner, bends, {}));
  CHECK(!bends(mesh, inner));
  CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
  check_left(mesh);
  CHECK(!straighten_together(mesh, inner, bends, {}));
}
