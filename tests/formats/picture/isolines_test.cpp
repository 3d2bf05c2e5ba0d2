// tests/formats/picture/isolines_test.cpp: isolines are where the field has the value, all of them, in whole lines.
#include "formats/picture/isolines/isolines.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "formats/picture/isolines/sign_changes.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/invert_map.h"
#include "support/sample_meshes.h"

namespace pliant {
namespace {

constexpr double tolerance = 1e-5;

/// [-1, 1]² in 2 n² straight triangles with inner points that are moved, so that no edge is where an isoline is.
MeshData square(int degree, int n) {
  samples::MeshBuilder builder(degree);
  std::vector<PointId> corner;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && i < n && j > 0 && j < n;
      const Point move = inner ? Point{0.031 * std::sin(5.0 * i + 3 * j), 0.043 * std::cos(7.0 * i + j)} : Point{};
      corner.push_back(builder.add_vertex(Point{2.0 * i / n - 1, 2.0 * j / n - 1} + move));
    }
  const auto at = [&](int i, int j) { return corner[static_cast<std::size_t>(j * (n + 1) + i)]; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      builder.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), 0);
      builder.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), 0);
    }
  builder.data().boundary.faces.push_back({"square", {}});
  return std::move(builder.data());
}

/// Adds the field a x² + b x y + c y² exactly: its control values are means over pairs of the blossom's arguments.
void add_quadratic(MeshData& mesh, double a, double b, double c) {
  const NetLayout& layout = NetLayout::of(mesh.degree);
  const double p = mesh.degree;
  Field field{"q", 1, false, std::vector<double>(mesh.points.size()), {}, {}};
  const auto form = [&](const Point& v) { return a * v.x * v.x + b * v.x * v.y + c * v.y * v.y; };
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t) {
    const PointId* net = &mesh.triangles[t * static_cast<std::size_t>(layout.size())];
    for (int k = 0; k < layout.size(); ++k) {
      double value = p * p * form(mesh.points[static_cast<std::size_t>(net[k])]);
      for (std::size_t v = 0; v < 3; ++v)
        value -= layout.exponents(k)[v] * form(mesh.points[static_cast<std::size_t>(net[v])]);
      field.values[static_cast<std::size_t>(net[k])] = value / (p * (p - 1));
    }
  }
  mesh.fields = {field};
}

struct Traced {
  MeshData mesh;
  MeshEdges edges;
  ElementValues values;
  FieldPolynomial polynomial;
  Traced(MeshData data, const std::string& field)
      : mesh(std::move(data)),
        edges(find_edges(mesh)),
        values(mesh, {ColorBy::Kind::field, field}),
        polynomial(mesh, values) {}
  IsolineSet at(double value, const std::function<bool(TriangleId)>& in_element = {}) {
    return trace_isoline(mesh, edges, polynomial, polynomial.from_field(value), tolerance, in_element);
  }
};

/// Points along the lines, `n` on each curve.
std::vector<Point> points_of(const IsolineSet& set, int n) {
  std::vector<Point> points;
  for (const Isoline& line : set.lines)
    for (const std::vector<Point>& curve : line.curves)
      for (int k = 0; k <= n; ++k) {
        const std::vector<double> rows = rows_of(curve);
        std::array<double, 2> at{};
        evaluate_polygon(static_cast<int>(curve.size()) - 1, 2, rows, double(k) / n, at);
        points.push_back({at[0], at[1]});
      }
  return points;
}

double length_of(const IsolineSet& set) {
  double sum = 0;
  const int n = 32;
  const std::vector<Point> points = points_of(set, n);
  for (std::size_t k = 1; k < points.size(); ++k)
    if (k % static_cast<std::size_t>(n + 1) != 0) sum += distance(points[k - 1], points[k]);
  return sum;
}

/// Each curve begins, bit for bit, where the one before ends.
void check_joined(const IsolineSet& set) {
  for (const Isoline& line : set.lines) {
    for (std::size_t k = 1; k < line.curves.size(); ++k) CHECK(line.curves[k].front() == line.curves[k - 1].back());
    if (line.closed) CHECK(line.curves.front().front() == line.curves.back().back());
  }
}

}  // namespace

