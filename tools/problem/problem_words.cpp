// tools/problem/problem_words.cpp: expressions with their parameters, faces, and where conditions come from, in words.
#include "problem/problem_words.h"

#include "pliant/geometry/describe.h"

namespace pliant {

std::string ProblemWords::shown(const ProblemExpression& expression) const {
  if (const double* number = std::get_if<double>(&expression)) return describe_number(*number);
  const std::string parameters = names_.describe_parameters(expression);
  return std::get<std::string>(expression) + (parameters.empty() ? "" : " (" + parameters + ")");
}

std::string ProblemWords::shown(const std::vector<ProblemExpression>& expressions) const {
  if (expressions.size() == 1) return shown(expressions.front());
  std::string text;
  for (const ProblemExpression& each : expressions) text += (text.empty() ? "[" : ", ") + shown(each);
  return text + "]";
}

std::string ProblemWords::notes() const {
  std::string text;
  for (const std::string& sentence : names_.unusable_fields()) text += "note: " + sentence + "\n";
  return text;
}

std::string ProblemWords::parameters() const {
  std::string text;
  const auto& values = names_.parameters();
  for (std::size_t k = 0; k < values.size(); ++k) {
    text += "parameter " + values[k].first + " = " + describe_number(values[k].second);
    if (const auto* given = std::get_if<std::string>(&problem_.parameters[k].second)) text += " (" + *given + ")";
    text += "\n";
  }
  return text;
}

std::string describe_face(const BoundaryComplex& boundary, std::size_t face, const std::string& entry) {
  return "face '" + boundary.faces[face].name + "' (" + std::to_string(face) + ")" + (entry == "*" ? ", by \"*\"" : "");
}

std::string describe_origin(int condition, const std::vector<std::string>& names, const Curve& curve) {
  const bool is_named = curve.name != "*" && std::ranges::find(names, curve.name) != names.end();
  return ", by conditions/" + std::to_string(condition) + (is_named ? "" : ", \"*\"");
}

}  // namespace pliant
