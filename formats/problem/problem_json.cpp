// formats/problem/problem_json.cpp: the problem document, formats/problem.md.
#include "formats/problem/problem_json.h"

#include <initializer_list>

#include "formats/document/boundary_json.h"
#include "formats/document/mesh_json.h"
#include "formats/document/presence.h"
#include "formats/problem/names.h"

namespace pliant {
namespace {

using Kind = ProblemCondition::Kind;

/// Refuses the member now being read: whoever wrote it meant something by it, and nothing would act on it.
[[noreturn]] void refuse_member(const JsonReader& in, std::string_view name, const std::vector<std::string>& known) {
  in.fail("is not known here" + known_names(name, "members", known));
}

ProblemExpression read_expression(JsonReader& in) {
  const char c = in.peek();
  if (c == '"') return in.string();
  if (c != '-' && (c < '0' || c > '9')) in.fail("should be a number, or an expression in quotes");
  return in.number();
}

/// An array of expressions, as many as `count`; `what` they are.
std::vector<ProblemExpression> read_expressions(JsonReader& in, std::size_t count, const char* what) {
  std::vector<ProblemExpression> parts;
  in.array([&] {
    if (parts.size() == count) in.fail(std::string("is one too many: ") + what);
    parts.push_back(read_expression(in));
  });
  if (parts.size() != count) in.fail(std::string("has too few: ") + what);
  return parts;
}

std::string read_name(JsonReader& in) {
  if (in.peek() != '"') in.fail("should be a name in quotes");
  return in.string();
}

std::vector<std::pair<std::string, ProblemExpression>> read_parameters(JsonReader& in) {
  std::vector<std::pair<std::string, ProblemExpression>> parameters;
  in.object([&](std::string_view name) {
    if (const std::string fault = fault_of_name(name); !fault.empty()) in.fail("cannot be a parameter: " + fault);
    parameters.emplace_back(std::string(name), read_expression(in));
    return true;
  });
  return parameters;
}

ProblemMaterial read_material(JsonReader& in) {
  ProblemMaterial material;
  in.object([&](std::string_view name) {
    if (name == "diffusivity") {
      material.diffusivity =
          in.peek() == '[' ? read_expressions(in, 3, "a tensor is [xx, xy, yy]") : std::vector{read_expression(in)};
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

std::vector<std::string> read_curves(JsonReader& in) {
  if (in.peek() != '[') return {read_name(in)};
  std::vector<std::string> names;
  in.array([&] { names.push_back(read_name(in)); });
  if (names.empty()) in.fail("should name a curve");
  return names;
}

/// The object of `robin` or `jump`, whose members are all required.
void read_transfer(JsonReader& in, ProblemCondition& condition) {
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

ProblemCondition read_condition(JsonReader& in) {
  ProblemCondition condition;
  std::string kind;
  Presence seen(in);
  const auto set_kind = [&](std::string_view name, Kind value) {
    if (!kind.empty()) in.fail("stands beside \"" + kind + "\": a condition has one of them");
    kind = name;
    condition.kind = value;
  };
  in.object([&](std::string_view name) {
    if (seen.is(name, "curve")) {
      condition.curves = read_curves(in);
    } else if (name == "value" || name == "flux") {
      set_kind(name, name == "value" ? Kind::value : Kind::flux);
      condition.first = read_expression(in);
    } else if (name == "robin" || name == "jump") {
      set_kind(name, name == "robin" ? Kind::robin : Kind::jump);
      read_transfer(in, condition);
    } else {
      refuse_member(in, name, {"curve", "value", "flux", "robin", "jump"});
    }
    return true;
  });
  seen.require({"curve"});
  if (kind.empty()) in.fail("says nothing of its curve: \"value\", \"flux\", \"robin\" or \"jump\" is wanted");
  return condition;
}

std::vector<std::pair<std::string, ProblemExpression>> read_initial(JsonReader& in) {
  std::vector<std::pair<std::string, ProblemExpression>> initial;
  if (in.peek() != '{') {
    initial.emplace_back("*", read_expression(in));
    return initial;
  }
  in.object([&](std::string_view face) {
    initial.emplace_back(std::string(face), read_expression(in));
    return true;
  });
  return initial;
}

DiffuseSection read_diffuse(JsonReader& in) {
  DiffuseSection section;
  Presence seen(in);
  in.object([&](std::string_view name) {
    if (seen.is(name, "field")) {
      section.field = read_name(in);
      if (section.field.empty()) in.fail("should be the name of the unknown, not empty");
    } else if (seen.is(name, "materials")) {
      in.object([&](std::string_view face) {
        section.materials.emplace_back(std::string(face), read_material(in));
        return true;
      });
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

ProblemDocument read_document(JsonReader& in) {
  ProblemDocument problem;
  Presence seen(in);
  in.object(problem.extra, [&](std::string_view name) {
    if (seen.is(name, "format"))
      read_format(in, "pliant-problem");
    else if (seen.is(name, "version"))
      read_version(in);
    else if (seen.is(name, "parameters"))
      problem.parameters = read_parameters(in);
    else if (seen.is(name, "diffuse"))
      problem.diffuse = read_diffuse(in);
    else
      return false;
    return true;
  });
  seen.require({"format", "version"}, problem.extra);
  for (const auto& [name, value] : problem.extra)
    for (const char* member : {"parameters", "diffuse"})
      if (!seen.has(member) && is_misspelling(name, member))
        in.fail("is not known; is \"" + std::string(member) + "\" meant?", pointer_step(name));
  return problem;
}

// -- writing

void write_expression(JsonWriter& out, const ProblemExpression& expression) {
  if (const double* number = std::get_if<double>(&expression))
    out.value(*number);
  else
    out.value(std::get<std::string>(expression));
}

/// One expression as such, several as an array.
void write_expressions(JsonWriter& out, const std::vector<ProblemExpression>& expressions) {
  if (expressions.size() == 1) return write_expression(out, expressions.front());
  out.begin_array();
  for (const ProblemExpression& each : expressions) write_expression(out, each);
  out.end_array();
}

void write_condition(JsonWriter& out, const ProblemCondition& condition) {
  out.begin_object().name("curve");
  if (condition.curves.size() == 1) {
    out.value(condition.curves.front());
  } else {
    out.begin_array();
    for (const std::string& name : condition.curves) out.value(name);
    out.end_array();
  }
  const bool has_object = condition.kind == Kind::robin || condition.kind == Kind::jump;
  out.name(condition_name(condition.kind));
  if (has_object) out.begin_object().name("transfer");
  write_expression(out, condition.first);
  if (condition.kind == Kind::robin) write_expression(out.name("ambient"), condition.second);
  if (has_object) out.end_object();
  out.end_object();
}

void write_material(JsonWriter& out, const ProblemMaterial& material) {
  out.begin_object();
  if (!material.diffusivity.empty()) write_expressions(out.name("diffusivity"), material.diffusivity);
  if (material.capacity) write_expression(out.name("capacity"), *material.capacity);
  if (material.source) write_expression(out.name("source"), *material.source);
  out.end_object();
}

void write_diffuse(JsonWriter& out, const DiffuseSection& section) {
  out.begin_object().name("field").value(section.field).name("materials").begin_object();
  for (const auto& [face, material] : section.materials) write_material(out.name(face), material);
  out.end_object().name("conditions").begin_array();
  for (const ProblemCondition& condition : section.conditions) write_condition(out, condition);
  out.end_array();
  if (section.initial.size() == 1 && section.initial.front().first == "*") {
    write_expression(out.name("initial"), section.initial.front().second);
  } else if (!section.initial.empty()) {
    out.name("initial").begin_object();
    for (const auto& [face, expression] : section.initial) write_expression(out.name(face), expression);
    out.end_object();
  }
  if (!section.convection.empty()) write_expressions(out.name("convection"), section.convection);
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

ProblemDocument read_problem(std::string_view json) {
  JsonReader in(json);
  ProblemDocument problem = read_document(in);
  in.finish();
  return problem;
}

ProblemDocument read_problem(const DocumentValue& value) {
  try {
    return read_problem(write_value(value));
  } catch (const DocumentError& e) {
    // Line and column are those of a text that nobody has seen.
    std::string text = e.what();
    const std::string column = with_column("", {e.line(), e.column()});
    if (text.ends_with(column)) text.resize(text.size() - column.size());
    throw InputError("/problem" + e.pointer(), text);
  }
}

void write_problem(const ProblemDocument& problem, std::string& out) {
  JsonWriter writer(out);
  writer.begin_object().name("format").value("pliant-problem").name("version").value(1);
  writer.name("parameters").begin_object();
  for (const auto& [name, value] : problem.parameters) write_expression(writer.name(name), value);
  writer.end_object();
  if (problem.diffuse) write_diffuse(writer.name("diffuse"), *problem.diffuse);
  writer.members(problem.extra);
  writer.end_object();
  out += '\n';
}

std::shared_ptr<const DocumentValue> problem_value(const ProblemDocument& problem) {
  std::string text;
  write_problem(problem, text);
  return read_value(text);
}

}  // namespace pliant
