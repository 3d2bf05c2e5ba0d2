// tests/geometry/placement_programs_test.cpp: the two programs that optimal placement solves find the optimum.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "pliant/geometry/placement/affine_program.h"
#include "pliant/geometry/placement/disk_program.h"

namespace {
using namespace pliant;

template <class Function>
double least_at(const std::vector<Function>& functions, const Point& q) {
  double least = HUGE_VAL;
  for (const Function& f : functions) least = std::min(least, f(q));
  return least;
}

/// The greatest least value in a square, by a grid that closes in on its best point.
template <class Function>
double searched(const std::vector<Function>& functions, double reach) {
  Point centre;
  double half = reach, best = least_at(functions, centre);
  for (int round = 0; round < 60; ++round) {
    Point next = centre;
    for (int i = -12; i <= 12; ++i)
      for (int j = -12; j <= 12; ++j) {
        const Point q{std::clamp(centre.x + half * i / 12, -reach, reach),
                      std::clamp(centre.y + half * j / 12, -reach, reach)};
        if (const double value = least_at(functions, q); value > best) {
          best = value;
          next = q;
        }
      }
    half *= next == centre ? 0.5 : 0.8;
    centre = next;
  }
  return best;
}

}  // namespace

TEST_CASE("the greatest least affine function is found, with a proof", "[geometry][property]") {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    std::vector<AffineFunction> functions(1 + random() % 40);
    // Every other time there are only few slopes, so that optima are not unique.
    for (AffineFunction& f : functions)
      f = trial % 2
              ? AffineFunction{unit(random), unit(random), unit(random)}
              : AffineFunction{std::round(unit(random)), std::round(unit(random)), std::round(4 * unit(random)) / 4};
    const AffineOptimum best = maximise_least(functions, 3);
    CHECK(std::max(std::fabs(best.place.x), std::fabs(best.place.y)) <= 3 + 1e-12);
    CHECK(best.value == Approx(least_at(functions, best.place)).margin(1e-10));
    CHECK(best.value >= searched(functions, 3.0) - 1e-9);
    if (!best.bounded) continue;
    AffineFunction mean{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      if (best.share[i] <= 1e-9) continue;
      REQUIRE(best.active[i] >= 0);
      const AffineFunction& f = functions[static_cast<std::size_t>(best.active[i])];
      mean = {mean.a + best.share[i] * f.a, mean.b + best.share[i] * f.b, mean.c + best.share[i] * f.c};
    }
    CHECK(mean.a == Approx(0).margin(1e-8));
    CHECK(mean.b == Approx(0).margin(1e-8));
    CHECK(mean.c == Approx(best.value).margin(1e-8));
  }
}

TEST_CASE("if there are several optima, the nearest to the origin is taken", "[geometry]") {
  // In the strip |x - 1| <= 0.5 all places are equally good.
  const std::vector<AffineFunction> strip{{1, 0, -0.5}, {-1, 0, 1.5}};
  const AffineOptimum best = maximise_least(strip, 4);
  CHECK(best.value == Approx(0.5));
  CHECK(best.place.x == Approx(1));
  CHECK(best.place.y == Approx(0).margin(1e-9));
  const std::vector<AffineFunction> constant{{0, 0, 2}};
  CHECK(maximise_least(constant, 4).place == Point{0, 0});
}

TEST_CASE("the greatest least shape is found", "[geometry][property]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const double spread = trial % 3 == 0 ? 0.1 : trial % 3 == 1 ? 0.5 : 1;
    std::vector<ShapeFunction> functions;
    for (auto n = 1 + random() % 20; n > 0; --n) {
      const Point q = spread * Point{unit(random), unit(random)};
      const double angle = 3.14 * unit(random), size = std::exp(2 * unit(random));
      const Vector v = size * Vector{std::cos(angle), std::sin(angle)};
      functions.push_back({q - (1 + 0.5 * unit(random)) * v, v});
    }
    const auto best = maximise_least(functions);
    const double expected = std::max(0.0, searched(functions, 3.0));
    CHECK((best ? best->value : 0) >= expected - 1e-9);
    if (best) CHECK(best->value == Approx(least_at(functions, best->place)));
  }
}

TEST_CASE("shapes that point in opposite directions have no good place in common", "[geometry]") {
  const std::vector<ShapeFunction> opposite{{{0, 0}, {1, 0}}, {{-3, 0}, {-1, 0}}};
  CHECK_FALSE(maximise_least(opposite));
}
