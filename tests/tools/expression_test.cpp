// tests/tools/expression_test.cpp: expressions from the command line: their values, and what is refused.
#include "options/expression.h"

#include <muParser.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "formats/problem/names.h"

using Catch::Matchers::Contains;
using pliant::Expression;
using pliant::ExpressionNames;

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
  // A text of any length has a message that can be read.
  try {
    const Expression accepted("1+" + std::string(100'000, '1') + "q");
    FAIL("is accepted: " << accepted.text().size());
  } catch (const std::invalid_argument& error) {
    CHECK(std::string(error.what()).size() < 500);
  }
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

TEST_CASE("an expression may have named constants and variables", "[expression]") {
  const ExpressionNames names{{{"k", 0.5}, {"x_", 3}}, {"u", "vel_x", "w", "unused"}, "; parameters: k"};
  const Expression expression("k*w + 10*u + 100*x + x_ + t", names);
  REQUIRE(expression.variables() == std::vector<std::string>{"u", "w"});
  const std::vector<double> values{4, 8};
  CHECK(expression(1, 0, 1000, values) == 1147);
  CHECK(expression.uses("w"));
  CHECK_FALSE(expression.uses("unused"));
  CHECK_FALSE(expression.uses("k"));
  // A copy keeps names, and neither sees the other's values.
  const Expression copy = expression;  // NOLINT(performance-unnecessary-copy-initialization): it is what is tested
  CHECK(copy(0, 0, 0, std::vector<double>{1, 0}) == 13);
  CHECK(expression(1, 0, 1000, values) == 1147);
  Expression assigned("x");
  assigned = expression;
  CHECK(assigned(1, 0, 1000, values) == 1147);
  CHECK(Expression("vel_x^2", names)(0, 0, 0, std::vector<double>{-3}) == 9);
  CHECK(Expression("k + x", names)(1, 0, 0) == 1.5);
  CHECK_THROWS_WITH(Expression("q", names), Contains("variables are x, y and t; parameters: k"));
  CHECK_THROWS_WITH(Expression("q"), Contains("(variables are x, y and t)"));
  for (const char* text : {"k = 3", "u = 3", "w += 1"}) CHECK_THROWS_WITH(Expression(text, names), Contains("=="));
}

TEST_CASE("the names that problems leave to expressions are those that the parser has", "[expression]") {
  mu::Parser parser;
  std::vector<std::string> known = pliant::expression_functions(), there{"pow", "mod", "hypot", "floor", "ceil"};
  for (const auto& function : parser.GetFunDef()) there.push_back(function.first);
  std::sort(known.begin(), known.end());
  std::sort(there.begin(), there.end());
  CHECK(known == there);
  for (const auto& constant : parser.GetConst()) CHECK_FALSE(pliant::fault_of_name(constant.first).empty());
  for (const std::string& name : known) CHECK_THROWS_AS(Expression(name), std::invalid_argument);
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
