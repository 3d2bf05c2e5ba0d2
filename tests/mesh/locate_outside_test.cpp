// tests/mesh/locate_outside_test.cpp: no element is found for points outside the mesh, however near to its boundary.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/curved_samples.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/locate.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// The outer boundary as a polygon of segments, none farther from it than `margin`.
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

  /// Whether p is inside, by the winding number; empty if p is too near to the polygon to tell.
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

}  // namespace

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

TEST_CASE("points are found up to a cusp, and none beside it", "[mesh]") {
  for (int degree = 3; degree < 6; ++degree) {
    const Mesh mesh = meshed(samples::crescent(0), degree);
    Locator locator(mesh);
    // Two cubics leave the cusp at the origin: the lower side has y = 0.6 t^2 (1 - t), the upper one is left of it.
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
