// formats/problem/problem_json.cpp: the problem document, formats/problem.md.
#include "formats/problem/problem_json.h"

#include "formats/document/boundary_document.h"
#include "formats/document/mesh_document.h"
#include "formats/document/presence.h"
#include "formats/document/write_json.h"
#include "formats/problem/diffuse_json.h"
#include "formats/problem/names.h"
#include "formats/problem/navier_stokes_json.h"
#include "formats/problem/section_json.h"

namespace pliant {
namespace {

std::vector<std::pair<std::string, ProblemExpression>> read_parameters(DocumentReader& in) {
  std::vector<std::pair<std::string, ProblemExpression>> parameters;
  in.object([&](std::string_view name) {
    if (const std::string fault = fault_of_name(name); !fault.empty()) in.fail("cannot be a parameter: " + fault);
    parameters.emplace_back(std::string(name), read_expression(in));
    return true;
  });
  return parameters;
}

ProblemDocument read_document(DocumentReader& in) {
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
    else if (seen.is(name, "navierstokes"))
      problem.navierstokes = read_navier_stokes(in);
    else
      return false;
    return true;
  });
  seen.require({"format", "version"}, problem.extra);
  for (const auto& [name, value] : problem.extra)
    for (const char* member : {"parameters", "diffuse", "navierstokes"})
      if (!seen.has(member) && is_misspelling(name, member))
        in.fail("is not known; is \"" + std::string(member) + "\" meant?", pointer_step(name));
  return problem;
}

}  // namespace

ProblemDocument read_problem(std::string_view document) {
  const auto in = reader_of(document);
  ProblemDocument problem = read_document(*in);
  in->finish();
  return problem;
}

ProblemDocument read_problem(const DocumentValue& value) {
  try {
    return read_problem(write_value(value));
  } catch (const DocumentError& e) {
    // The place is one in a text that nobody has seen.
    throw InputError("/problem" + e.pointer(), e.text());
  }
}

void write_problem(const ProblemDocument& problem, std::string& out) {
  JsonWriter writer(out);
  writer.begin_object().name("format").value("pliant-problem").name("version").value(1);
  write_by_name(writer.name("parameters"), problem.parameters, write_expression);
  if (problem.diffuse) write_diffuse(writer.name("diffuse"), *problem.diffuse);
  if (problem.navierstokes) write_navier_stokes(writer.name("navierstokes"), *problem.navierstokes);
  writer.members(problem.extra);
  writer.end_object().end();
}

std::shared_ptr<const DocumentValue> problem_value(const ProblemDocument& problem) {
  std::string text;
  write_problem(problem, text);
  return read_value(text);
}

}  // namespace pliant