TEST_CASE("isolines of x² + y² are closed circles within the stated error", "[formats][isolines]") {
  const int degree = GENERATE(2, 3, 4, 5, 7, 10);
  const double radius = GENERATE(0.1, 0.37, 0.9);
  CAPTURE(degree, radius);
  MeshData mesh = square(degree, 3);
  add_quadratic(mesh, 1, 0, 1);
  Traced traced(mesh, "q");
  const IsolineSet set = traced.at(radius * radius);
  REQUIRE(set.lines.size() == 1);
  CHECK(set.lines[0].closed);
  CHECK(set.uncertain == 0);
  check_joined(set);
  double most = 0;
  for (const Point& p : points_of(set, 16)) most = std::max(most, std::abs(std::hypot(p.x, p.y) - radius));
  CHECK(most <= tolerance);
  CHECK(length_of(set) == Approx(2 * std::numbers::pi * radius).epsilon(1e-3));
}

TEST_CASE("isolines in some elements and in the others are together those of all", "[formats][isolines]") {
  MeshData mesh = square(GENERATE(2, 5), 4);
  add_quadratic(mesh, 1, 0, 1);
  Traced traced(mesh, "q");
  double together = 0;
  for (const int part : {0, 1}) {
    const IsolineSet some = traced.at(0.25, [part](TriangleId t) { return t % 2 == part; });
    check_joined(some);
    CHECK(some.lines.size() > 1);
    together += length_of(some);
  }
  CHECK(together == Approx(length_of(traced.at(0.25))).epsilon(1e-9));
  CHECK(traced.at(0.25, [](TriangleId) { return false; }).lines.empty());
}

TEST_CASE("on curved elements the isolines of x are straight, from boundary to boundary", "[formats][isolines]") {
  const int degree = GENERATE(1, 2, 3, 4, 6, 9);
  CAPTURE(degree);
  MeshData mesh = samples::disk(degree, 9);
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  Traced traced(mesh, "x");
  for (const double value : {-0.61, -0.2, 0.0, 0.3}) {
    CAPTURE(value);
    const IsolineSet set = traced.at(value);
    REQUIRE(set.lines.size() == 1);
    CHECK(!set.lines[0].closed);
    check_joined(set);
    for (const Point& p : points_of(set, 8)) CHECK(std::abs(p.x - value) <= tolerance);
    // What is above lies to the left: the line runs downwards.
    CHECK(set.lines[0].curves.front().front().y > set.lines[0].curves.back().back().y);
  }
}

TEST_CASE("where two isolines cross, both are drawn", "[formats][isolines]") {
  const int degree = GENERATE(2, 4);
  MeshData mesh = square(degree, 3);
  add_quadratic(mesh, 0, 1, 0);  // x y
  Traced traced(mesh, "q");
  const IsolineSet set = traced.at(0);
  check_joined(set);
  for (const Point& p : points_of(set, 8)) CHECK(std::min(std::abs(p.x), std::abs(p.y)) <= 1e-4);
  CHECK(length_of(set) == Approx(4).epsilon(1e-2));
  for (const Isoline& line : set.lines) CHECK(!line.closed);
}

TEST_CASE("a field that touches a value from above has no isoline, one that touches it from below a double one",
          "[formats][isolines]") {
  MeshData mesh = square(2, 3);
  add_quadratic(mesh, 1, 0, 0);
  CHECK(Traced(mesh, "q").at(0).lines.empty());
  add_quadratic(mesh, -1, 0, 0);
  const IsolineSet ridge = Traced(mesh, "q").at(0);
  for (const Point& p : points_of(ridge, 4)) CHECK(std::abs(p.x) <= 1e-4);
}

TEST_CASE("a constant field has no isolines, nor one that is constant up to rounding", "[formats][isolines]") {
  const double value = GENERATE(0.0, 0.1, 1.0, -3e200, 1e-300);
  CAPTURE(value);
  MeshData mesh = samples::disk(3);
  int k = 0;
  samples::add_field(mesh, "c", 1, [&](const Point&) {
    return std::vector<double>{k++ % 2 == 0 ? value : std::nextafter(value, value + std::abs(value))};
  });
  Traced traced(mesh, "c");
  CHECK(traced.at(value).lines.empty());
  CHECK(traced.at(2 * value + 1).lines.empty());
}

