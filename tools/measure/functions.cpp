// tools/measure/functions.cpp: components of fields by name, and what else is compiled as an expression.
#include "measure/functions.h"

#include <algorithm>

#include "formats/problem/problem_json.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

std::string component_suffix(int components, int c) {
  if (components == 1) return {};
  if (components == 2) return c == 0 ? "_x" : "_y";
  return "_" + std::to_string(c + 1);
}

}  // namespace

const ProblemNames& MeasuredFunctions::names() {
  if (names_) return *names_;
  ProblemDocument problem;
  const auto carried = std::ranges::find(mesh_.extra, "problem", &ExtraMembers::value_type::first);
  if (carried != mesh_.extra.end()) problem.parameters = read_problem(*carried->second).parameters;
  for (const auto& [name, value] : set_) {
    const auto own = std::ranges::find(problem.parameters, name, &std::pair<std::string, ProblemExpression>::first);
    if (own == problem.parameters.end())
      problem.parameters.emplace_back(name, value);
    else
      own->second = value;
  }
  const std::string unknown = mesh_.fields().empty() ? std::string() : mesh_.fields().front().name;  // is there anyway
  names_ = std::make_unique<ProblemNames>(problem, mesh_, unknown);
  return *names_;
}

const std::vector<std::pair<std::string, double>>& MeasuredFunctions::parameters() { return names().parameters(); }

std::vector<NamedFunction> MeasuredFunctions::find(const std::string& text, const std::string& opening) {
  std::vector<NamedFunction> found;
  if (const int field = find_field(mesh_, text); field != none) {
    const int components = mesh_.fields()[static_cast<std::size_t>(field)].components;
    for (int c = 0; c < components; ++c)
      found.push_back({component_suffix(components, c), MeshFunction(mesh_, field, c)});
    return found;
  }
  for (std::size_t f = 0; f < mesh_.fields().size(); ++f)
    for (int c = 0; c < mesh_.fields()[f].components; ++c)
      if (mesh_.fields()[f].name + component_suffix(mesh_.fields()[f].components, c) == text)
        return {{"", MeshFunction(mesh_, static_cast<int>(f), c)}};
  const ProblemNames& known = names();
  try {
    found.push_back({"", MeshFunction(mesh_, known.compile(text, opening).coefficient)});
  } catch (const InputError& error) {
    throw UsageError(opening + ": " + error.what());
  }
  return found;
}

}  // namespace pliant
