// tools/problem/explain.cpp: a diffusion problem in words, a line for each face and each curve.
#include <algorithm>
#include <sstream>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/geometry/describe.h"
#include "problem/diffusion.h"
#include "problem/problem_names.h"

namespace pliant {
namespace {

class Explainer {
 public:
  Explainer(const DiffusionProblem& diffusion, const ProblemDocument& problem, const Mesh& mesh)
      : diffusion_(diffusion),
        problem_(problem),
        given_(*problem.diffuse),
        mesh_(mesh),
        names_(problem, mesh, given_.field) {}

  std::string text() {
    explain_unknown();
    explain_parameters();
    explain_faces();
    explain_curves();
    explain_equation();
    return out_.str();
  }

 private:
  /// The expression as it was written, and what its parameters are.
  std::string shown(const ProblemExpression& expression) const {
    if (const double* number = std::get_if<double>(&expression)) return describe_number(*number);
    const std::string parameters = names_.describe_parameters(expression);
    return std::get<std::string>(expression) + (parameters.empty() ? "" : " (" + parameters + ")");
  }
  /// The same of several, in brackets.
  std::string shown(const std::vector<ProblemExpression>& expressions) const {
    if (expressions.size() == 1) return shown(expressions.front());
    std::string text;
    for (const ProblemExpression& each : expressions) text += (text.empty() ? "[" : ", ") + shown(each);
    return text + "]";
  }

  /// What an object has for a face: by its name, or by "*"; null where neither is there.
  template <class Value>
  static const std::pair<std::string, Value>* entry_of(const std::vector<std::pair<std::string, Value>>& entries,
                                                       const std::string& face) {
    const auto find = [&entries](const std::string& name) {
      return std::ranges::find(entries, name, &std::pair<std::string, Value>::first);
    };
    auto entry = find(face);
    if (entry == entries.end()) entry = find("*");
    return entry == entries.end() ? nullptr : &*entry;
  }

  void explain_unknown() {
    const bool is_there = std::ranges::find(mesh_.fields(), given_.field, &Field::name) != mesh_.fields().end();
    out_ << "unknown: the field \"" << given_.field << "\", "
         << (is_there ? "which the mesh has: its values are those to begin with\n"
                      : "which the mesh does not have yet: it begins with the initial values\n");
    for (const std::string& sentence : names_.unusable_fields()) out_ << "note: " << sentence << '\n';
  }

  void explain_parameters() {
    const auto& values = names_.parameters();
    for (std::size_t k = 0; k < values.size(); ++k) {
      out_ << "parameter " << values[k].first << " = " << describe_number(values[k].second);
      if (const auto* text = std::get_if<std::string>(&problem_.parameters[k].second)) out_ << " (" << *text << ')';
      out_ << '\n';
    }
  }

  void explain_faces() {
    for (std::size_t f = 0; f < mesh_.boundary().faces.size(); ++f) {
      const std::string& face = mesh_.boundary().faces[f].name;
      out_ << "face '" << face << "' (" << f << ")";
      const auto* entry = entry_of(given_.materials, face);
      if (entry->first == "*") out_ << ", by \"*\"";
      const ProblemMaterial& material = entry->second;
      out_ << ": diffusivity " << (material.diffusivity.empty() ? "1 (default)" : shown(material.diffusivity));
      out_ << "; capacity " << (material.capacity ? shown(*material.capacity) : "1 (default)");
      out_ << "; source " << (material.source ? shown(*material.source) : "none (default)");
      const auto* initial = entry_of(given_.initial, face);
      out_ << "; initially " << (initial != nullptr ? shown(initial->second) : "nothing is given (default)") << '\n';
    }
  }

  void explain_curves() {
    const BoundaryComplex& boundary = mesh_.boundary();
    for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
      const Curve& curve = boundary.curves[c];
      const bool is_outer = curve.left == outside || curve.right == outside;
      out_ << describe_curve(boundary, static_cast<int>(c)) << ", " << sides(boundary, curve) << ": ";
      const int condition = diffusion_.condition_of_curve[c];
      if (condition == none) {
        out_ << (is_outer ? "nothing crosses it (default)" : "the unknown is continuous, and nothing enters (default)");
      } else {
        const ProblemCondition& given = given_.conditions[index(condition)];
        explain_condition(given);
        const bool is_named = std::ranges::find(given.curves, curve.name) != given.curves.end() && curve.name != "*";
        out_ << ", by conditions/" << condition << (is_named ? "" : ", \"*\"");
      }
      out_ << '\n';
    }
  }

  static std::string sides(const BoundaryComplex& boundary, const Curve& curve) {
    const auto quoted = [&boundary](int face) { return "'" + boundary.faces[index(face)].name + "'"; };
    if (curve.left == outside && curve.right == outside) return "beside no face";
    if (curve.left == outside || curve.right == outside)
      return "outer boundary of " + quoted(std::max(curve.left, curve.right));
    if (curve.left == curve.right) return "in " + quoted(curve.left);
    return "between " + quoted(curve.left) + " and " + quoted(curve.right);
  }

  void explain_condition(const ProblemCondition& condition) {
    using Kind = ProblemCondition::Kind;
    switch (condition.kind) {
      case Kind::value:
        out_ << "the unknown is " << shown(condition.first);
        break;
      case Kind::flux:
        out_ << shown(condition.first) << " enters per length and time";
        break;
      case Kind::robin:
        out_ << "the transfer " << shown(condition.first) << " times how far the unknown is above "
             << shown(condition.second) << " leaves per length and time";
        break;
      case Kind::jump:
        out_ << "the unknown may jump, and the transfer " << shown(condition.first) << " times its jump crosses";
    }
  }

  void explain_equation() {
    out_ << "convection relative to the mesh: "
         << (given_.convection.empty() ? "none (default)" : shown(given_.convection)) << '\n';
    out_ << "the equation is "
         << (diffusion_.depends_on_unknown ? "not linear: coefficients use the unknown" : "linear") << "; coefficients "
         << (diffusion_.depends_on_time ? "use" : "do not use") << " the time or fields\n";
  }

  const DiffusionProblem& diffusion_;
  const ProblemDocument& problem_;
  const DiffuseSection& given_;
  const Mesh& mesh_;
  ProblemNames names_;
  std::ostringstream out_;
};

}  // namespace

std::string explain(const DiffusionProblem& diffusion, const ProblemDocument& problem, const Mesh& mesh) {
  return Explainer(diffusion, problem, mesh).text();
}

}  // namespace pliant
