// tools/options/expression.h: a formula in x, y and t from the command line as a function (muParser).
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace pliant {

/// One formula, compiled once.
///
/// Language    muParser's: + - * / ^ ( ), comparisons, && ||, a ? b : c, sin cos tan asin acos atan atan2 sinh cosh
/// tanh
///             asinh acosh atanh exp ln log log2 log10 sqrt abs sign rint min max sum avg, and here also pow(a, b),
///             mod(a, b) (sign of b), floor, ceil, hypot(a, b), pi. `^` is right-associative; -x^2 is -(x^2).
///             Division by zero and roots of negatives give inf and nan, which whoever uses the value refuses.
/// Ensures     a copy is independent: one Expression may be called by one thread at a time
class Expression {
 public:
  /// Throws      std::invalid_argument with the place in the text: for what is no formula, for an assignment, for more
  ///             than one value
  explicit Expression(const std::string& text);
  Expression(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression& other);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  double operator()(double x, double y, double t) const;
  const std::string& text() const;
  /// True if the formula names that variable ("x", "y" or "t").
  bool uses(const std::string& variable) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Splits at commas that stand outside of parentheses.
std::vector<std::string> split_expressions(const std::string& text);

}  // namespace pliant
