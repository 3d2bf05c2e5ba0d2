// tests/boundary/least_gap_test.cpp: gaps as closed forms and dense sampling find them; what is no gap.
#include "pliant/boundary/least_gap.h"

#include <catch2/catch.hpp>
#include <functional>
#include <numbers>
#include <random>

#include "pliant/geometry/spline/bspline.h"

using namespace pliant;

namespace {

constexpr double pi = std::numbers::pi;
using Path = std::function<Point(double)>;  // from [0, 1]

/// Curves cut into edges of one degree, each of which interpolates a path.
class Edges {
 public:
  explicit Edges(int degree) : degree_(degree) {}

  /// A closed path gets one vertex more than it has edges; `from` and `to` join an open one to vertices.
  void add(const Path& path, int spans, bool closed, int from = -1, int to = -1) {
    const int first = from >= 0 ? from : next_vertex_++;
    const int last = closed ? first : to >= 0 ? to : next_vertex_++;
    for (int k = 0; k < spans; ++k) {
      const int start = k == 0 ? first : next_vertex_ - 1;
      const int end = k + 1 == spans ? last : next_vertex_++;
      polygons_.push_back(interpolate(path, static_cast<double>(k) / spans, (k + 1.0) / spans));
      ends_.push_back({start, end});
      curves_.push_back(curve_count_);
    }
    ++curve_count_;
  }
  int new_vertex() { return next_vertex_++; }

  std::vector<GapEdge> all() const {
    std::vector<GapEdge> edges;
    for (std::size_t e = 0; e < polygons_.size(); ++e)
      edges.push_back({polygons_[e], curves_[e], ends_[e].first, ends_[e].second});
    return edges;
  }
  std::optional<Gap> gap(double below) const { return find_least_gap(all(), below); }

 private:
  std::vector<Point> interpolate(const Path& path, double from, double to) const {
    std::vector<double> knots(static_cast<std::size_t>(degree_) + 1, from);
    knots.insert(knots.end(), static_cast<std::size_t>(degree_) + 1, to);
    BSpline curve(degree_, false, knots, std::vector<Point>(static_cast<std::size_t>(degree_) + 1));
    std::vector<Point> values;
    for (const double t : curve.greville()) values.push_back(path(t));
    REQUIRE(curve.interpolate(values));
    return {curve.points().begin(), curve.points().end()};
  }
  int degree_, next_vertex_ = 0, curve_count_ = 0;
  std::vector<std::vector<Point>> polygons_;
  std::vector<std::pair<int, int>> ends_;
  std::vector<int> curves_;
};

Path ellipse(Point center, double a, double b, double from = 0, double to = 2 * pi) {
  return [=](double t) {
    const double angle = from + t * (to - from);
    return center + Vector{a * std::cos(angle), b * std::sin(angle)};
  };
}
Path line(Point from, Point to) {
  return [=](double t) { return from + t * (to - from); };
}

Point at(std::span<const Point> polygon, double t) {
  std::vector<Point> row(polygon.begin(), polygon.end());
  for (std::size_t n = row.size() - 1; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) row[k] = (1 - t) * row[k] + t * row[k + 1];
  return row[0];
}

}  // namespace

TEST_CASE("the gap between two circles is that between their centres, less the radii", "[boundary]") {
  const int degree = GENERATE(2, 3, 5);
  CAPTURE(degree);
  const double turn = GENERATE(0.0, 0.3, 1.0);
  Edges edges(degree);
  edges.add(ellipse({0, 0}, 1, 1, turn, turn + 2 * pi), 64, true);
  edges.add(ellipse({1.6, 1.2}, 0.9, 0.9), 48, true);
  const auto gap = edges.gap(0.2);
  REQUIRE(gap);
  CHECK(gap->distance == Approx(0.1).margin(1e-4));  // the edges are as near to the circles
  CHECK(distance(gap->place, {0.8, 0.6}) < 5e-2);
  CHECK(distance(gap->place, gap->other) == Approx(gap->distance));
  CHECK(gap->first < 64);
  CHECK(gap->second >= 64);
  CHECK_FALSE(edges.gap(0.0999));
}

TEST_CASE("the gap between a tilted ellipse and a line is the closed form", "[boundary]") {
  // The support of the ellipse in the direction of the normal n is sqrt((a n1)^2 + (b n2)^2).
  const double angle = GENERATE(0.0, 0.4, 1.1, 2.0);
  CAPTURE(angle);
  const Vector normal{std::cos(angle), std::sin(angle)}, along = perpendicular(normal);
  const double support = std::hypot(2 * normal.x, 0.7 * normal.y);
  Edges edges(4);
  edges.add(ellipse({0, 0}, 2, 0.7), 96, true);
  const Point foot = (support + 0.05) * normal;
  edges.add(line(foot - 5 * along, foot + 5 * along), 7, false);
  const auto gap = edges.gap(0.1);
  REQUIRE(gap);
  CHECK(gap->distance == Approx(0.05).margin(1e-7));
}

