// tests/generate/triangulate_boundary_test.cpp: triangulations are constrained Delaunay, and have every segment.
#include "pliant/generate/triangulate_boundary.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "pliant/geometry/predicates.h"

using namespace pliant;

namespace {

using Segment = std::array<int, 2>;

const Point& at(const std::vector<Point>& points, int v) { return points[static_cast<std::size_t>(v)]; }

/// Points of five kinds, from random to degenerate; no point comes twice.
std::vector<Point> make_points(int kind, int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(0, 1);
  std::set<std::pair<double, double>> seen;
  std::vector<Point> points;
  for (int tries = 0; static_cast<int>(points.size()) < count && tries < 100 * count; ++tries) {
    Point p{u(random), u(random)};
    if (kind == 1) p = {double(random() % 20), double(random() % 20)};  // a grid: collinear and cocircular
    if (kind == 2) p = {3.0 * double(random() % 5), 0};                 // nearly all on one line ...
    if (kind == 2 && tries % 3 == 0) p = {u(random) * 12, 0};
    if (kind == 2 && tries == 50) p = {5, 1};                    // ... but one
    if (kind == 3) p = p / std::max(1e-3, length(p));            // on a circle
    if (kind == 4) p = {1e6 + std::floor(4 * p.x), 1e-9 * p.y};  // columns far from the origin
    if (seen.insert({p.x, p.y}).second) points.push_back(p);
  }
  if (kind == 2) points.push_back({7, 2});
  return points;
}

bool cross_properly(const std::vector<Point>& points, const Segment& s, const Segment& t) {
  const auto side = [&](const Segment& a, int v) {
    return orient2d(at(points, a[0]), at(points, a[1]), at(points, v));
  };
  return side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0;
}

bool passes_through(const std::vector<Point>& points, const Segment& s, int v) {
  if (v == s[0] || v == s[1]) return false;
  const Point &a = at(points, s[0]), &b = at(points, s[1]), &p = at(points, v);
  return orient2d(a, b, p) == 0 && dot(p - a, b - a) > 0 && dot(p - b, a - b) > 0;
}

/// Random segments that neither cross nor pass through points.
std::vector<Segment> make_segments(const std::vector<Point>& points, int wanted, std::mt19937_64& random) {
  std::vector<Segment> segments;
  const int n = static_cast<int>(points.size());
  for (int tries = 0; static_cast<int>(segments.size()) < wanted && tries < 50 * wanted; ++tries) {
    const Segment s{static_cast<int>(random() % points.size()), static_cast<int>(random() % points.size())};
    bool fits = s[0] != s[1];
    for (int v = 0; v < n && fits; ++v) fits = !passes_through(points, s, v);
    for (const Segment& t : segments) fits = fits && !cross_properly(points, s, t);
    if (fits) segments.push_back(s);
  }
  return segments;
}

/// Checks by exact predicates that the triangles are the constrained Delaunay triangulation of the hull.
void check(const std::vector<Point>& points, const std::vector<Segment>& segments,
           const std::vector<std::array<int, 3>>& triangles) {
  std::map<Segment, int> apex;
  std::set<int> used;
  bool all_positive = true, is_manifold = true;
  for (const auto& t : triangles) {
    all_positive &= orient2d(at(points, t[0]), at(points, t[1]), at(points, t[2])) > 0;
    for (std::size_t e = 0; e < 3; ++e) {
      is_manifold &= apex.insert({{t[e], t[(e + 1) % 3]}, t[(e + 2) % 3]}).second;
      used.insert(t[e]);
    }
  }
  CHECK(all_positive);
  CHECK(is_manifold);
  CHECK(used.size() == points.size());

  std::set<Segment> constrained;
  bool all_present = true;
  for (const Segment& s : segments) {
    constrained.insert(s);
    constrained.insert({s[1], s[0]});
    all_present &= apex.count(s) > 0 || apex.count({s[1], s[0]}) > 0;
  }
  CHECK(all_present);

  std::size_t hull = 0;
  bool is_convex = true, is_delaunay = true;
  for (const auto& [edge, c] : apex) {
    const auto other = apex.find({edge[1], edge[0]});
    const Point &a = at(points, edge[0]), &b = at(points, edge[1]);
    if (other == apex.end()) {
      ++hull;
      for (const Point& p : points) is_convex &= orient2d(a, b, p) >= 0;
    } else if (constrained.count(edge) == 0) {
      is_delaunay &= in_circle(a, b, at(points, c), at(points, other->second)) <= 0;
    }
  }
  CHECK(is_convex);
  CHECK(is_delaunay);
  CHECK(triangles.size() == 2 * points.size() - 2 - hull);  // by Euler's formula
}

}  // namespace

