// tools/problem/incompressible.cpp: fluids on faces, conditions and motions of curves; what does not fit is refused.
#include "problem/incompressible.h"

#include <algorithm>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/fault.h"
#include "problem/on_mesh.h"
#include "problem/problem_names.h"

namespace pliant {
namespace {

class FlowBuilder {
 public:
  FlowBuilder(const ProblemDocument& problem, const Mesh& mesh)
      : section_(require_section(problem, "navierstokes", problem.navierstokes.has_value())),
        given_(*problem.navierstokes),
        boundary_(mesh.boundary()),
        names_(problem, mesh, "velocity", 2) {}

  FlowProblem build() {
    problem_.materials = materials_of(
        boundary_, given_.materials, section_,
        [this](const NavierStokesMaterial& each, const std::string& place) { return make_material(each, place); });
    add_conditions();
    add_motions();
    add_tensions();
    if (!given_.gravity.empty()) problem_.gravity = load_pair(given_.gravity, section_ + "/gravity");
    if (!given_.force.empty()) problem_.force = load_pair(given_.force, section_ + "/force");
    if (!given_.initial.empty())
      problem_.initial = {initial(given_.initial[0], section_ + "/initial/0"),
                          initial(given_.initial[1], section_ + "/initial/1")};
    problem_.pressure_by_face = given_.pressure != NavierStokesSection::Pressure::continuous;
    return std::move(problem_);
  }

 private:
  /// A coefficient of the equations; notes what it depends on.
  Coefficient load(const ProblemExpression& expression, const std::string& place) {
    CompiledCoefficient compiled = names_.compile(expression, place);
    problem_.depends_on_time |= compiled.uses_time || compiled.uses_fields;
    return std::move(compiled.coefficient);
  }
  std::array<Coefficient, 2> load_pair(const std::vector<ProblemExpression>& given, const std::string& place) {
    Coefficient first = load(given[0], place + "/0");
    return {std::move(first), load(given[1], place + "/1")};
  }

  /// A component of the initial velocity. It is asked for once, so what it depends on does not matter later.
  Coefficient initial(const ProblemExpression& expression, const std::string& place) const {
    CompiledCoefficient compiled = names_.compile(expression, place);
    if (compiled.uses_unknown)
      throw InputError(place, "uses the unknown \"velocity\", which has no values before these");
    return std::move(compiled.coefficient);
  }

  FlowMaterial make_material(const NavierStokesMaterial& given, const std::string& place) {
    FlowMaterial material;
    material.density =
        given.density ? load(*given.density, place + "/density") : Coefficient(1, place + "/density: 1 (default)");
    refuse_below(material.density, true, place + "/density", "the density");
    material.viscosity = load(given.viscosity, place + "/viscosity");
    refuse_below(material.viscosity, false, place + "/viscosity", "the viscosity");
    return material;
  }

  // -- curves

  FlowCondition make_condition(const NavierStokesCondition& given, const std::string& place) {
    using Kind = NavierStokesCondition::Kind;
    FlowCondition condition;
    condition.place = place;
    const std::string member = place + "/" + condition_name(given.kind);
    switch (given.kind) {
      case Kind::velocity:
      case Kind::traction: {
        condition.kind = given.kind == Kind::velocity ? FlowCondition::Kind::velocity : FlowCondition::Kind::traction;
        std::array<Coefficient, 2> components = load_pair(given.components, member);
        condition.first = std::move(components[0]);
        condition.second = std::move(components[1]);
        break;
      }
      case Kind::slip:
        condition.kind = FlowCondition::Kind::slip;
        break;
      case Kind::outflow:
        condition.kind = FlowCondition::Kind::outflow;
        if (given.moves.value_or(false))
          throw InputError(place + "/moves", "is true, but fluid passes through an outflow: the curve stays");
        break;
      case Kind::natural:
        condition.kind = FlowCondition::Kind::traction;
        condition.first = condition.second = Coefficient(0, member + ": 0");
    }
    return condition;
  }

  /// May condition k, which stands at `place`, stand on this curve?
  void check_condition(std::size_t k, int c, const std::string& place) const {
    using Kind = FlowCondition::Kind;
    const Curve& curve = boundary_.curves[index(c)];
    const Kind kind = problem_.conditions[k].kind;
    if (is_outer(curve) || kind == Kind::velocity || kind == Kind::slip) return;
    throw InputError(place, describe_curve(boundary_, c) + " lies " + describe_sides(boundary_, curve) + ": \"" +
                                condition_name(given_.conditions[k].kind) + "\" can only stand on the outer boundary");
  }

  void add_conditions() {
    CurveConditions on_curves(boundary_, section_, [this](std::size_t k, int curve, const std::string& place) {
      check_condition(k, curve, place);
    });
    for (const NavierStokesCondition& given : given_.conditions) {
      problem_.conditions.push_back(make_condition(given, on_curves.place()));
      on_curves.add(given.curves);
    }
    problem_.condition_of_curve = on_curves.finish();
    std::vector<std::string> bare;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const Curve& curve = boundary_.curves[c];
      if (is_outer(curve) && problem_.condition_of_curve[c] == none &&
          std::ranges::find(bare, curve.name) == bare.end())
        bare.push_back(curve.name);
    }
    if (bare.empty()) return;
    throw InputError(section_ + "/conditions",
                     "every curve of the outer boundary needs a condition: " + quote_names(bare) +
                         (bare.size() == 1 ? " has" : " have") + " none; \"*\" stands for all that are not named");
  }

  void add_motions() {
    for (const int k : problem_.condition_of_curve) {
      bool follows = true;
      if (k != none) {
        const NavierStokesCondition& given = given_.conditions[index(k)];
        follows = given.moves.value_or(problem_.conditions[index(k)].kind == FlowCondition::Kind::traction);
      }
      problem_.motion_of_curve.push_back(follows ? CurveMotion::follows : CurveMotion::stays);
    }
  }

  void add_tensions() {
    const CurveNames curves(boundary_);
    problem_.tensions.resize(boundary_.curves.size());
    for (const auto& [name, expression] : given_.surface_tension) {
      const std::string place = section_ + "/surface_tension" + pointer_step(name);
      const std::vector<std::size_t>& named = curves.at(name, place);
      const Coefficient tension = load(expression, place);
      refuse_below(tension, true, place, "the surface tension");
      for (const std::size_t c : named) problem_.tensions[c] = tension;
    }
  }

  std::string section_;
  const NavierStokesSection& given_;
  const BoundaryComplex& boundary_;
  ProblemNames names_;
  FlowProblem problem_;
};

}  // namespace

FlowProblem make_flow_problem(const ProblemDocument& problem, const Mesh& mesh) {
  return FlowBuilder(problem, mesh).build();
}

}  // namespace pliant
