// tests/geometry/quadrature_test.cpp: rules integrate every monomial of their degree.
#include "pliant/geometry/quadrature.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/geometry/symmetric_rule.h"

using namespace pliant;

namespace {

/// The integral of xi1^a xi2^b xi3^c over the unit right triangle, a! b! c! / (a + b + c + 2)!.
double exact_integral(int a, int b, int c) {
  return std::exp(std::lgamma(a + 1) + std::lgamma(b + 1) + std::lgamma(c + 1) - std::lgamma(a + b + c + 3));
}

double power(double x, int n) { return n == 0 ? 1 : std::pow(x, n); }

}  // namespace

TEST_CASE("triangle rules integrate every monomial of their degree", "[geometry][oracle]") {
  auto* const make_rule = GENERATE(&triangle_rule, &symmetric_rule);
  for (int degree = 0; degree <= 40; ++degree) {
    CAPTURE(degree);
    const auto rule = make_rule(degree);
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        const int c = degree - a - b;  // homogeneous monomials span all polynomials of lower degree as well
        double sum = 0;
        for (const auto& [xi, weight] : rule) sum += weight * power(xi[0], a) * power(xi[1], b) * power(xi[2], c);
        REQUIRE(sum == Approx(exact_integral(a, b, c)).epsilon(1e-12).margin(1e-17));
      }
    }
  }
}

TEST_CASE("triangle rules have inner points, positive weights and barycentric coordinates that sum to 1",
          "[geometry]") {
  auto* const make_rule = GENERATE(&triangle_rule, &symmetric_rule);
  for (int degree = 0; degree <= 40; ++degree) {
    for (const auto& [xi, weight] : make_rule(degree)) {
      CHECK(weight > 0);
      CHECK((xi[0] > 0 && xi[1] > 0 && xi[2] > 0));
      CHECK(xi[0] + xi[1] + xi[2] == Approx(1).epsilon(1e-15));
    }
  }
}

TEST_CASE("triangle rules of low degree have as few points as possible", "[geometry]") {
  CHECK(triangle_rule(1).size() == 1);
  CHECK(triangle_rule(2).size() == 3);
  CHECK(triangle_rule(4).size() == 6);
  CHECK(triangle_rule(5).size() == 7);
}

TEST_CASE("segment rules integrate every monomial of their degree", "[geometry][oracle]") {
  for (int degree = 0; degree <= 40; ++degree) {
    for (int n = 0; n <= degree; ++n) {
      double sum = 0;
      for (const auto& [s, weight] : segment_rule(degree)) {
        CHECK((s > 0 && s < 1 && weight > 0));
        sum += weight * power(s, n);
      }
      CHECK(sum == Approx(1.0 / (n + 1)).epsilon(1e-14));
    }
  }
}

TEST_CASE("the symmetric rules have the points of the publication", "[geometry]") {
  CHECK(symmetric_rule(6).size() == 12);
  CHECK(symmetric_rule(10).size() == 25);
  CHECK(symmetric_rule(12).size() == 33);
  CHECK(symmetric_rule(20).size() == 79);
}
