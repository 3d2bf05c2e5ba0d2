// tests/quality/too_curved_test.cpp: the quick test agrees with the excess, and the excess with the measures.
#include "pliant/quality/too_curved.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/quality/element/element_quality.h"

using namespace pliant;

namespace {

using Net = std::vector<Point>;

Net random_noisy_net(int degree, double noise, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Point a{0, 0}, b{1, 0.2 * uniform(random)}, c{uniform(random), 0.6 + 0.5 * uniform(random)};
  const NetLayout& layout = NetLayout::of(degree);
  Net net;
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    net.push_back((double(i) * a + double(j) * b + double(k) * c) / degree +
                  noise / degree * Vector{uniform(random), uniform(random)});
  }
  return net;
}

}  // namespace

TEST_CASE("an element is fine if and only if its excess is at most one, also where the quick test decides",
          "[quality][property]") {
  const int degree = GENERATE(range(1, 6));
  std::mt19937_64 random(static_cast<std::uint64_t>(degree));
  std::uniform_real_distribution<double> uniform(0, 1);
  int fine = 0, curved = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Net net = random_noisy_net(degree, 0.6 * uniform(random), random);
    const double unit = std::ldexp(1, static_cast<int>(random() % 5) * 300 - 600);
    for (Point& p : net) p *= unit;
    const CurvatureBounds bounds{1 + 0.5 * uniform(random), 1.05 + uniform(random), 0.9 * uniform(random),
                                 0.1 + 3 * uniform(random), 0.8 * uniform(random)};
    const CurvatureTest test(degree, bounds);
    const double excess = test.excess(net);
    CAPTURE(degree, trial, unit, excess);
    REQUIRE(test.is_fine(net) == (excess <= 1));
    (excess <= 1 ? fine : curved) += 1;
  }
  CHECK(fine > 100);
  if (degree > 1) CHECK(curved > 100);
}

TEST_CASE("the turning of fixed edges does not count, everything else does", "[quality][property]") {
  const int degree = GENERATE(range(2, 6));
  std::mt19937_64 random(static_cast<std::uint64_t>(20 + degree));
  int differ = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Net net = random_noisy_net(degree, 0.4, random);
    CurvatureBounds tight, loose;
    tight.max_turning = 0.2;
    loose.max_turning = 1e6;
    const CurvatureTest test(degree, tight), without(degree, loose);
    CAPTURE(degree, trial);
    CHECK(test.excess(net, 7) == Approx(without.excess(net)).epsilon(1e-4));
    const auto fixed = static_cast<unsigned>(random() % 8);
    CHECK(test.excess(net, fixed) >= test.excess(net, 7) * (1 - 1e-9));
    CHECK(test.excess(net, fixed) <= test.excess(net) * (1 + 1e-9));
    if (test.is_surely_fine(net, fixed)) CHECK(test.excess(net, fixed) <= 1);
    differ += test.excess(net, fixed) < 0.999 * test.excess(net);
  }
  CHECK(differ > 50);
}

TEST_CASE("the excess is the worst measure over its bound, and a tangled element has more than any valid one",
          "[quality][property]") {
  const int degree = GENERATE(range(2, 6));
  std::mt19937_64 random(static_cast<std::uint64_t>(10 + degree));
  int tangled = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Net net = random_noisy_net(degree, 0.7, random);
    const CurvatureBounds bounds;
    const double excess = curvature_excess(degree, net, bounds);
    CAPTURE(degree, trial, excess);
    const bool is_valid = certify(degree, net) == Validity::valid;
    if (excess < tangled_excess) REQUIRE(is_valid);
    if (!is_valid) {
      ++tangled;
      CHECK(excess == Approx(tangled_excess * (1 - curved_shape(degree, net))));
      CHECK(excess <= 2 * tangled_excess);
      continue;
    }
    if (excess >= tangled_excess) continue;  // valid, but its shape is too small for the lower bound to be positive
    const double logical = std::fabs(triangle_shape(net[0], net[1], net[2]));
    const double worst = std::max(
        {(distortion(degree, net) - 1) / (bounds.max_distortion - 1), jacobian_peak(degree, net) / bounds.max_peak,
         bounds.min_shape_ratio * logical / curved_shape(degree, net),
         element_turning(degree, net) / bounds.max_turning, bounds.min_scaled_jacobian / scaled_jacobian(degree, net)});
    CHECK(excess == Approx(std::min(worst, 0.999 * tangled_excess)));
  }
  CHECK(tangled > 50);
}
