// tests/tools/expression_test.cpp: expressions from the command line: their values, and what is refused.
#include "options/expression.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

using Catch::Matchers::Contains;
using pliant::Expression;

TEST_CASE("an expression is a function of x, y and t", "[expression]") {
  CHECK(Expression("x + 10*y + 100*t")(1, 2, 3) == 321);
  CHECK(Expression("-x^2")(3, 0, 0) == -9);
  CHECK(Expression("2^3^2")(0, 0, 0) == 512);
  CHECK(Expression("pow(x, 3)")(2, 0, 0) == 8);
  CHECK(Expression("mod(x, 3)")(-1, 0, 0) == 2);
  CHECK(Expression("floor(x) + ceil(x)")(-1.5, 0, 0) == -3);
  CHECK(Expression("hypot(x, y)")(3, 4, 0) == 5);
  CHECK(Expression("sin(pi/2)")(0, 0, 0) == 1);
  CHECK(Expression("x > 0 ? y : t")(1, 5, 7) == 5);
  CHECK(Expression("x == y")(2, 2, 0) == 1);
  CHECK(std::isinf(Expression("1/x")(0, 0, 0)));
  CHECK(std::isnan(Expression("sqrt(x)")(-1, 0, 0)));
}

TEST_CASE("what is no expression is refused with its place", "[expression]") {
  CHECK_THROWS_WITH(Expression(""), Contains("empty"));
  CHECK_THROWS_WITH(Expression("  "), Contains("empty"));
  CHECK_THROWS_WITH(Expression("x +"), Contains("at the end"));
  CHECK_THROWS_WITH(Expression("x + z"), Contains("\"z\"") && Contains("character 5"));
  CHECK_THROWS_WITH(Expression("sin(x"), Contains("parenthesis"));
  CHECK_THROWS_WITH(Expression("1, 2"), Contains("one value"));
  CHECK_THROWS_WITH(Expression("nan"), Contains("nan"));
  CHECK_THROWS_AS(Expression("min()"), std::invalid_argument);
  CHECK_THROWS_AS(Expression("\"text\""), std::invalid_argument);
}

TEST_CASE("an assignment is refused and can never change a variable", "[expression]") {
  for (const char* text : {"x = 3", "x=3", "y = x = 2", "x += 1", "(t = 1) + x"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(Expression(text), Contains("=="));
  }
}

TEST_CASE("an expression knows which variables it uses", "[expression]") {
  const Expression expression("x + sin(t)");
  CHECK(expression.uses("x"));
  CHECK_FALSE(expression.uses("y"));
  CHECK(expression.uses("t"));
}

TEST_CASE("copies are independent, so that each thread may have its own", "[expression]") {
  const Expression original("x*1000 + y");
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t i = 0; i < wrong.size(); ++i)
    threads.emplace_back([copy = original, &count = wrong[i], i] {
      const double x = static_cast<double>(i);
      for (int y = 0; y < 2000; ++y)
        if (copy(x, y, 0) != x * 1000 + y) ++count;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4, 0));
}
