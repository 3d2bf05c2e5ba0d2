// tools/options/expression.cpp: formulas in x, y, t and other names, as muParser evaluates them.
#include "options/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "formats/document/recognize.h"
#include "formats/problem/names.h"

namespace pliant {
namespace {

double modulo(double a, double b) { return a - b * std::floor(a / b); }
double power(double a, double b) { return std::pow(a, b); }
double hypotenuse(double a, double b) { return std::hypot(a, b); }
double round_down(double a) { return std::floor(a); }
double round_up(double a) { return std::ceil(a); }

void define_names(mu::Parser& parser) {
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineFun("pow", power);
  parser.DefineFun("mod", modulo);
  parser.DefineFun("hypot", hypotenuse);
  parser.DefineFun("floor", round_down);
  parser.DefineFun("ceil", round_up);
}

void define_constants(mu::Parser& parser, const ExpressionNames& names) {
  for (const auto& [name, value] : names.constants) parser.DefineConst(name, value);
}

/// The parser's message without its own mention of the place.
std::string without_position(const std::string& message) {
  for (const char* tail : {" found at position", " at position", " at expression position", " (position:"})
    if (const std::size_t end = message.find(tail); end != std::string::npos) return message.substr(0, end);
  return message;
}

/// The text, or as much of its beginning as a message has place for.
std::string shortened(const std::string& text) {
  std::size_t end = 200;
  if (text.size() <= end) return text;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a character
  return text.substr(0, end) + "...";
}

[[noreturn]] void refuse(const std::string& text, const std::string& why, int position) {
  std::string message = "\"" + shortened(text) + "\": " + why;
  if (position >= static_cast<int>(text.size()))
    message += " (at the end)";
  else if (position >= 0)
    message += " (at character " + std::to_string(position + 1) + ")";
  throw std::invalid_argument(message);
}

/// Where there are names of somebody's own: the one, or the function, that `token` may be a misspelling of.
std::string suggest(const std::string& token, const ExpressionNames& names) {
  if (names.list.empty() || token.size() < 2) return {};
  std::vector<std::string> candidates = names.variables;
  for (const auto& constant : names.constants) candidates.push_back(constant.first);
  candidates.insert(candidates.end(), expression_functions().begin(), expression_functions().end());
  const std::string nearest = nearest_word(token, candidates);
  if (nearest == token) return "; the function is written " + token + "(...)";
  return nearest.empty() ? "" : "; is \"" + nearest + "\" meant?";
}

/// Evaluates once with the variables as constants: so the parser itself refuses an assignment such as "x = 3", which
/// would otherwise change x behind our back.
void check(const std::string& text, const ExpressionNames& names) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) refuse(text, "the expression is empty", -1);
  mu::Parser parser;
  define_names(parser);
  for (const char* name : {"x", "y", "t"}) parser.DefineConst(name, 0.5);
  int values = 0;
  try {
    define_constants(parser, names);
    for (const std::string& name : names.variables) parser.DefineConst(name, 0.5);
    parser.SetExpr(text);
    parser.Eval(values);
  } catch (const mu::Parser::exception_type& error) {
    const std::string& token = error.GetToken();
    if (error.GetCode() == mu::ecUNEXPECTED_OPERATOR && token == "=")
      refuse(text, "\"=\" would assign; to compare write \"==\"", error.GetPos());
    std::string why = without_position(error.GetMsg());
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
      why = "\"" + token + "\" is no name that is known here" + suggest(token, names) + " (variables are x, y and t" +
            names.list + ")";
    refuse(text, why, error.GetPos());
  }
  if (values != 1) refuse(text, "one value is wanted, here are " + std::to_string(values), -1);
}

}  // namespace

struct Expression::State {
  std::string text;
  ExpressionNames names;  // of the variables only those that are used
  mu::Parser parser;
  double x = 0, y = 0, t = 0;  // bound to the parser by address, as are these:
  std::vector<double> values;

  State(const std::string& formula, const ExpressionNames& given) : text(formula), names(given) {
    define_names(parser);
    define_constants(parser, names);
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("t", &t);
    values.resize(names.variables.size());
    for (std::size_t k = 0; k < values.size(); ++k) parser.DefineVar(names.variables[k], &values[k]);
    parser.SetExpr(text);
    keep_used();
  }

 private:
  void keep_used() {
    if (names.variables.empty()) return;
    const auto used = parser.GetUsedVar();
    for (std::size_t k = names.variables.size(); k-- > 0;)
      if (!used.contains(names.variables[k])) {
        parser.RemoveVar(names.variables[k]);
        names.variables.erase(names.variables.begin() + static_cast<std::ptrdiff_t>(k));
      }
    values.resize(names.variables.size());  // keeps its memory, so the addresses that stay are those of others
    for (std::size_t k = 0; k < values.size(); ++k) parser.DefineVar(names.variables[k], &values[k]);
    parser.SetExpr(text);
  }
};

Expression::Expression(const std::string& text) : Expression(text, ExpressionNames{}) {}
Expression::Expression(const std::string& text, const ExpressionNames& names) {
  check(text, names);
  state_ = std::make_unique<State>(text, names);
}
Expression::Expression(const Expression& other) : state_(std::make_unique<State>(other.text(), other.state_->names)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(const Expression& other) {
  if (this != &other) state_ = std::make_unique<State>(other.text(), other.state_->names);
  return *this;
}
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(double x, double y, double t) const {
  state_->x = x;
  state_->y = y;
  state_->t = t;
  return state_->parser.Eval();
}

double Expression::operator()(double x, double y, double t, std::span<const double> values) const {
  assert(values.size() == state_->values.size());
  std::copy(values.begin(), values.end(), state_->values.begin());
  return (*this)(x, y, t);
}

const std::string& Expression::text() const { return state_->text; }

bool Expression::uses(const std::string& variable) const { return state_->parser.GetUsedVar().contains(variable); }

const std::vector<std::string>& Expression::variables() const { return state_->names.variables; }

std::vector<std::string> split_expressions(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace pliant
