// tools/problem/explain_incompressible.cpp: a flow problem in words, a line for each face and each curve.
#include <algorithm>
#include <sstream>

#include "pliant/boundary/boundary_spans.h"
#include "problem/incompressible.h"
#include "problem/on_mesh.h"
#include "problem/problem_names.h"
#include "problem/problem_words.h"

namespace pliant {
namespace {

class FlowExplainer {
 public:
  FlowExplainer(const FlowProblem& flow, const ProblemDocument& problem, const Mesh& mesh)
      : flow_(flow),
        given_(*problem.navierstokes),
        mesh_(mesh),
        words_(problem, ProblemNames(problem, mesh, "velocity", 2)) {}

  std::string text() {
    const bool is_there = std::ranges::find(mesh_.fields(), "velocity", &Field::name) != mesh_.fields().end();
    out_ << "unknowns: the fields \"velocity\" and \"pressure\"; the mesh "
         << (is_there ? "has a velocity: its values are those to begin with\n"
                      : "has no velocity yet: it begins with the initial one\n")
         << words_.notes() << words_.parameters();
    explain_faces();
    explain_curves();
    explain_equations();
    return out_.str();
  }

 private:
  void explain_faces() {
    for (std::size_t f = 0; f < mesh_.boundary().faces.size(); ++f) {
      const auto* entry = entry_of(given_.materials, mesh_.boundary().faces[f].name);
      const NavierStokesMaterial& material = entry->second;
      out_ << describe_face(mesh_.boundary(), f, entry->first) << ": density "
           << (material.density ? words_.shown(*material.density) : "1 (default)") << "; viscosity "
           << words_.shown(material.viscosity) << '\n';
    }
  }

  void explain_curves() {
    const BoundaryComplex& boundary = mesh_.boundary();
    for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
      const Curve& curve = boundary.curves[c];
      out_ << describe_curve(boundary, static_cast<int>(c)) << ", " << describe_sides(boundary, curve) << ": ";
      const int condition = flow_.condition_of_curve[c];
      if (condition == none) {
        out_ << "the velocity is continuous (default); the mesh follows the flow (default)";
      } else {
        const NavierStokesCondition& given = given_.conditions[index(condition)];
        explain_condition(given);
        out_ << "; the mesh "
             << (flow_.motion_of_curve[c] == CurveMotion::follows ? "follows the flow" : "does not move")
             << (given.moves ? "" : " (default)") << describe_origin(condition, given.curves, curve);
      }
      const auto tension =
          std::ranges::find(given_.surface_tension, curve.name, &std::pair<std::string, ProblemExpression>::first);
      if (tension != given_.surface_tension.end()) out_ << "; surface tension " << words_.shown(tension->second);
      out_ << '\n';
    }
  }

  void explain_condition(const NavierStokesCondition& condition) {
    using Kind = NavierStokesCondition::Kind;
    switch (condition.kind) {
      case Kind::velocity:
        out_ << "the velocity is " << words_.shown(condition.components);
        break;
      case Kind::slip:
        out_ << "nothing crosses it, and nothing holds the fluid back along it";
        break;
      case Kind::traction:
        out_ << "the stress from outside is " << words_.shown(condition.components);
        break;
      case Kind::outflow:
        out_ << "the fluid leaves freely";
        break;
      case Kind::natural:
        out_ << "there is no stress from outside";
    }
  }

  void explain_vector(const char* what, const std::vector<ProblemExpression>& given, const char* otherwise) {
    out_ << what << ": " << (given.empty() ? otherwise : words_.shown(given)) << '\n';
  }

  void explain_equations() {
    explain_vector("gravity", given_.gravity, "none (default)");
    explain_vector("force per area", given_.force, "none (default)");
    explain_vector("initial velocity", given_.initial, "[0, 0] (default)");
    out_ << "pressure: "
         << (flow_.pressure_by_face ? "by face, it may jump across curves where the fluid changes, surface tension "
                                      "acts or a velocity or slip is given"
                                    : "continuous")
         << (given_.pressure ? "" : " (default)") << '\n';
    const bool is_stokes = std::ranges::all_of(
        flow_.materials, [](const FlowMaterial& material) { return material.density.constant() == 0; });
    out_ << "the equations are those of " << (is_stokes ? "Stokes" : "Navier and Stokes") << "; coefficients "
         << (flow_.depends_on_time ? "use" : "do not use") << " the time or fields\n";
  }

  const FlowProblem& flow_;
  const NavierStokesSection& given_;
  const Mesh& mesh_;
  ProblemWords words_;
  std::ostringstream out_;
};

}  // namespace

std::string explain(const FlowProblem& flow, const ProblemDocument& problem, const Mesh& mesh) {
  return FlowExplainer(flow, problem, mesh).text();
}

}  // namespace pliant
