// tests/mesh/locate_test.cpp: points are found in their elements, and those outside are outside.
#include "pliant/mesh/locate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/remove_point.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"
#include "support/triangles.h"

using namespace pliant;
using samples::Random;

namespace {

Point image(const Mesh& mesh, TriangleId t, const Barycentric& xi) {
  std::vector<Point> net(index(mesh.net_size()));
  mesh.gather_points(t, net);
  Point value;
  evaluate_net(mesh.degree(), 2, {&net[0].x, 2 * net.size()}, xi, {&value.x, 2});
  return value;
}

/// A band along two turns of a spiral.
BoundaryComplex spiral(int degree) {
  std::vector<Point> points;
  const auto add = [&](double angle, double off) {
    points.push_back((0.3 + 0.12 * angle / std::numbers::pi + off) * Point{std::cos(angle), std::sin(angle)});
  };
  for (int k = 0; k <= 40; ++k) add(0.1 * k * std::numbers::pi, 0.05);
  for (int k = 40; k >= 0; --k) add(0.1 * k * std::numbers::pi, -0.05);
  BoundaryComplex b = samples::with_faces({"band"});
  b.curves.push_back(samples::closed_curve("outline", samples::closed_spline(degree, points), 0));
  return b;
}

/// A channel around an obstacle, which is a hole.
BoundaryComplex channel(int degree) {
  BoundaryComplex b = samples::with_faces({"fluid"});
  b.vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(samples::open_curve(b, "wall", i, (i + 1) % 4, {}, 0));
  b.curves.push_back(samples::closed_curve("obstacle", samples::circle(degree, {1, 0.5}, 0.35), outside, 0));
  return b;
}

struct Sample {
  std::string name;
  Mesh mesh;
};

Mesh meshed(const BoundaryComplex& boundary, int degree, double area = 0) {
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, {degree}, mesh);
  CAPTURE(outcome.failure);
  REQUIRE(outcome.ok);
  if (area > 0) {
    RefineOptions options;
    options.goals.max_area = area;
    refine(mesh, options);
  }
  return mesh;
}

