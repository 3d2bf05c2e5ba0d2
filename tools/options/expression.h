// tools/options/expression.h: a formula in x, y and t, and in other names, as a function (muParser).
#pragma once
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// The names that a formula may use beside x, y and t.
/// Requires    names of which `fault_of_name` (formats/problem/names.h) finds nothing, each once
struct ExpressionNames {
  std::vector<std::pair<std::string, double>> constants;
  std::vector<std::string> variables;
  std::string list{};  ///< what a message says of them behind "variables are x, y and t", for example "; parameters: k"
};

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
  Expression(const std::string& text, const ExpressionNames& names);
  Expression(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression& other);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  double operator()(double x, double y, double t) const;
  /// With the values of `variables`, in their order.
  double operator()(double x, double y, double t, std::span<const double> values) const;
  const std::string& text() const;
  /// True if the formula names that variable ("x", "y", "t", or one of its `variables`).
  bool uses(const std::string& variable) const;
  /// Those of the names' variables that the formula uses: evaluating needs no others.
  const std::vector<std::string>& variables() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Splits at commas that stand outside of parentheses.
std::vector<std::string> split_expressions(const std::string& text);

}  // namespace pliant
