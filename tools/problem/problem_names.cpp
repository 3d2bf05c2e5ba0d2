// tools/problem/problem_names.cpp: parameters as constants, fields of a mesh as variables.
#include "problem/problem_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "formats/problem/names.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/describe.h"

namespace pliant {
namespace {

std::string text_of(const ProblemExpression& expression) {
  if (const double* number = std::get_if<double>(&expression)) return describe_number(*number);
  return std::get<std::string>(expression);
}

std::string list_part(const char* what, const std::vector<std::string>& names) {
  return names.empty() ? "" : std::string("; ") + what + ": " + quote_names(names);
}

bool uses_name(const std::string& text, const std::string& name) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_part(text[at - 1]) || !is_part(name.front())) &&
        (end == text.size() || !is_part(text[end]) || !is_part(name.back())))
      return true;
  }
  return false;
}

double finite(double value, const std::string& place, const std::string& text) {
  if (!std::isfinite(value))
    throw InputError(place, "\"" + text + "\" is " + describe_number(value) + ", not a finite number");
  return value;
}

}  // namespace

std::vector<std::pair<std::string, double>> parameter_values(const ProblemDocument& problem) {
  ExpressionNames before;
  for (const auto& [name, expression] : problem.parameters) {
    const std::string place = "/problem/parameters" + pointer_step(name);
    if (const std::string fault = fault_of_name(name); !fault.empty())
      throw InputError(place, "cannot be a parameter: " + fault);
    double value = 0;
    if (const double* number = std::get_if<double>(&expression)) {
      value = *number;
    } else {
      const std::string& text = std::get<std::string>(expression);
      try {
        const Expression formula(text, before);
        for (const char* variable : {"x", "y", "t"})
          if (formula.uses(variable))
            throw InputError(place, "\"" + text + "\" uses " + variable + ", but a parameter has one value");
        value = formula(0, 0, 0);
      } catch (const std::invalid_argument& error) {
        throw InputError(place, std::string(error.what()) + "; a parameter may name those before it");
      }
    }
    before.constants.emplace_back(name, finite(value, place, text_of(expression)));
    std::vector<std::string> names;
    for (const auto& constant : before.constants) names.push_back(constant.first);
    before.list = list_part("parameters", names);
  }
  return before.constants;
}

/// A formula and the fields that it reads, for use by one thread at a time.
class ProblemNames::FieldFormula {
 public:
  FieldFormula(Expression expression, std::vector<Component> reads)
      : expression_(std::move(expression)), reads_(std::move(reads)), values_(reads_.size()) {}

  double operator()(const CoefficientPoint& at) {
    if (!reads_.empty()) read_fields(at);
    return expression_(at.place.x, at.place.y, at.time, values_);
  }

 private:
  void read_fields(const CoefficientPoint& at) {
    std::array<double, net_size(max_degree)> basis;
    bernstein_basis(at.mesh.degree(), at.xi, basis);
    const auto net = at.mesh.net(at.triangle);
    const FaceId face = at.mesh.face(at.triangle);
    for (std::size_t k = 0; k < reads_.size(); ++k) {
      const int field = find(at.mesh.fields(), reads_[k]);
      values_[k] = std::numeric_limits<double>::quiet_NaN();
      if (field < 0) continue;
      const std::vector<double>& controls = at.mesh.fields()[index(field)].values;
      double value = 0;
      for (std::size_t n = 0; n < net.size(); ++n) {
        const std::ptrdiff_t first = at.mesh.value_index(field, net[n], face);
        if (first >= 0) value += basis[n] * controls[index(first + reads_[k].component)];
      }
      values_[k] = value;
    }
  }

  static int find(const std::vector<Field>& fields, const Component& read) {
    const auto fits = [&read](const Field& field) {
      return field.name == read.field && read.component < field.components;
    };
    if (index(read.index) < fields.size() && fits(fields[index(read.index)])) return read.index;
    const auto found = std::ranges::find_if(fields, fits);
    return found == fields.end() ? -1 : static_cast<int>(found - fields.begin());
  }

  Expression expression_;
  std::vector<Component> reads_;
  std::vector<double> values_;
};

