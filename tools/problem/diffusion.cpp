// tools/problem/diffusion.cpp: names become indices, texts become coefficients; all that does not fit is refused.
#include "problem/diffusion.h"

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/describe.h"
#include "problem/on_mesh.h"
#include "problem/problem_names.h"

namespace pliant {
namespace {

class DiffusionBuilder {
 public:
  DiffusionBuilder(const ProblemDocument& problem, const Mesh& mesh)
      : section_(require_section(problem, "diffuse", problem.diffuse.has_value())),
        given_(*problem.diffuse),
        mesh_(mesh),
        boundary_(mesh.boundary()),
        names_(problem, mesh, given_.field) {}

  DiffusionProblem build() {
    problem_.field = given_.field;
    check_unknown();
    problem_.materials = materials_of(
        boundary_, given_.materials, section_,
        [this](const ProblemMaterial& each, const std::string& place) { return make_material(each, place); });
    add_conditions();
    add_initial();
    for (std::size_t k = 0; k < given_.convection.size(); ++k)
      problem_.convection.push_back(matrix(given_.convection[k], section_ + "/convection/" + std::to_string(k)));
    return std::move(problem_);
  }

 private:
  void check_unknown() const {
    for (const Field& field : mesh_.fields())
      if (field.name == given_.field && field.components != 1)
        throw InputError(section_ + "/field", "the mesh's field \"" + field.name + "\" has " +
                                                  std::to_string(field.components) +
                                                  " components, while the unknown is a scalar");
  }

  /// A coefficient of the equation; notes what it depends on.
  Coefficient load(const ProblemExpression& expression, const std::string& place) {
    CompiledCoefficient compiled = names_.compile(expression, place);
    problem_.depends_on_unknown |= compiled.uses_unknown;
    problem_.depends_on_time |= compiled.uses_time || compiled.uses_fields;
    return std::move(compiled.coefficient);
  }

  /// The same of one that goes into the matrices.
  Coefficient matrix(const ProblemExpression& expression, const std::string& place) {
    CompiledCoefficient compiled = names_.compile(expression, place);
    problem_.depends_on_unknown |= compiled.uses_unknown;
    problem_.depends_on_time |= compiled.uses_time || compiled.uses_fields;
    problem_.matrices_depend_on_time |= compiled.uses_time || compiled.uses_fields;
    return std::move(compiled.coefficient);
  }

  // -- materials

  void add_diffusivity(const std::vector<ProblemExpression>& given, const std::string& place,
                       DiffusionMaterial& material) {
    material.diffusivity.clear();
    if (given.size() == 1) {
      material.diffusivity.push_back(matrix(given.front(), place));
      return refuse_below(material.diffusivity.front(), false, place, "the diffusivity");
    }
    for (std::size_t k = 0; k < given.size(); ++k) {
      const std::string entry = place + "/" + std::to_string(k);
      material.diffusivity.push_back(matrix(given[k], entry));
      if (k != 1) refuse_below(material.diffusivity.back(), false, entry, "an entry of the tensor's diagonal");
    }
    const auto& xx = material.diffusivity[0].constant();
    const auto& xy = material.diffusivity[1].constant();
    const auto& yy = material.diffusivity[2].constant();
    if (xx && xy && yy && !(*xx * *yy > *xy * *xy))
      throw InputError(place, "[" + describe_number(*xx) + ", " + describe_number(*xy) + ", " + describe_number(*yy) +
                                  "] is not positive definite: xx yy should be above xy xy");
  }

  DiffusionMaterial make_material(const ProblemMaterial& given, const std::string& place) {
    DiffusionMaterial material;
    if (given.diffusivity.empty())
      material.diffusivity = {Coefficient(1, place + "/diffusivity: 1 (default)")};
    else
      add_diffusivity(given.diffusivity, place + "/diffusivity", material);
    material.capacity = given.capacity ? matrix(*given.capacity, place + "/capacity")
                                       : Coefficient(1, place + "/capacity: 1 (default)");
    refuse_below(material.capacity, false, place + "/capacity", "the capacity");
    if (given.source) material.source = load(*given.source, place + "/source");
    return material;
  }

  // -- conditions

  DiffusionCondition make_condition(const ProblemCondition& given, const std::string& place) {
    using Kind = DiffusionCondition::Kind;
    DiffusionCondition condition;
    condition.place = place;
    const std::string member = place + "/" + condition_name(given.kind);
    switch (given.kind) {
      case ProblemCondition::Kind::value:
        condition.kind = Kind::value;
        condition.first = load(given.first, member);
        break;
      case ProblemCondition::Kind::flux:
        condition.kind = Kind::flux;
        condition.first = load(given.first, member);
        break;
      case ProblemCondition::Kind::robin:
        condition.kind = Kind::robin;
        condition.second = load(given.second, member + "/ambient");
        [[fallthrough]];
      case ProblemCondition::Kind::jump:
        if (given.kind == ProblemCondition::Kind::jump) condition.kind = Kind::jump;
        condition.first = matrix(given.first, member + "/transfer");
        refuse_below(condition.first, true, member + "/transfer", "the transfer");
    }
    return condition;
  }

  /// May condition k, which stands at `place`, stand on this curve?
  void check_condition(std::size_t k, int c, const std::string& place) const {
    if (given_.conditions[k].kind != ProblemCondition::Kind::jump) return;
    const Curve& curve = boundary_.curves[index(c)];
    if (is_outer(curve))
      throw InputError(place, describe_curve(boundary_, c) +
                                  " is part of the outer boundary: the unknown can only jump between two faces; "
                                  "\"robin\" lets it cross to an ambient");
    if (curve.left == curve.right)
      throw InputError(place, describe_curve(boundary_, c) + " has the face \"" +
                                  boundary_.faces[index(curve.left)].name +
                                  "\" on both sides: the unknown can only jump between two faces");
  }

  void add_conditions() {
    CurveConditions on_curves(boundary_, section_, [this](std::size_t k, int curve, const std::string& place) {
      check_condition(k, curve, place);
    });
    for (const ProblemCondition& given : given_.conditions) {
      problem_.conditions.push_back(make_condition(given, on_curves.place()));
      on_curves.add(given.curves);
    }
    problem_.condition_of_curve = on_curves.finish();
  }

  // -- initial values

  void add_initial() {
    const bool is_for_all = given_.initial.size() == 1 && given_.initial.front().first == "*";
    problem_.initial = by_face(
        boundary_, given_.initial,
        [&](const std::string& name) { return section_ + "/initial" + (is_for_all ? "" : pointer_step(name)); },
        [this](const ProblemExpression& expression, const std::string& place) {
          CompiledCoefficient compiled = names_.compile(expression, place);
          if (compiled.uses_unknown)
            throw InputError(place, "uses the unknown \"" + given_.field + "\", which has no values before these");
          return std::move(compiled.coefficient);
        });
  }

  std::string section_;
  const DiffuseSection& given_;
  const Mesh& mesh_;
  const BoundaryComplex& boundary_;
  ProblemNames names_;
  DiffusionProblem problem_;
};

}  // namespace

DiffusionProblem make_diffusion_problem(const ProblemDocument& problem, const Mesh& mesh) {
  return DiffusionBuilder(problem, mesh).build();
}

}  // namespace pliant
