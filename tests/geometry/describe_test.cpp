// tests/geometry/describe_test.cpp: numbers in messages have the digits that they need.
#include "pliant/geometry/describe.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

using namespace pliant;

TEST_CASE("a number that is described without a resolution reads back as the same double", "[geometry][describe]") {
  for (const double x : {0.1, 1.0 / 3, 1e-150, 123456789.125, -0x1p-1074})
    CHECK(std::strtod(describe_number(x).c_str(), nullptr) == x);
}

TEST_CASE("a number that is described with a resolution has no digits below it", "[geometry][describe]") {
  CHECK(describe_number(1000000.123456, 1e-3) == "1000000.123");
  CHECK(describe_number(0.123456, 1e-3) == "0.123");
  CHECK(describe_number(1e-9, 1e-3) == "0");
  CHECK(describe_number(1e-9, 1e-12) == "1e-09");
  CHECK(describe_point({1e6 + 0.25, -2}, 1e-2) == "(1000000.25, -2)");
}

TEST_CASE("numbers that differ look different, with as few digits as possible", "[geometry][describe]") {
  using Texts = std::vector<std::string>;
  CHECK(describe_apart(std::array{0.25, 1.5}) == Texts{"0.25", "1.5"});
  CHECK(describe_apart(std::array{1e6 + 1, 1e6 + 2}) == Texts{"1000001", "1000002"});
  CHECK(describe_apart(std::array{0.3, 0.1 + 0.2}) == Texts{"0.29999999999999999", "0.30000000000000004"});
  CHECK(describe_apart(std::array{0.5, 0.5}) == Texts{"0.5", "0.5"});
  const double next = std::nextafter(1e300, 2e300);
  const Texts apart = describe_apart(std::array{next, 1e300, 0.0, -1.0});
  CHECK(apart[0] != apart[1]);
}