TEST_CASE("a whole loop inside one element is found", "[formats][isolines]") {
  MeshData mesh = square(2, 1);
  add_quadratic(mesh, 1, 0, 1);
  // Moved off the diagonal edge: the loop lies in one of the two triangles.
  const Point center{0.35, -0.4};
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Point& p = mesh.points[k];
    mesh.fields[0].values[k] += -2 * center.x * p.x - 2 * center.y * p.y + squared_length(center);
  }
  const IsolineSet set = Traced(mesh, "q").at(0.04 * 0.04);
  REQUIRE(set.lines.size() == 1);
  CHECK(set.lines[0].closed);
  for (const Point& p : points_of(set, 8)) CHECK(std::abs(distance(p, center) - 0.04) <= tolerance);
}

TEST_CASE("the isolines of a vector are those of its length", "[formats][isolines]") {
  const int degree = GENERATE(1, 2, 5);
  CAPTURE(degree);
  MeshData mesh = samples::disk(degree, 9);
  samples::add_field(mesh, "r", 2, [](const Point& p) { return std::vector<double>{1e200 * p.x, 1e200 * p.y}; });
  Traced traced(mesh, "r");
  const IsolineSet set = traced.at(0.25e200);
  REQUIRE(set.lines.size() == 1);
  CHECK(set.lines[0].closed);
  for (const Point& p : points_of(set, 8)) CHECK(std::abs(std::hypot(p.x, p.y) - 0.25) <= tolerance);
  CHECK(traced.at(-1).lines.empty());
}

TEST_CASE("a field by face has isolines of its own on each side of a jump", "[formats][isolines]") {
  MeshData mesh = square(2, 2);
  mesh.boundary.faces.push_back({"other", {}});
  for (std::size_t t = 4; t < 8; ++t) mesh.triangle_faces[t] = 1;  // the upper half
  Field field{"x", 1, true, {}, {}, {}};
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    for (FaceId face = 0; face < 2; ++face) {
      bool is_there = false;
      for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        is_there = is_there || (mesh.triangles[k] == static_cast<PointId>(p) && mesh.triangle_faces[k / 6] == face);
      if (!is_there) continue;
      field.places.push_back({static_cast<std::int32_t>(p), face});
      field.values.push_back(mesh.points[p].x + 0.25 * face);
    }
  mesh.fields = {field};
  const IsolineSet set = Traced(mesh, "x").at(0.1);
  REQUIRE(set.lines.size() == 2);
  std::vector<double> places;
  for (const Isoline& line : set.lines) places.push_back(line.curves.front().front().x);
  std::sort(places.begin(), places.end());
  CHECK(places[0] == Approx(-0.15));
  CHECK(places[1] == Approx(0.1));
}