TEST_CASE("a curve that bends back to itself has a gap with itself, whatever its edges", "[boundary]") {
  const int spans = GENERATE(4, 7, 40);
  CAPTURE(spans);
  // A bow whose ends come near to each other.
  Edges edges(3);
  edges.add(ellipse({0, 0}, 1, 1, 0.05, 2 * pi - 0.05), spans, false);
  const auto gap = edges.gap(0.2);
  REQUIRE(gap);
  CHECK(gap->distance == Approx(2 * std::sin(0.05)).margin(1e-9));
}

TEST_CASE("one edge that bends back to itself has a gap with itself", "[boundary]") {
  // A hairpin whose legs have a neck: the nearest places face each other across it.
  const std::vector<Point> hairpin{{0, 0.2}, {3, -0.3}, {4, 0}, {3, 0.35}, {0, -0.15}};
  const std::vector<Point> loop{{0, 0.1}, {3, -1}, {0.3, 2}, {0.3, -2}, {3, 1}, {0, -0.1}};
  for (const std::vector<Point>& polygon : {loop, hairpin}) {
    const std::vector<GapEdge> edges{{polygon, 0, 0, 1}};
    const auto gap = find_least_gap(edges, 0.3);
    REQUIRE(gap);
    CHECK(distance(at(polygon, gap->s), gap->place) < 1e-12);
    CHECK(distance(at(polygon, gap->t), gap->other) < 1e-12);
  }
}

TEST_CASE("the gap of two curves is what dense sampling finds", "[boundary][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 60));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  const int degree = 1 + static_cast<int>(seed % 6);
  std::vector<Point> a, b;
  for (int k = 0; k <= degree; ++k) {
    a.push_back({place(random), place(random)});
    b.push_back({place(random) + 0.2, place(random) + 0.9 * (seed % 3 == 0 ? 0.5 : 1)});
  }
  constexpr int samples = 600;
  std::vector<Point> on_a, on_b;
  for (int i = 0; i <= samples; ++i) {
    on_a.push_back(at(a, static_cast<double>(i) / samples));
    on_b.push_back(at(b, static_cast<double>(i) / samples));
  }
  double least = HUGE_VAL;
  for (const Point& p : on_a)
    for (const Point& q : on_b) least = std::min(least, distance(p, q));
  // A curve of degree above 2 may meet itself, which is not asked here: one search for both, one for each.
  const std::vector<GapEdge> both{{a, 0, 0, 1}, {b, 1, 2, 3}};
  const auto gap = find_least_gap(both, 3);
  REQUIRE(gap);
  if (gap->first != gap->second) {
    CHECK(gap->distance <= least);
    CHECK(gap->distance >= least - 0.02);
    CHECK(distance(at(a, gap->s), at(b, gap->t)) == Approx(gap->distance).margin(1e-12));
  } else {
    CHECK(gap->distance <= least);
  }
}

TEST_CASE("the gap of two wavy bodies is what dense sampling finds, whatever the bound", "[boundary][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 40));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const int degree = 2 + static_cast<int>(seed % 3);
  const auto wavy = [&](Point center) {
    const double a = 0.1 * unit(random), b = 2 * pi * unit(random), c = 0.03 * unit(random), d = 2 * pi * unit(random);
    return [=](double t) {
      const double angle = 2 * pi * t, r = 1 + a * std::sin(3 * angle + b) + c * std::sin(7 * angle + d);
      return center + r * Vector{std::cos(angle), std::sin(angle)};
    };
  };
  Edges edges(degree);
  edges.add(wavy({0, 0}), 60, true);
  edges.add(wavy({2.35, 0.3 * unit(random)}), 45, true);
  const std::vector<GapEdge> all = edges.all();
  std::vector<Point> points[2];
  for (const GapEdge& edge : all)
    for (int i = 0; i < 20; ++i) points[edge.curve].push_back(at(edge.polygon, i / 20.0));
  double least = HUGE_VAL;
  for (const Point& p : points[0])
    for (const Point& q : points[1]) least = std::min(least, distance(p, q));
  for (const double below : {1.01 * least, 1.0, 30.0}) {
    const auto gap = edges.gap(below);
    REQUIRE(gap);
    CHECK(gap->distance <= least * (1 + 1e-5));
    CHECK(gap->distance >= least - 1e-3);
    CHECK(all[static_cast<std::size_t>(gap->first)].curve != all[static_cast<std::size_t>(gap->second)].curve);
  }
}