/// Moves inner control points, vertices too, at random as long as all elements stay valid: as curved as can be.
void shake(Mesh& mesh, int moves, int seed) {
  std::vector<std::vector<TriangleId>> users(index(mesh.point_slots()));
  std::vector<bool> is_fixed(index(mesh.point_slots()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    for (const PointId p : mesh.net(t)) users[index(p)].push_back(t);
    for (int e = 0; e < 3; ++e)
      for (int k = 0; k <= mesh.degree() && mesh.twin(half_edge(t, e)) == none; ++k)
        is_fixed[index(mesh.edge_point(half_edge(t, e), k))] = true;
  }
  Random random(seed);
  for (int move = 0; move < moves; ++move) {
    const PointId p = random.integer(0, mesh.point_slots() - 1);
    if (is_fixed[index(p)]) continue;
    const Point before = mesh.point(p);
    const TriangleId first = users[index(p)].front();
    const double length = distance(mesh.point(mesh.corner(first, 0)), mesh.point(mesh.corner(first, 1)));
    mesh.set_point(p, before + length * random.point(-0.6, 0.6));
    if (!std::ranges::all_of(users[index(p)],
                             [&](TriangleId t) { return certify_element(mesh, t) == Validity::valid; }))
      mesh.set_point(p, before);
  }
}

std::vector<Sample> sample_meshes(int degree) {
  std::vector<Sample> all{{"cell", meshed(samples::one_cell(degree), degree, 0.01)},
                          {"annulus", meshed(samples::annulus(degree), degree)},
                          {"gear", meshed(samples::gear(12), degree)},
                          {"channel", meshed(channel(degree), degree, 0.02)},
                          {"three cells", meshed(samples::three_cells(degree), degree)},
                          {"spiral", meshed(spiral(degree), degree)}};
  if (degree >= 2) all.push_back({"glyph", meshed(samples::glyph(), degree)});
  if (degree >= 3) all.push_back({"crescent", meshed(samples::crescent(0.6), degree)});
  if (degree >= 3) all.push_back({"crescent with a cusp", meshed(samples::crescent(0), degree)});
  if (degree >= 2)
    for (Sample& sample : all) {
      shake(sample.mesh, 30000 / degree / degree, degree);
      REQUIRE(find_invalid(sample.mesh).empty());
    }
  return all;
}

/// The outer boundary as segments, which are within `margin` of it.
class OuterPolygon {
 public:
  explicit OuterPolygon(const Mesh& mesh) {
    constexpr int parts = 64;
    std::vector<Point> polygon(index(mesh.degree()) + 1);
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (mesh.twin(h) != none) continue;
      mesh.gather_edge_points(h, polygon);
      double bend = 0;
      for (std::size_t k = 0; k + 2 < polygon.size(); ++k)
        bend = std::max(bend, length(polygon[k] - 2 * polygon[k + 1] + polygon[k + 2]));
      margin_ = std::max(margin_, mesh.degree() * (mesh.degree() - 1) * bend / (8.0 * parts * parts) + 1e-13);
      Point before = polygon.front();
      for (int s = 1; s <= parts; ++s) {
        Point here;
        evaluate_polygon(mesh.degree(), 2, {&polygon[0].x, 2 * polygon.size()}, double(s) / parts, {&here.x, 2});
        segments_.push_back({before, here});
        before = here;
      }
    }
  }

  /// By winding number; empty where p is too near to tell.
  std::optional<bool> contains(const Point& p) const {
    int turns = 0;
    for (const auto& [a, b] : segments_) {
      const Vector along = b - a;
      const double s = std::clamp(dot(p - a, along) / std::max(squared_length(along), 1e-300), 0.0, 1.0);
      if (distance(p, a + s * along) <= 2 * margin_) return std::nullopt;
      if (a.y <= p.y && b.y > p.y) turns += orient2d(a, b, p) > 0;
      if (a.y > p.y && b.y <= p.y) turns -= orient2d(a, b, p) < 0;
    }
    return turns != 0;
  }

 private:
  struct Segment {
    Point a, b;
  };
  std::vector<Segment> segments_;
  double margin_ = 0;
};

/// All elements that contain p, one by one.
std::vector<TriangleId> containing(const Mesh& mesh, const Point& p) {
  std::vector<TriangleId> found;
  std::vector<Point> net(index(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    const ElementSearch search = find_in_element(mesh.degree(), net, p, 1e-14 * mesh.size());
    REQUIRE(search.answer != SearchAnswer::undecided);
    if (search.answer == SearchAnswer::found) found.push_back(t);
  }
  return found;
}

bool is_same(const std::optional<Location>& a, const std::optional<Location>& b) {
  return a.has_value() == b.has_value() && (!a || (a->triangle == b->triangle && a->xi == b->xi));
}

void check_location(const Mesh& mesh, const Point& p, const std::optional<Location>& found) {
  REQUIRE(found);
  REQUIRE(mesh.is_alive(found->triangle));
  CHECK(std::ranges::min(found->xi) >= -1e-12);
  CHECK(distance(image(mesh, found->triangle, found->xi), p) <= 1e-12 * mesh.size());
}

}  // namespace