TEST_CASE("isolines of any field have the value, end at the boundary only, and none is missed",
          "[formats][isolines][property]") {
  const int seed = GENERATE(range(0, 24));
  const int degree = 1 + seed % 8;
  CAPTURE(seed, degree);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> coefficient(-1, 1);
  MeshData mesh = samples::disk(degree, 9);
  samples::add_field(mesh, "f", 1, [&](const Point&) { return std::vector<double>{coefficient(random)}; });
  Traced traced(mesh, "f");
  const double value = 0.3 * coefficient(random);
  const IsolineSet set = traced.at(value);
  check_joined(set);

  std::vector<Point> ends;
  for (const Isoline& line : set.lines)
    if (!line.closed) ends.insert(ends.end(), {line.curves.front().front(), line.curves.back().back()});
  std::size_t on_boundary = 0;
  for (const MeshEdge& edge : traced.edges.edges) {
    if (edge.sides[1] != none) continue;
    std::vector<double> rows;
    for (const PointId p : edge.points) rows.push_back(mesh.fields[0].values[static_cast<std::size_t>(p)] - value);
    on_boundary += sign_changes(rows, rows.front() >= 0, rows.back() >= 0).size();
  }
  CHECK(ends.size() == on_boundary);

  const std::vector<Point> points = points_of(set, 6);
  std::vector<double> control;
  double most = 0;
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t) {
    const std::vector<Point> net = element_net(mesh, t);
    std::vector<double> rows;
    for (const Point& p : net) rows.insert(rows.end(), {p.x, p.y});
    Box box;
    for (const Point& p : net) box.extend(p);
    std::vector<Point> near;
    for (const Point& p : points)
      if (box.contains(p)) near.push_back(p);
    // What is drawn has the value, up to the stated distance times the slope there.
    for (const Point& p : near) {
      const ElementSearch search = find_in_element(degree, net, p, 1e-12);
      if (search.answer != SearchAnswer::found) continue;
      traced.values.control_values(t, control);
      std::array<double, 1> f{}, f2{}, f3{};
      std::array<double, 2> at{}, x2{}, x3{};
      evaluate_net(degree, 1, control, search.xi, f, f2, f3);
      evaluate_net(degree, 2, rows, search.xi, at, x2, x3);
      const double det = x2[0] * x3[1] - x3[0] * x2[1];
      const double slope = std::hypot((f2[0] * x3[1] - f3[0] * x2[1]) / det, (x2[0] * f3[0] - x3[0] * f2[0]) / det);
      most = std::max(most, std::abs(f[0] - value) / (slope + 1e-3));
    }
    // Between two samples on different sides of the value there is a line.
    const int n = 12;
    const auto sample = [&](int i, int j) {
      const Barycentric xi{double(n - i - j) / n, double(i) / n, double(j) / n};
      std::array<double, 2> at{};
      evaluate_net(degree, 2, rows, xi, at);
      return std::pair(Point{at[0], at[1]}, traced.values.at(t, xi) >= value);
    };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i + j < n; ++i) {
        const auto [a, above_a] = sample(i, j);
        const auto [b, above_b] = sample(i + 1, j);
        if (above_a == above_b) continue;
        double nearest = HUGE_VAL;
        for (const Point& p : points) nearest = std::min(nearest, distance(p, 0.5 * (a + b)));
        CHECK(nearest <= 3 * distance(a, b));
      }
  }
  CHECK(most <= 2 * tolerance);
}

TEST_CASE("changes of sign are found, all of them, and as the signs at the ends say", "[formats][isolines][property]") {
  const int seed = GENERATE(range(0, 60));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<double> b(static_cast<std::size_t>(2 + seed % 10));
  for (double& each : b) each = part(random);
  const std::vector<double> roots = sign_changes(b, b.front() >= 0, b.back() >= 0);
  const auto value = [&](double s) {
    double result = 0;
    evaluate_polygon(static_cast<int>(b.size()) - 1, 1, b, s, {&result, 1});
    return result;
  };
  for (const double s : roots) CHECK(std::abs(value(s)) <= 1e-13);
  std::size_t counted = 0;
  for (int k = 0; k < 4000; ++k) counted += (value(k / 4000.0) >= 0) != (value((k + 1) / 4000.0) >= 0) ? 1 : 0;
  CHECK(roots.size() == counted);
  CHECK(sign_changes(std::vector<double>{1, 1e-18}, true, false) == std::vector<double>{1});
  CHECK(sign_changes(std::vector<double>{0, -1}, true, false) == std::vector<double>{0});
}

TEST_CASE("the range of a field is exact where its greatest value is inside an element", "[formats][isolines]") {
  const int degree = GENERATE(2, 3, 6);
  MeshData mesh = square(degree, 1);
  add_quadratic(mesh, -1, 0.3, -2);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) mesh.fields[0].values[k] += 0.77 * mesh.points[k].x;
  // Summit where -2 x + 0.3 y + 0.77 = 0 and 0.3 x - 4 y = 0.
  const double x = 0.77 * 4 / (8 - 0.09), y = 0.075 * x;
  const ValueRange range = exact_range(mesh, ElementValues(mesh, {ColorBy::Kind::field, "q"}), {});
  CHECK(range.high == Approx(-x * x + 0.3 * x * y - 2 * y * y + 0.77 * x).epsilon(1e-6));
  CHECK(range.low == Approx(-1 - 0.3 - 2 - 0.77).epsilon(1e-12).margin(1.5));
}

}  // namespace pliant