TEST_CASE("triangles of any points are the Delaunay triangulation of their hull", "[generate][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 12));
  const int kind = GENERATE(0, 1, 2, 3, 4);
  CAPTURE(seed, kind);
  std::mt19937_64 random(seed);
  const std::vector<Point> points = make_points(kind, 5 + 15 * static_cast<int>(seed), random);
  check(points, {}, triangulate(points, {}));
}

TEST_CASE("every segment of a planar graph is an edge, all others are constrained Delaunay", "[generate][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  const int kind = GENERATE(0, 1, 3, 4);
  CAPTURE(seed, kind);
  std::mt19937_64 random(seed);
  const std::vector<Point> points = make_points(kind, 5 + 8 * static_cast<int>(seed), random);
  const std::vector<Segment> segments = make_segments(points, static_cast<int>(points.size()), random);
  check(points, segments, triangulate(points, segments));
}

TEST_CASE("constrained Delaunay triangles see no other point inside their circumcircles", "[generate][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 10));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const std::vector<Point> points = make_points(0, 40, random);
  const std::vector<Segment> segments = make_segments(points, 15, random);
  for (const auto& t : triangulate(points, segments))
    for (int v = 0; v < static_cast<int>(points.size()); ++v) {
      if (in_circle(at(points, t[0]), at(points, t[1]), at(points, t[2]), at(points, v)) <= 0) continue;
      std::vector<Point> more = points;  // a segment must hide v from the centroid
      more.push_back((at(points, t[0]) + at(points, t[1]) + at(points, t[2])) / 3);
      const Segment sight{static_cast<int>(points.size()), v};
      CHECK(std::any_of(segments.begin(), segments.end(),
                        [&](const Segment& s) { return cross_properly(more, s, sight); }));
    }
}

TEST_CASE("long segments through many points are found by flips", "[generate]") {
  std::mt19937_64 random(7);
  std::vector<Point> points = make_points(0, 2000, random);
  const int n = static_cast<int>(points.size());
  points.insert(points.end(), {{-1, 0.3141}, {2, 0.7182}, {-1, 0.5}, {2, 0.5000001}});
  const std::vector<Segment> segments{{n, n + 2}, {n + 2, n + 3}, {n, n + 3}};
  check(points, segments, triangulate(points, segments));
}

TEST_CASE("points on one line, or none, have no triangles", "[generate]") {
  CHECK(triangulate(std::vector<Point>{{0, 0}, {1, 1}, {3, 3}, {2, 2}}, {}).empty());
  CHECK(triangulate(std::vector<Point>{}, {}).empty());
}

TEST_CASE("points and segments that are no planar graph are refused, with the places", "[generate]") {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  const std::vector<Segment> through{{0, 2}};
  CHECK_THROWS_WITH(triangulate(square, through), Catch::Contains("through 4 (0.5"));
  std::vector<Point> twice = square;
  twice.push_back({1, 1});
  CHECK_THROWS_WITH(triangulate(twice, {}), Catch::Contains("are the same point"));
  const std::vector<Point> corners(square.begin(), square.begin() + 4);
  const std::vector<Segment> crossing{{0, 2}, {1, 3}};
  CHECK_THROWS_WITH(triangulate(corners, crossing), Catch::Contains("crosses the one from"));
  CHECK_THROWS_AS(triangulate(std::vector<Point>{{0, 0}, {1, std::nan("")}, {0, 1}}, {}), std::invalid_argument);
}

TEST_CASE("triangles of points on a grid stay the same when a shift moves all points exactly", "[generate]") {
  std::mt19937_64 random(3);
  std::vector<Point> points = make_points(1, 200, random);
  const auto before = triangulate(points, {});
  for (Point& p : points) p += Point{4096, -1024};
  CHECK(triangulate(points, {}) == before);
}

TEST_CASE("a hundred thousand points take less than a second", "[generate][.speed]") {
  std::mt19937_64 random(1);
  const int kind = GENERATE(0, 1);
  std::vector<Point> points = make_points(0, 100000, random);
  if (kind == 1)
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {double(i % 316), double(i / 316)};
  const auto start = std::chrono::steady_clock::now();
  const auto triangles = triangulate(points, {});
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 1);
  CHECK(triangles.size() > points.size());
}
