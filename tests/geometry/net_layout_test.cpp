// tests/geometry/net_layout_test.cpp: control points are in the documented order, at every degree.
#include "pliant/geometry/net_layout.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace pliant;

TEST_CASE("a net of degree 2 is in the documented order 200 020 002 110 011 101", "[geometry]") {
  const NetLayout& layout = NetLayout::of(2);
  const std::array<std::array<int, 3>, 6> expected{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};
  for (int n = 0; n < 6; ++n) CHECK(layout.exponents(n) == expected[static_cast<std::size_t>(n)]);
}

TEST_CASE("interior entries descend by i, then by j", "[geometry]") {
  const NetLayout& layout = NetLayout::of(5);
  for (int n = layout.first_interior() + 1; n < layout.size(); ++n) {
    const auto& before = layout.exponents(n - 1);
    const auto& here = layout.exponents(n);
    CHECK((before[0] > here[0] || (before[0] == here[0] && before[1] > here[1])));
  }
}

TEST_CASE("a layout lists every exponent once and finds it again", "[geometry]") {
  for (int p = 0; p <= max_net_degree; ++p) {
    const NetLayout& layout = NetLayout::of(p);
    REQUIRE(layout.degree() == p);
    REQUIRE(layout.size() == net_size(p));
    std::set<std::array<int, 3>> seen;
    for (int n = 0; n < layout.size(); ++n) {
      const auto& e = layout.exponents(n);
      CHECK(e[0] + e[1] + e[2] == p);
      CHECK(layout.index(e[0], e[1]) == n);
      seen.insert(e);
    }
    CHECK(seen.size() == static_cast<std::size_t>(layout.size()));
    if (p > 0) CHECK(layout.size() - layout.first_interior() == interior_size(p));
  }
}

TEST_CASE("an edge's entries run from its first to its second corner", "[geometry]") {
  for (int p = 1; p <= max_degree; ++p) {
    const NetLayout& layout = NetLayout::of(p);
    for (int e = 0; e < 3; ++e) {
      for (int k = 0; k <= p; ++k) {
        std::array<int, 3> expected{0, 0, 0};
        expected[static_cast<std::size_t>(e)] = p - k;
        expected[static_cast<std::size_t>((e + 1) % 3)] = k;
        CHECK(layout.exponents(layout.edge_index(e, k)) == expected);
      }
    }
  }
}

TEST_CASE("the multinomials of degree p sum to 3^p", "[geometry]") {
  for (int p = 0; p <= 33; ++p) {  // 3^33 < 2^53
    const NetLayout& layout = NetLayout::of(p);
    double sum = 0;
    for (int n = 0; n < layout.size(); ++n) sum += layout.multinomial(n);
    CHECK(sum == std::pow(3.0, p));
  }
}