TEST_CASE("every point of every element is found, from any hint, and always in the same element", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    Locator locator(mesh);
    for (int k = 0; k < 300; ++k) {
      const TriangleId t = random.integer(0, mesh.triangle_slots() - 1);
      const Barycentric xi = random.barycentric();
      const Point p = image(mesh, t, xi);
      CAPTURE(k, t, xi);
      const auto found = locator.find(p, t);
      check_location(mesh, p, found);
      CHECK(found->triangle == t);
      CHECK(is_same(locator.find(p), found));
      CHECK(is_same(Locator(mesh).find(p), found));
      CHECK(is_same(Locator(mesh).find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
      CHECK(is_same(locator.find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
      for (const TriangleId wrong : {-7, mesh.triangle_slots(), std::numeric_limits<TriangleId>::max()})
        CHECK(is_same(locator.find(p, wrong), found));
    }
  }
}

TEST_CASE("points on edges and vertices, or next to them, are found in the least of the elements there",
          "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    Locator locator(mesh);
    for (int k = 0; k < 150; ++k) {
      const TriangleId t = random.integer(0, mesh.triangle_slots() - 1);
      const int e = random.integer(0, 2);
      Barycentric xi{0, 0, 0};
      xi[index(e)] = k % 3 == 0 ? 1 : random.real(0, 1);
      xi[index((e + 1) % 3)] = 1 - xi[index(e)];
      const Point on = image(mesh, t, xi);
      const bool is_inner = mesh.twin(half_edge(t, e)) != none && k % 3 != 0;
      for (const double off : {0.0, 1e-15, 1e-13, 1e-12}) {
        const double angle = random.real(0, 6.28);
        const Point p = on + off * mesh.size() * Point{std::cos(angle), std::sin(angle)};
        CAPTURE(k, t, xi, off);
        const auto found = locator.find(p, t);
        if (!found && !is_inner && off > 0) continue;  // within 1e-12 of the outer boundary both are right
        check_location(mesh, p, found);
        CHECK(is_same(Locator(mesh).find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
        const std::vector<TriangleId> all = containing(mesh, p);
        CHECK(std::ranges::count(all, found->triangle) == 1);
        if (off == 0 && found->triangle != t) CHECK(found->triangle == all.front());
      }
    }
  }
}

TEST_CASE("inside and outside are what the outer boundary says", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    const OuterPolygon outer(mesh);
    Random random(degree);
    Locator locator(mesh);
    const Box box = mesh.box();
    int inside = 0, beyond = 0;
    for (int k = 0; k < 1000; ++k) {
      const Point p{random.real(box.low.x - 0.1, box.high.x + 0.1), random.real(box.low.y - 0.1, box.high.y + 0.1)};
      const std::optional<bool> expected = outer.contains(p);
      if (!expected) continue;
      CAPTURE(k, p.x, p.y);
      const auto found = locator.find(p, random.integer(0, mesh.triangle_slots() - 1));
      REQUIRE(found.has_value() == *expected);
      if (found) check_location(mesh, p, found);
      ++(found ? inside : beyond);
      if (k % 20 > 0) continue;
      const std::vector<TriangleId> all = containing(mesh, p);
      CHECK(all.size() == index(*expected));
      if (found) CHECK(all.front() == found->triangle);
    }
    CHECK(inside > 20);
    CHECK(beyond > 20);
  }
}

TEST_CASE("a point just beyond the outer boundary is outside, just before it inside", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    Locator locator(mesh);
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (mesh.twin(h) != none) continue;
      const auto on_edge = [&](double s) {
        Barycentric xi{0, 0, 0};
        xi[index(edge_of(h))] = 1 - s;
        xi[index((edge_of(h) + 1) % 3)] = s;
        return image(mesh, triangle_of(h), xi);
      };
      const double s = random.real(0.1, 0.9);
      const Vector along = on_edge(s + 1e-6) - on_edge(s - 1e-6);
      const Vector outward = -perpendicular(along) / length(along);
      for (const double off : {1e-11, 1e-9, 1e-7}) {
        CAPTURE(h, s, off);
        CHECK(!locator.find(on_edge(s) + off * mesh.size() * outward, triangle_of(h)));
        check_location(mesh, on_edge(s) - off * mesh.size() * outward,
                       locator.find(on_edge(s) - off * mesh.size() * outward, triangle_of(h)));
      }
    }
  }
}

TEST_CASE("elements are found where triangles of the logical mesh are inverted", "[mesh]") {
  int inverted = 0;
  for (int seed = 0; seed < 6; ++seed) {
    Mesh mesh = meshed(samples::one_cell(2), 2, 0.1);
    shake(mesh, 200000, seed);
    REQUIRE(find_invalid(mesh).empty());
    Locator locator(mesh);
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      inverted +=
          orient2d(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2))) <= 0;
      for (const Barycentric& xi : samples::lattice(6))
        for (const TriangleId hint : {t, 0, TriangleId{none}}) {
          CAPTURE(seed, t, xi, hint);
          check_location(mesh, image(mesh, t, xi), locator.find(image(mesh, t, xi), hint));
        }
    }
  }
  CHECK(inverted > 0);
}

