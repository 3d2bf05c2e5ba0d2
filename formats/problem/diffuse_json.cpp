// formats/problem/diffuse_json.cpp: the section `diffuse`, formats/problem.md.
#include "formats/problem/diffuse_json.h"

#include "formats/document/presence.h"
#include "formats/problem/section_json.h"

namespace pliant {
namespace {

using Kind = ProblemCondition::Kind;

ProblemMaterial read_material(DocumentReader& in) {
  ProblemMaterial material;
  in.object([&](std::string_view name) {
    if (name == "diffusivity") {
      material.diffusivity = in.kind() == DocumentReader::Kind::array
                                 ? read_expressions(in, 3, "a tensor is [xx, xy, yy]")
                                 : std::vector{read_expression(in)};
    } else if (name == "capacity") {
      material.capacity = read_expression(in);
    } else if (name == "source") {
      material.source = read_expression(in);
    } else {
      refuse_member(in, name, {"diffusivity", "capacity", "source"});
    }
    return true;
  });
  return material;
}

/// The object of `robin` or `jump`, whose members are all required.
void read_transfer(DocumentReader& in, ProblemCondition& condition) {
  const bool has_ambient = condition.kind == Kind::robin;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "transfer"))
      condition.first = read_expression(in);
    else if (has_ambient && seen.is(name, "ambient"))
      condition.second = read_expression(in);
    else
      refuse_member(
          in, name,
          has_ambient ? std::vector<std::string>{"transfer", "ambient"} : std::vector<std::string>{"transfer"});
    return true;
  });
  seen.require({"transfer"});
  if (has_ambient) seen.require({"ambient"});
}

ProblemCondition read_condition(DocumentReader& in) {
  ProblemCondition condition;
  ConditionKind kind(in);
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "curve")) {
      condition.curves = read_curves(in);
    } else if (name == "value" || name == "flux") {
      kind.set(name);
      condition.kind = name == "value" ? Kind::value : Kind::flux;
      condition.first = read_expression(in);
    } else if (name == "robin" || name == "jump") {
      kind.set(name);
      condition.kind = name == "robin" ? Kind::robin : Kind::jump;
      read_transfer(in, condition);
    } else {
      refuse_member(in, name, {"curve", "value", "flux", "robin", "jump"});
    }
    return true;
  });
  seen.require({"curve"});
  kind.require({"value", "flux", "robin", "jump"});
  return condition;
}

std::vector<std::pair<std::string, ProblemExpression>> read_initial(DocumentReader& in) {
  if (in.kind() == DocumentReader::Kind::object) return read_by_name(in, read_expression);
  return {{"*", read_expression(in)}};
}

// -- writing

void write_condition(DocumentWriter& out, const ProblemCondition& condition) {
  out.begin_object().name("curve");
  write_curves(out, condition.curves);
  const bool has_object = condition.kind == Kind::robin || condition.kind == Kind::jump;
  out.name(condition_name(condition.kind));
  if (has_object) out.begin_object().name("transfer");
  write_expression(out, condition.first);
  if (condition.kind == Kind::robin) write_expression(out.name("ambient"), condition.second);
  if (has_object) out.end_object();
  out.end_object();
}

void write_material(DocumentWriter& out, const ProblemMaterial& material) {
  out.begin_object();
  if (!material.diffusivity.empty()) write_expressions(out.name("diffusivity"), material.diffusivity);
  if (material.capacity) write_expression(out.name("capacity"), *material.capacity);
  if (material.source) write_expression(out.name("source"), *material.source);
  out.end_object();
}

}  // namespace

const char* condition_name(ProblemCondition::Kind kind) {
  switch (kind) {
    case Kind::value:
      return "value";
    case Kind::flux:
      return "flux";
    case Kind::robin:
      return "robin";
    default:
      return "jump";
  }
}

DiffuseSection read_diffuse(DocumentReader& in) {
  DiffuseSection section;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "field")) {
      section.field = read_name(in);
      if (section.field.empty()) in.fail("should be the name of the unknown, not empty");
    } else if (seen.is(name, "materials")) {
      section.materials = read_by_name(in, read_material);
    } else if (name == "conditions") {
      in.array([&] { section.conditions.push_back(read_condition(in)); });
    } else if (name == "initial") {
      section.initial = read_initial(in);
    } else if (name == "convection") {
      section.convection = read_expressions(in, 2, "a velocity is [EXPR, EXPR]");
    } else {
      refuse_member(in, name, {"field", "materials", "conditions", "initial", "convection"});
    }
    return true;
  });
  seen.require({"field", "materials"});
  return section;
}

void write_diffuse(DocumentWriter& out, const DiffuseSection& section) {
  out.begin_object().name("field").value(section.field);
  write_by_name(out.name("materials"), section.materials, write_material);
  out.name("conditions").begin_array();
  for (const ProblemCondition& condition : section.conditions) write_condition(out, condition);
  out.end_array();
  if (section.initial.size() == 1 && section.initial.front().first == "*")
    write_expression(out.name("initial"), section.initial.front().second);
  else if (!section.initial.empty())
    write_by_name(out.name("initial"), section.initial, write_expression);
  if (!section.convection.empty()) write_expressions(out.name("convection"), section.convection);
  out.end_object();
}

}  // namespace pliant
