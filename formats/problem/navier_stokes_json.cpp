// formats/problem/navier_stokes_json.cpp: the section `navierstokes`, formats/problem.md.
#include "formats/problem/navier_stokes_json.h"

#include <algorithm>
#include <array>

#include "formats/document/presence.h"
#include "formats/problem/section_json.h"

namespace pliant {
namespace {

using FlowKind = NavierStokesCondition::Kind;
using Pressure = NavierStokesSection::Pressure;

constexpr std::array kinds{FlowKind::velocity, FlowKind::slip, FlowKind::traction, FlowKind::outflow,
                           FlowKind::natural};

bool has_components(FlowKind kind) { return kind == FlowKind::velocity || kind == FlowKind::traction; }

NavierStokesMaterial read_fluid(DocumentReader& in) {
  NavierStokesMaterial material;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "density"))
      material.density = read_expression(in);
    else if (seen.is(name, "viscosity"))
      material.viscosity = read_expression(in);
    else
      refuse_member(in, name, {"density", "viscosity"});
    return true;
  });
  seen.require({"viscosity"});
  return material;
}

/// The value of the member that says of which kind a condition is.
void read_kind(DocumentReader& in, NavierStokesCondition& condition) {
  if (has_components(condition.kind)) {
    condition.components = read_expressions(
        in, 2, condition.kind == FlowKind::velocity ? "a velocity is [EXPR, EXPR]" : "a traction is [EXPR, EXPR]");
  } else if (!in.boolean()) {
    in.fail("should be true: a condition that does not hold is left out");
  }
}

NavierStokesCondition read_flow_condition(DocumentReader& in) {
  NavierStokesCondition condition;
  ConditionKind kind(in);
  Presence seen(in);
  in.object([&](std::string_view name) {
    const auto* const named =
        std::ranges::find_if(kinds, [name](FlowKind each) { return name == condition_name(each); });
    if (seen.is(name, "curve")) {
      condition.curves = read_curves(in);
    } else if (named != kinds.end()) {
      kind.set(name);
      condition.kind = *named;
      read_kind(in, condition);
    } else if (name == "moves") {
      condition.moves = in.boolean();
    } else {
      refuse_member(in, name, {"curve", "velocity", "slip", "traction", "outflow", "natural", "moves"});
    }
    return true;
  });
  seen.require({"curve"});
  kind.require({"velocity", "slip", "traction", "outflow", "natural"});
  return condition;
}

std::vector<std::pair<std::string, ProblemExpression>> read_surface_tension(DocumentReader& in) {
  std::vector<std::pair<std::string, ProblemExpression>> entries;
  in.object([&](std::string_view curve) {
    if (curve == "*") in.fail("is no curve: each curve with surface tension is named");
    entries.emplace_back(std::string(curve), read_expression(in));
    return true;
  });
  return entries;
}

Pressure read_pressure(DocumentReader& in) {
  const std::string text = in.kind() == DocumentReader::Kind::string ? in.string() : "";
  for (const Pressure each : {Pressure::by_face, Pressure::continuous})
    if (text == pressure_name(each)) return each;
  in.fail(R"(should be "by-face" or "continuous")");
}

void write_fluid(DocumentWriter& out, const NavierStokesMaterial& material) {
  out.begin_object();
  if (material.density) write_expression(out.name("density"), *material.density);
  write_expression(out.name("viscosity"), material.viscosity);
  out.end_object();
}

void write_flow_condition(DocumentWriter& out, const NavierStokesCondition& condition) {
  out.begin_object().name("curve");
  write_curves(out, condition.curves);
  out.name(condition_name(condition.kind));
  if (has_components(condition.kind))
    write_expressions(out, condition.components);
  else
    out.value(true);
  if (condition.moves) out.name("moves").value(*condition.moves);
  out.end_object();
}

}  // namespace

const char* condition_name(NavierStokesCondition::Kind kind) {
  switch (kind) {
    case FlowKind::velocity:
      return "velocity";
    case FlowKind::slip:
      return "slip";
    case FlowKind::traction:
      return "traction";
    case FlowKind::outflow:
      return "outflow";
    default:
      return "natural";
  }
}

const char* pressure_name(Pressure pressure) { return pressure == Pressure::by_face ? "by-face" : "continuous"; }

NavierStokesSection read_navier_stokes(DocumentReader& in) {
  NavierStokesSection section;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "materials"))
      section.materials = read_by_name(in, read_fluid);
    else if (name == "conditions")
      in.array([&] { section.conditions.push_back(read_flow_condition(in)); });
    else if (name == "surface_tension")
      section.surface_tension = read_surface_tension(in);
    else if (name == "gravity")
      section.gravity = read_expressions(in, 2, "an acceleration is [EXPR, EXPR]");
    else if (name == "force")
      section.force = read_expressions(in, 2, "a force is [EXPR, EXPR]");
    else if (name == "initial")
      section.initial = read_expressions(in, 2, "a velocity is [EXPR, EXPR]");
    else if (name == "pressure")
      section.pressure = read_pressure(in);
    else
      refuse_member(in, name,
                    {"materials", "conditions", "surface_tension", "gravity", "force", "initial", "pressure"});
    return true;
  });
  seen.require({"materials"});
  return section;
}

void write_navier_stokes(DocumentWriter& out, const NavierStokesSection& section) {
  out.begin_object();
  write_by_name(out.name("materials"), section.materials, write_fluid);
  out.name("conditions").begin_array();
  for (const NavierStokesCondition& condition : section.conditions) write_flow_condition(out, condition);
  out.end_array();
  if (!section.surface_tension.empty())
    write_by_name(out.name("surface_tension"), section.surface_tension, write_expression);
  if (!section.gravity.empty()) write_expressions(out.name("gravity"), section.gravity);
  if (!section.force.empty()) write_expressions(out.name("force"), section.force);
  if (!section.initial.empty()) write_expressions(out.name("initial"), section.initial);
  if (section.pressure) out.name("pressure").value(pressure_name(*section.pressure));
  out.end_object();
}

}  // namespace pliant