TEST_CASE("points are found up to a cusp, and none beside it", "[mesh]") {
  for (int degree = 3; degree < 6; ++degree) {
    const Mesh mesh = meshed(samples::crescent(0), degree);
    Locator locator(mesh);
    // The sides leave the cusp at the origin as cubics (lower: 0.6 t^2 (1 - t) in y; upper: to the left of it).
    const auto lower = [](double t) {
      return Point{1.5 * t * (1 - t) * (1 - t) + 3.6 * t * t * (1 - t) + 2 * t * t * t, 0.6 * t * t * (1 - t)};
    };
    const auto upper = [](double t) {
      return Point{1.5 * t * (1 - t) * (1 - t) + 4.8 * t * t * (1 - t) + 2 * t * t * t, 4.5 * t * t * (1 - t)};
    };
    check_location(mesh, {0, 0}, locator.find({0, 0}));
    for (const double t : {1e-1, 1e-2, 1e-3, 1e-4}) {
      CAPTURE(degree, t);
      const double x = lower(t).x;
      double low = 0, high = t;
      for (int k = 0; k < 200; ++k) (upper((low + high) / 2).x < x ? low : high) = (low + high) / 2;
      const double bottom = lower(t).y, top = upper(low).y;
      for (const double share : {0.001, 0.5, 0.999}) {
        const Point p{x, bottom + share * (top - bottom)};
        check_location(mesh, p, locator.find(p));
      }
      for (const double share : {-0.01, 1.01, 3.0}) CHECK(!locator.find({x, bottom + share * (top - bottom)}));
      CHECK(!locator.find({-x, 0}));
    }
  }
}

