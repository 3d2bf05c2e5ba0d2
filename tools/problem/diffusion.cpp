// tools/problem/diffusion.cpp: names become indices, texts become coefficients; all that does not fit is refused.
#include "problem/diffusion.h"

#include <algorithm>
#include <map>
#include <span>

#include "formats/problem/names.h"
#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/describe.h"
#include "problem/problem_names.h"

namespace pliant {
namespace {

constexpr const char* section = "/problem/diffuse";

std::vector<std::string> face_names(const BoundaryComplex& boundary) {
  std::vector<std::string> names;
  for (const Face& face : boundary.faces) names.push_back(face.name);
  return names;
}

std::vector<std::string> curve_names(const BoundaryComplex& boundary) {
  std::vector<std::string> names;
  for (const Curve& curve : boundary.curves)
    if (std::ranges::find(names, curve.name) == names.end()) names.push_back(curve.name);
  return names;
}

class Builder {
 public:
  Builder(const ProblemDocument& problem, const Mesh& mesh)
      : given_(*problem.diffuse), mesh_(mesh), boundary_(mesh.boundary()), names_(problem, mesh, given_.field) {}

  DiffusionProblem build() {
    problem_.field = given_.field;
    check_unknown();
    add_materials();
    add_conditions();
    add_initial();
    for (std::size_t k = 0; k < given_.convection.size(); ++k)
      problem_.convection.push_back(
          matrix(given_.convection[k], std::string(section) + "/convection/" + std::to_string(k)));
    return std::move(problem_);
  }

 private:
  void check_unknown() const {
    for (const Field& field : mesh_.fields())
      if (field.name == given_.field && field.components != 1)
        throw InputError(std::string(section) + "/field", "the mesh's field \"" + field.name + "\" has " +
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

  static void refuse_below(const Coefficient& coefficient, bool zero_is_allowed, const std::string& place,
                           const char* what) {
    const std::optional<double>& value = coefficient.constant();
    if (!value || *value > 0 || (zero_is_allowed && *value == 0)) return;
    throw InputError(place, std::string(what) + " is " + describe_number(*value) + ", but " +
                                (zero_is_allowed ? "should not be negative" : "should be above zero"));
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

  /// The index of a face that the problem names.
  std::size_t face_at(const std::string& name, const std::string& place) const {
    const int face = find_face(boundary_, name);
    if (face == outside)
      throw InputError(place, "there is no face \"" + name + "\"" + known_names(name, "faces", face_names(boundary_)));
    return index(face);
  }

  void add_materials() {
    std::vector<std::optional<DiffusionMaterial>> materials(boundary_.faces.size());
    std::optional<DiffusionMaterial> others;
    for (const auto& [name, given] : given_.materials) {
      const std::string place = std::string(section) + "/materials" + pointer_step(name);
      if (name == "*")
        others = make_material(given, place);
      else
        materials[face_at(name, place)] = make_material(given, place);
    }
    std::vector<std::string> bare;
    for (std::size_t f = 0; f < materials.size(); ++f) {
      if (materials[f])
        problem_.materials.push_back(std::move(*materials[f]));
      else if (others)
        problem_.materials.push_back(*others);
      else
        bare.push_back(boundary_.faces[f].name);
    }
    if (!bare.empty())
      throw InputError(std::string(section) + "/materials",
                       (bare.size() > 1 ? "the faces " : "the face ") + quote_names(bare) +
                           (bare.size() > 1 ? " have" : " has") +
                           " no material; \"*\" stands for all that are not named");
  }

  // -- conditions

  static std::string condition_place(std::size_t k) {
    return std::string(section) + "/conditions/" + std::to_string(k);
  }

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

  /// Sets condition k, which stands at `place`, on one curve.
  void set_condition(std::size_t c, std::size_t k, const std::string& place) {
    int& condition = problem_.condition_of_curve[c];
    const std::string curve = describe_curve(boundary_, static_cast<int>(c));
    if (condition != none)
      throw InputError(place, curve + (index(condition) == k ? " is named twice here"
                                                             : " has a condition already, that of conditions/" +
                                                                   std::to_string(condition)));
    const Curve& sides = boundary_.curves[c];
    if (given_.conditions[k].kind == ProblemCondition::Kind::jump) {
      if (sides.left == outside || sides.right == outside)
        throw InputError(place, curve +
                                    " is part of the outer boundary: the unknown can only jump between two faces; "
                                    "\"robin\" lets it cross to an ambient");
      if (sides.left == sides.right)
        throw InputError(place, curve + " has the face \"" + boundary_.faces[index(sides.left)].name +
                                    "\" on both sides: the unknown can only jump between two faces");
    }
    condition = static_cast<int>(k);
  }

  void add_conditions() {
    problem_.condition_of_curve.assign(boundary_.curves.size(), none);
    std::map<std::string, std::vector<std::size_t>> curves;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) curves[boundary_.curves[c].name].push_back(c);
    std::optional<std::pair<std::size_t, std::string>> others;  // which condition "*" has, and where it stands
    for (std::size_t k = 0; k < given_.conditions.size(); ++k) {
      const ProblemCondition& given = given_.conditions[k];
      problem_.conditions.push_back(make_condition(given, condition_place(k)));
      for (std::size_t n = 0; n < given.curves.size(); ++n) {
        const std::string& name = given.curves[n];
        const std::string place =
            condition_place(k) + "/curve" + (given.curves.size() > 1 ? "/" + std::to_string(n) : "");
        if (name == "*") {
          if (others)
            throw InputError(place,
                             "\"*\" has a condition already, that of conditions/" + std::to_string(others->first));
          others.emplace(k, place);
          continue;
        }
        const auto found = curves.find(name);
        if (found == curves.end())
          throw InputError(place,
                           "there is no curve \"" + name + "\"" + known_names(name, "curves", curve_names(boundary_)));
        for (const std::size_t c : found->second) set_condition(c, k, place);
      }
    }
    if (!others) return;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const Curve& curve = boundary_.curves[c];
      if (problem_.condition_of_curve[c] == none && (curve.left == outside || curve.right == outside))
        set_condition(c, others->first, others->second);
    }
  }

  // -- initial values

  void add_initial() {
    problem_.initial.resize(boundary_.faces.size());
    std::optional<Coefficient> others;
    for (const auto& [name, expression] : given_.initial) {
      std::string place = std::string(section) + "/initial";
      if (given_.initial.size() > 1 || name != "*") place += pointer_step(name);
      CompiledCoefficient compiled = names_.compile(expression, place);
      if (compiled.uses_unknown)
        throw InputError(place, "uses the unknown \"" + given_.field + "\", which has no values before these");
      if (name == "*")
        others = std::move(compiled.coefficient);
      else
        problem_.initial[face_at(name, place)] = std::move(compiled.coefficient);
    }
    if (!others) return;
    for (std::optional<Coefficient>& each : problem_.initial)
      if (!each) each = others;
  }

  const DiffuseSection& given_;
  const Mesh& mesh_;
  const BoundaryComplex& boundary_;
  ProblemNames names_;
  DiffusionProblem problem_;
};

}  // namespace

DiffusionProblem make_diffusion_problem(const ProblemDocument& problem, const Mesh& mesh) {
  if (!problem.diffuse) {
    std::vector<std::string> sections;
    for (const auto& [name, value] : problem.extra) sections.push_back(name);
    throw InputError("/problem", "lacks the section \"diffuse\"" +
                                     (sections.empty() ? "" : "; its other members are " + quote_names(sections)));
  }
  return Builder(problem, mesh).build();
}

}  // namespace pliant