ProblemNames::ProblemNames(const ProblemDocument& problem, const Mesh& mesh, const std::string& unknown, int components)
    : unknown_(unknown) {
  names_.constants = parameter_values(problem);
  const std::vector<Field>& fields = mesh.fields();
  for (std::size_t f = 0; f < fields.size(); ++f) add_field(fields[f].name, fields[f].components, static_cast<int>(f));
  if (std::ranges::find(fields, unknown, &Field::name) == fields.end())
    add_field(unknown, components, static_cast<int>(fields.size()));
  std::vector<std::string> parameters, variables;
  for (const auto& constant : names_.constants) parameters.push_back(constant.first);
  for (const auto& component : components_) variables.push_back(component.first);
  names_.list = list_part("parameters", parameters) + list_part("fields", variables);
  names_.variables = std::move(variables);
}

void ProblemNames::add_field(const std::string& name, int components, int index) {
  if (components == 1) return add(name, {name, 0, index});
  const auto part = [&](int c) { return name + (components > 2 ? "_" + std::to_string(c + 1) : c == 0 ? "_x" : "_y"); };
  for (int c = 0; c < components; ++c) add(part(c), {name, c, index});
  unusable_.push_back({name, "the field \"" + name + "\" has " + std::to_string(components) + " components, " +
                                 part(0) + (components > 2 ? " to " : " and ") + part(components - 1)});
}

void ProblemNames::add(const std::string& name, const Component& component) {
  std::string fault = fault_of_name(name);
  const bool is_free = fault.empty();
  for (const auto& constant : names_.constants)
    if (constant.first == name) fault = "\"" + name + "\" is a parameter, too";
  if (const auto other = components_.find(name); other != components_.end())
    fault = "\"" + name + "\" is also a name of the field \"" + other->second.field + "\"";
  if (fault.empty())
    components_.emplace(name, component);
  else
    unusable_.push_back(
        {name, "the field \"" + component.field + "\" cannot be used in an expression: " + fault, is_free});
}

std::string ProblemNames::explain_names(const std::string& text) const {
  std::string all;
  for (const Unusable& each : unusable_)
    if (!each.name.empty() && uses_name(text, each.name)) all += "; " + each.why;
  return all;
}

CompiledCoefficient ProblemNames::compile(const ProblemExpression& expression, const std::string& place) const {
  const std::string shown = text_of(expression);
  const std::string name = place + ": " + shown;
  if (const double* number = std::get_if<double>(&expression))
    return {Coefficient(finite(*number, place, shown), name)};
  std::optional<Expression> formula;
  try {
    formula.emplace(shown, names_);
  } catch (const std::invalid_argument& error) {
    throw InputError(place, error.what() + explain_names(shown));
  }
  for (const Unusable& each : unusable_)
    if (each.is_ambiguous && uses_name(shown, each.name)) throw InputError(place, "\"" + shown + "\": " + each.why);
  CompiledCoefficient result{Coefficient(0)};
  result.uses_time = formula->uses("t");
  std::vector<Component> reads;
  for (const std::string& variable : formula->variables()) {
    reads.push_back(components_.at(variable));
    result.uses_fields = true;
    result.uses_unknown = result.uses_unknown || reads.back().field == unknown_;
  }
  if (reads.empty() && !formula->uses("x") && !formula->uses("y") && !result.uses_time) {
    result.coefficient = Coefficient(finite((*formula)(0, 0, 0), place, shown), name);
    return result;
  }
  const auto shared = std::make_shared<FieldFormula>(std::move(*formula), std::move(reads));
  result.coefficient = Coefficient([shared](const CoefficientPoint& at) { return (*shared)(at); }, name);
  return result;
}

std::string ProblemNames::describe_parameters(const ProblemExpression& expression) const {
  std::string text;
  if (std::holds_alternative<double>(expression)) return text;
  for (const auto& [name, value] : names_.constants)
    if (uses_name(std::get<std::string>(expression), name))
      text += (text.empty() ? "" : ", ") + name + " = " + describe_number(value);
  return text;
}

std::vector<std::string> ProblemNames::unusable_fields() const {
  std::vector<std::string> sentences;
  for (const Unusable& each : unusable_)
    if (each.why.find("cannot") != std::string::npos) sentences.push_back(each.why);
  return sentences;
}

}  // namespace pliant
