// tools/problem/explain_diffusion.cpp: a diffusion problem in words, a line for each face and each curve.
#include <algorithm>
#include <sstream>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/geometry/describe.h"
#include "problem/diffusion.h"
#include "problem/on_mesh.h"
#include "problem/problem_names.h"
#include "problem/problem_words.h"

namespace pliant {
namespace {

class DiffusionExplainer {
 public:
  DiffusionExplainer(const DiffusionProblem& diffusion, const ProblemDocument& problem, const Mesh& mesh)
      : diffusion_(diffusion),
        given_(*problem.diffuse),
        mesh_(mesh),
        words_(problem, ProblemNames(problem, mesh, given_.field)) {}

  std::string text() {
    explain_unknown();
    out_ << words_.notes() << words_.parameters();
    explain_faces();
    explain_curves();
    explain_equation();
    return out_.str();
  }

 private:
  void explain_unknown() {
    const bool is_there = std::ranges::find(mesh_.fields(), given_.field, &Field::name) != mesh_.fields().end();
    out_ << "unknown: the field \"" << given_.field << "\", "
         << (is_there ? "which the mesh has: its values are those to begin with\n"
                      : "which the mesh does not have yet: it begins with the initial values\n");
  }

  void explain_faces() {
    for (std::size_t f = 0; f < mesh_.boundary().faces.size(); ++f) {
      const std::string& face = mesh_.boundary().faces[f].name;
      const auto* entry = entry_of(given_.materials, face);
      out_ << describe_face(mesh_.boundary(), f, entry->first);
      const ProblemMaterial& material = entry->second;
      out_ << ": diffusivity " << (material.diffusivity.empty() ? "1 (default)" : words_.shown(material.diffusivity));
      out_ << "; capacity " << (material.capacity ? words_.shown(*material.capacity) : "1 (default)");
      out_ << "; source " << (material.source ? words_.shown(*material.source) : "none (default)");
      const auto* initial = entry_of(given_.initial, face);
      out_ << "; initially " << (initial != nullptr ? words_.shown(initial->second) : "nothing is given (default)")
           << '\n';
    }
  }

  void explain_curves() {
    const BoundaryComplex& boundary = mesh_.boundary();
    for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
      const Curve& curve = boundary.curves[c];
      out_ << describe_curve(boundary, static_cast<int>(c)) << ", " << describe_sides(boundary, curve) << ": ";
      const int condition = diffusion_.condition_of_curve[c];
      if (condition == none) {
        out_ << (is_outer(curve) ? "nothing crosses it (default)"
                                 : "the unknown is continuous, and nothing enters (default)");
      } else {
        const ProblemCondition& given = given_.conditions[index(condition)];
        explain_condition(given);
        out_ << describe_origin(condition, given.curves, curve);
      }
      out_ << '\n';
    }
  }

  void explain_condition(const ProblemCondition& condition) {
    using Kind = ProblemCondition::Kind;
    switch (condition.kind) {
      case Kind::value:
        out_ << "the unknown is " << words_.shown(condition.first);
        break;
      case Kind::flux:
        out_ << words_.shown(condition.first) << " enters per length and time";
        break;
      case Kind::robin:
        out_ << "the transfer " << words_.shown(condition.first) << " times how far the unknown is above "
             << words_.shown(condition.second) << " leaves per length and time";
        break;
      case Kind::jump:
        out_ << "the unknown may jump, and the transfer " << words_.shown(condition.first) << " times its jump crosses";
    }
  }

  void explain_equation() {
    out_ << "convection relative to the mesh: "
         << (given_.convection.empty() ? "none (default)" : words_.shown(given_.convection)) << '\n';
    out_ << "the equation is "
         << (diffusion_.depends_on_unknown ? "not linear: coefficients use the unknown" : "linear") << "; coefficients "
         << (diffusion_.depends_on_time ? "use" : "do not use") << " the time or fields\n";
  }

  const DiffusionProblem& diffusion_;
  const DiffuseSection& given_;
  const Mesh& mesh_;
  ProblemWords words_;
  std::ostringstream out_;
};

}  // namespace

std::string explain(const DiffusionProblem& diffusion, const ProblemDocument& problem, const Mesh& mesh) {
  return DiffusionExplainer(diffusion, problem, mesh).text();
}

}  // namespace pliant
