// tests/boundary/curve_contact_test.cpp: Bézier curves that meet are told from curves that only come close.
#include "pliant/boundary/curve_contact.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace pliant;
using ControlPolygon = std::vector<Point>;

namespace {

std::optional<Contact> contact(const ControlPolygon& a, const ControlPolygon& b, int a0 = 0, int a1 = 1, int b0 = 2,
                               int b1 = 3) {
  return find_contact({a, a0, a1}, {b, b0, b1});
}

template <class... Nodes>
bool meets(const ControlPolygon& a, const ControlPolygon& b, Nodes... nodes) {
  return contact(a, b, nodes...).has_value();
}

bool meets_itself(const ControlPolygon& curve) { return find_self_contact({curve, 0, 1}).has_value(); }

Point at(const ControlPolygon& curve, double s) {
  ControlPolygon work = curve;
  for (std::size_t r = work.size() - 1; r > 0; --r)
    for (std::size_t i = 0; i < r; ++i) work[i] = (1 - s) * work[i] + s * work[i + 1];
  return work[0];
}

}  // namespace

TEST_CASE("two curves that cross meet where they cross", "[boundary]") {
  const ControlPolygon a{{0, 0}, {1, 2}, {2, 0}}, b{{0, 0.5}, {2, 0.5}};
  const auto found = contact(a, b);
  REQUIRE(found);
  CHECK(found->kind == Contact::Kind::meets);
  CHECK(distance(at(a, found->s), found->place) < 1e-9);
  CHECK(distance(at(b, found->t), found->place) < 1e-9);
}

TEST_CASE("a tangent line meets a parabola, a parallel one a hair beyond it does not", "[boundary]") {
  const ControlPolygon a{{0, 0}, {1, 2}, {2, 0}};
  CHECK(meets(a, {{0, 1}, {2, 1}}));
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-11}) {
    CAPTURE(gap);
    CHECK_FALSE(meets(a, {{0, 1 + gap}, {2, 1 + gap}}));
    CHECK(meets(a, {{0, 1 - gap}, {2, 1 - gap}}));
  }
}

TEST_CASE("concentric arcs close to each other are apart", "[boundary]") {
  const double gap = GENERATE(1e-2, 1e-5, 1e-8, 1e-10);
  CAPTURE(gap);
  const ControlPolygon inner{{1, 0}, {1, 1}, {0, 1}};
  ControlPolygon outer = inner;
  for (Point& p : outer) p = (1 + gap) * p;
  CHECK_FALSE(meets(inner, outer));
}

TEST_CASE("a curve laid over another meets it", "[boundary]") {
  const ControlPolygon a{{0, 0}, {1, 2}, {2, 0}};
  CHECK(meets(a, a));
  ControlPolygon back(a.rbegin(), a.rend());
  CHECK(meets(a, back));
  // Also where they have their ends in common.
  CHECK(meets(a, a, 0, 1, 0, 1));
  CHECK(meets(a, back, 0, 1, 1, 0));
}

TEST_CASE("curves that leave a common end under an angle above 1e-9 meet only there", "[boundary]") {
  const double angle = GENERATE(3.0, 1.0, 1e-2, 1e-5, 1e-8);
  const bool curved = GENERATE(false, true);
  CAPTURE(angle, curved);
  // The second one bends away from the first.
  const ControlPolygon a{{0, 0}, {1, 0}, {2, curved ? -0.3 : 0.0}};
  const ControlPolygon b{{0, 0}, {std::cos(angle), std::sin(angle)}, {2 * std::cos(angle), 2 * std::sin(angle)}};
  CHECK_FALSE(meets(a, b, 0, 1, 0, 2));
  CHECK_FALSE(meets(ControlPolygon(a.rbegin(), a.rend()), b, 1, 0, 0, 2));
}

TEST_CASE("curves that leave a common end and meet again are found", "[boundary]") {
  const double bulge = GENERATE(1.0, 1e-3, 1e-6);
  CAPTURE(bulge);
  CHECK(meets({{0, 0}, {1, bulge}, {2, 0}, {3, -bulge}}, {{0, 0}, {3, 0}}, 0, 1, 0, 2));
}

TEST_CASE("curves that leave a common end in the same direction turn back", "[boundary]") {
  const auto found = contact({{0, 0}, {1, 0}, {2, 1}}, {{0, 0}, {1, 0}, {2, 0.5}}, 7, 1, 7, 2);
  REQUIRE(found);
  CHECK(found->kind == Contact::Kind::turns_back);
  CHECK(found->node == 7);
}

TEST_CASE("a long line and a short arc that ends tangent to it do not meet elsewhere", "[boundary]") {
  const ControlPolygon line{{301.33659, -504.93182}, {342.31228000000004, -504.93182}};
  const ControlPolygon arc{{340.7043401394884, -504.93318453469453},
                           {341.4835058445234, -504.9318200000001},
                           {342.31228000000004, -504.93182}};
  const auto found = contact(line, arc, 0, 1, 2, 1);
  CHECK((!found || found->kind == Contact::Kind::turns_back));
}

TEST_CASE("loops, cusps and stops of a single curve are found, and bends are not taken for them", "[boundary]") {
  CHECK_FALSE(meets_itself({{0, 0}, {1, 2}, {2, 0}}));
  const auto loop = find_self_contact({ControlPolygon{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}, 0, 1});
  REQUIRE(loop);
  CHECK(loop->kind == Contact::Kind::meets);
  const auto cusp = find_self_contact({ControlPolygon{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, 0, 1});
  REQUIRE(cusp);
  CHECK(cusp->kind == Contact::Kind::turns_back);
  CHECK(meets_itself({{0, 0}, {0, 0}, {1, 1}}));  // no speed at the start
  CHECK(meets_itself({{0, 0}, {2, 0}, {1, 0}}));  // back along itself
  CHECK_FALSE(meets_itself({{0, 0}, {1, 1}, {1, 1}, {2, 3}}));
}

TEST_CASE("random curves meet if and only if their fine polygons do", "[boundary][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 40));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(0, 1);
  const std::size_t count = 2 + seed % 4;
  ControlPolygon a(count), b(count);
  for (ControlPolygon* curve : {&a, &b})
    for (Point& p : *curve) p = {u(random), u(random)};
  double nearest = HUGE_VAL;
  bool crosses = false;
  const int n = 400;
  const auto side = [](const Point& p, const Point& q, const Point& r) { return cross(q - p, r - p); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point p = at(a, double(i) / n), q = at(a, double(i + 1) / n);
      const Point r = at(b, double(j) / n), s = at(b, double(j + 1) / n);
      nearest = std::min(nearest, distance(p, r));
      crosses |= side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
    }
  if (crosses) CHECK(meets(a, b));
  if (!crosses && nearest > 0.02) CHECK_FALSE(meets(a, b));
}

TEST_CASE("even curves whose differences overflow get an answer", "[boundary]") {
  const double huge = 1.7e308;
  const std::vector<ControlPolygon> curves{{{0, 0}, {huge, 0}},
                                           {{huge, 0}, {0, 1}},
                                           {{-huge, 0}, {huge, huge}},
                                           {{-huge, -huge}, {huge, huge}, {-huge, huge}, {huge, -huge}},
                                           {{0x1p-1074, 0}, {0, 0x1p-1074}, {0, 0}}};
  for (const ControlPolygon& a : curves)
    for (const ControlPolygon& b : curves) {
      (void)contact(a, b);
      (void)contact(a, b, 0, 1, 0, 3);  // from a common end
      (void)contact(a, b, 0, 1, 1, 0);
      (void)meets_itself(a);
    }
  SUCCEED("no search without an end");
}