TEST_CASE("at a vertex where parts of the mesh touch the least of all elements is found", "[mesh]") {
  samples::MeshBuilder builder(2);
  builder.data().boundary = samples::with_faces({"hourglass"});
  std::vector<PointId> v;
  for (const Point& p : {Point{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) v.push_back(builder.add_vertex(p));
  builder.add_triangle(v[0], v[1], v[2], 0);
  builder.add_triangle(v[0], v[3], v[4], 0);
  const Mesh mesh(std::move(builder.data()));
  for (const TriangleId hint : {0, 1, TriangleId{none}}) {
    const auto found = Locator(mesh).find({0, 0}, hint);
    check_location(mesh, {0, 0}, found);
    CHECK(found->triangle == 0);
    CHECK(!Locator(mesh).find({0, 0.5}, hint));
  }
}

TEST_CASE("many points at once are found as one by one", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    const Box box = mesh.box();
    std::vector<Point> points;
    for (int k = 0; k < 300; ++k) {
      points.push_back({random.real(box.low.x, box.high.x), random.real(box.low.y, box.high.y)});
      points.push_back(mesh.point(mesh.corner(random.integer(0, mesh.triangle_slots() - 1), 0)));
    }
    points.push_back({std::nan(""), 0});
    points.push_back({1e300, -HUGE_VAL});
    points.push_back({1e300, -1e300});
    std::vector<std::optional<Location>> found(points.size()), again(points.size());
    Locator locator(mesh);
    locator.find_all(points, found);
    locator.find_all(points, again);
    for (std::size_t k = 0; k < points.size(); ++k) {
      CAPTURE(k, points[k].x, points[k].y);
      CHECK(is_same(found[k], again[k]));
      CHECK(is_same(found[k], Locator(mesh).find(points[k])));
    }
  }
  const Mesh mesh;
  Locator locator(mesh);
  locator.find_all({}, {});
  CHECK(!locator.find({0, 0}));
}

TEST_CASE("a walk from far along a band of many triangles ends early, and the point is found all the same", "[mesh]") {
  constexpr int length = 4000;
  samples::MeshBuilder builder(2);
  builder.data().boundary = samples::with_faces({"band"});
  std::vector<PointId> low, high;
  for (int k = 0; k <= length; ++k) {
    low.push_back(builder.add_vertex({double(k), 0}));
    high.push_back(builder.add_vertex({double(k), 1}));
  }
  for (std::size_t k = 0; k < length; ++k) {
    builder.add_triangle(low[k], low[k + 1], high[k], 0);
    builder.add_triangle(low[k + 1], high[k + 1], high[k], 0);
  }
  const Mesh mesh(std::move(builder.data()));
  Locator locator(mesh);
  const Point p{length - 0.4, 0.3};
  CHECK(!locator.walk(p, 0));
  check_location(mesh, p, locator.find(p, 0));
  check_location(mesh, p, Locator(mesh).find(p));
}

TEST_CASE("what is not a number or far away is outside; where the mesh lies does not matter", "[mesh]") {
  MeshData data = samples::disk(3);
  for (const double shift : {0.0, 1e3, 1e6}) {
    MeshData moved = data;
    for (Point& p : moved.points) p += {shift, -shift};
    const Mesh mesh(std::move(moved));
    Locator locator(mesh);
    const double infinite = HUGE_VAL, largest = std::numeric_limits<double>::max();
    for (const Point& p : {Point{std::nan(""), 0},
                           {0, std::nan("")},
                           {infinite, 0},
                           {-infinite, infinite},
                           {largest, largest},
                           {-largest, 0},
                           {shift + 1.5, -shift}})
      CHECK(!locator.find(p, 0));
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
      for (const Barycentric& xi : samples::lattice(4)) {
        const Point p = image(mesh, t, xi);
        const auto found = locator.find(p);
        REQUIRE(found);
        CHECK(distance(image(mesh, found->triangle, found->xi), p) <= 1e-12 * mesh.size() + 1e-15 * shift);
      }
  }
}

TEST_CASE("free slots are no elements, and no hints", "[mesh]") {
  Mesh mesh(samples::disk(2));
  std::vector<PointId> added;
  for (TriangleId t = 0, count = mesh.triangle_slots(); t < count; ++t)
    added.push_back(insert_point(mesh, t, {0.3, 0.3, 0.4}).vertex);
  for (const PointId v : added) REQUIRE(remove_inner_vertex(mesh, v) == Outcome::done);
  REQUIRE(mesh.triangle_count() < mesh.triangle_slots());
  Locator locator(mesh);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Point p{0.6 * std::cos(t), 0.6 * std::sin(t)};
    check_location(mesh, p, locator.find(p, t));
    check_location(mesh, p, Locator(mesh).find(p, t));
    check_location(mesh, p, Locator(mesh).find(p));
  }
}

TEST_CASE("points on and beside inner edges are found 1e9 widths from the origin, too", "[mesh][locate]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(samples::disk(degree, 8, {2e9, -1e9}));
  Locator locator(mesh);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int e = 0; e < 3; ++e) {
      if (mesh.twin(half_edge(t, e)) == none) continue;
      for (int k = 0; k <= 20; ++k) {
        Barycentric xi{};
        xi[index(e)] = 0.05 + 0.045 * k;
        xi[index((e + 1) % 3)] = 1 - xi[index(e)];
        const Point p = image(mesh, t, xi);
        const auto found = locator.find(p, t);
        REQUIRE(found);
        CHECK(distance(image(mesh, found->triangle, found->xi), p) <= mesh.tolerance());
      }
    }
}

TEST_CASE("a mesh far from the origin has no faults, moved by more than its rounding it has", "[mesh][check]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const double offset = GENERATE(1e3, 1e6, 2e9);
  CAPTURE(degree, offset);
  MeshData data = samples::disk(degree, 8, {offset, offset / 3});
  CHECK(check_structure(data).empty());
  const double unit = offset * 0x1p-52;
  data.points[index(data.constrained_edges[0].points[0])].x += 64 * unit;
  if (64 * unit > 1e-11) CHECK_FALSE(check_structure(data).empty());
}