TEST_CASE("neither a smooth curve nor a wedge or a cusp at a common vertex is a gap", "[boundary]") {
  const int spans = GENERATE(2, 3, 5, 40);
  const int degree = GENERATE(2, 3);
  const double below = GENERATE(0.01, 0.5, 5.0);
  CAPTURE(spans, degree, below);
  SECTION("a circle as one curve") {
    Edges edges(degree);
    edges.add(ellipse({0, 0}, 1, 1), std::max(spans, 3), true);
    CHECK_FALSE(edges.gap(below));
  }
  SECTION("a circle as two curves") {
    Edges edges(degree);
    const int a = edges.new_vertex(), b = edges.new_vertex();
    edges.add(ellipse({0, 0}, 1, 1, 0, pi), spans, false, a, b);
    edges.add(ellipse({0, 0}, 1, 1, pi, 2 * pi), spans, false, b, a);
    CHECK_FALSE(edges.gap(below));
  }
  SECTION("wedges") {
    for (const double angle : {0.02, 0.3, 1.0, 2.0}) {
      CAPTURE(angle);
      Edges edges(degree);
      const int tip = edges.new_vertex();
      edges.add(line({0, 0}, {1, 0}), spans, false, tip);
      edges.add(line({0, 0}, {std::cos(angle), std::sin(angle)}), spans, false, tip);
      CHECK_FALSE(edges.gap(below));
    }
  }
  SECTION("a cusp") {
    Edges edges(degree);
    const int tip = edges.new_vertex();
    edges.add(line({0, 0}, {1, 0}), spans, false, tip);
    edges.add([](double t) { return Point{t, t * t / 2}; }, spans, false, tip);
    CHECK_FALSE(edges.gap(below));
  }
  SECTION("a polygon with sharp teeth on one curve") {
    Edges edges(degree);
    const auto zigzag = [](double t) { return Point{t, std::fabs(std::fmod(20 * t, 2) - 1)}; };
    edges.add(zigzag, 20, false);
    CHECK_FALSE(edges.gap(std::min(below, 0.05)));
  }
}

TEST_CASE("a neck behind a corner is a gap of curves with a common vertex", "[boundary]") {
  const int spans = GENERATE(1, 2, 9);
  CAPTURE(spans);
  Edges edges(4);
  const int tip = edges.new_vertex();
  edges.add(line({0, 0}, {2, 0}), spans, false, tip);
  const auto height = [](double t) { return 4 * t * (std::pow(t - 0.6, 2) + 0.02); };
  edges.add([height](double t) { return Point{2 * t, height(t)}; }, spans, false, tip);
  const auto gap = edges.gap(0.1);
  REQUIRE(gap);
  double least = HUGE_VAL;
  for (int i = 800; i <= 2000; ++i) least = std::min(least, height(i / 2000.0));
  CHECK(gap->distance == Approx(least).margin(1e-6));
}

TEST_CASE("the middle of a thin body is a gap, whether its outline is one curve or two", "[boundary]") {
  const int spans = GENERATE(6, 30, 90);
  CAPTURE(spans);
  Edges one(4), two(4);
  one.add(ellipse({0, 0}, 1, 0.01, 0.3, 0.3 + 2 * pi), spans, true);
  const int a = two.new_vertex(), b = two.new_vertex();
  two.add(ellipse({0, 0}, 1, 0.01, 0, pi), spans, false, a, b);
  two.add(ellipse({0, 0}, 1, 0.01, pi, 2 * pi), spans, false, b, a);
  for (const Edges* edges : {&one, &two}) {
    const auto gap = edges->gap(0.05);
    REQUIRE(gap);
    CHECK(gap->distance == Approx(0.02).epsilon(spans == 6 ? 0.1 : 1e-3));
    CHECK_FALSE(edges->gap(0.015));
  }
}

TEST_CASE("curves that cross have a gap of 0; a corner that juts at a wall has its distance", "[boundary]") {
  Edges cross(2);
  cross.add(ellipse({0, 0}, 1, 1), 12, true);
  cross.add(line({0, 0}, {3, 0.5}), 3, false);
  const auto crossing = cross.gap(0.01);
  REQUIRE(crossing);
  CHECK(crossing->distance < 1e-10);

  Edges corner(2);
  const int tip = corner.new_vertex();
  corner.add(line({0, 0.04}, {1, 1}), 3, false, tip);
  corner.add(line({0, 0.04}, {-1, 0.5}), 3, false, tip);
  corner.add(line({-2, 0}, {2, 0}), 5, false);
  const auto jut = corner.gap(0.1);
  REQUIRE(jut);
  CHECK(jut->distance == Approx(0.04));
  CHECK(jut->place == Point{0, 0.04});
}
