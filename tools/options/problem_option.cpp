// tools/options/problem_option.cpp: reads a problem once, and gives it to every mesh.
#include "options/problem_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "formats/document/byte_source.h"
#include "formats/document/document_reader.h"
#include "formats/document/recognize.h"
#include "formats/problem/names.h"
#include "formats/problem/problem_json.h"
#include "options/numbers.h"
#include "problem/diffusion.h"
#include "problem/incompressible.h"
#include "problem/problem_names.h"
#include "run/documents.h"
#include "run/doubts.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

/// All bytes of a file.   Throws Placed where there are more than any problem has
std::string read_whole(const std::string& path) {
  constexpr std::size_t most = std::size_t{64} << 20;
  const InputFile file = open_input(path);
  ByteSource source(file.get(), path);
  std::string text;
  for (std::size_t got = 1; got > 0;) {
    constexpr std::size_t part = 1 << 16;
    const std::size_t size = text.size();
    text.resize(size + part);
    got = source.read(text.data() + size, part);
    text.resize(size + got);
    if (text.size() <= most) continue;
    const std::string other = describe_other_kind(text, FileKind::problem);
    throw Placed(status::bad_input,
                 path + ": is larger than any problem (64 MB)" + (other.empty() ? "" : ": " + other));
  }
  return text;
}

/// "problem.json:12: "; CBOR has no lines.
std::string line_of(const std::string& file, const DocumentPlace& place) {
  return file + (place.byte >= 0 ? ": " : ":" + std::to_string(place.line) + ": ");
}

/// Runs `work` on the problem of a file; a fault that it finds gets the file's place.
void with_file(const std::string& file, std::string_view text, const std::function<void()>& work) {
  constexpr std::string_view carried = "/problem";
  try {
    work();
  } catch (const InputError& e) {
    std::string pointer = e.pointer();
    if (!pointer.starts_with(carried)) throw;
    pointer.erase(0, carried.size());
    const DocumentPlace place = find_place(text, pointer);
    throw InputError("", line_of(file, place) + at_pointer(pointer, with_offset(e.what(), place)));
  }
}

}  // namespace

void ProblemOption::add(CLI::App& app) {
  app.add_option("--problem", file_,
                 "what to solve: a problem document, which the mesh carries from then on; without it the mesh carries "
                 "one already")
      ->type_name("FILE");
  app.add_option("--set", set_texts_, "give a parameter of the problem this value (repeatable)")
      ->type_name("PARAMETER=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--explain", wants_explanation_,
               "print what stands on each face and curve, unknowns and memory; solve nothing");
}

void ProblemOption::check(const CLI::App& app) {
  set_.clear();
  for (const std::string& text : set_texts_) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw UsageError("--set " + text + ": NAME=VALUE is wanted");
    const std::string name = text.substr(0, equals);
    if (std::ranges::find(set_, name, &std::pair<std::string, double>::first) != set_.end())
      throw UsageError("--set " + text + ": " + name + " is given twice");
    set_.emplace_back(name, parse_number("--set " + name, text.substr(equals + 1)));
  }
  carried_ = nullptr;
  if (app.count("--problem") > 0) read_file();
}

void ProblemOption::read_file() {
  if (file_ == "-") throw UsageError("--problem wants a file: standard input is for meshes");
  text_ = read_whole(file_);
  try {
    problem_ = read_problem(text_);
  } catch (const DocumentError& e) {
    const std::string other = describe_other_kind(text_, FileKind::problem);
    if (!other.empty()) throw Placed(status::bad_input, file_ + ": --problem wants a problem document; " + other);
    const std::string hint = e.pointer() == "/format" ? "; --problem wants a problem document" : "";
    throw Placed(status::bad_input, line_of(file_, e.place()) + at_pointer(e.pointer(), e.what()) + hint);
  }
  set_parameters(problem_);
  try {
    with_file(file_, text_, [this] { parameter_values(problem_); });
  } catch (const InputError& e) {
    throw Placed(status::bad_input, e.what());
  }
  carried_ = problem_value(problem_);
}

void ProblemOption::set_parameters(ProblemDocument& problem) const {
  for (const auto& [name, value] : set_) {
    const auto parameter =
        std::ranges::find(problem.parameters, name, &std::pair<std::string, ProblemExpression>::first);
    if (parameter == problem.parameters.end()) {
      std::vector<std::string> names;
      for (const auto& each : problem.parameters) names.push_back(each.first);
      throw UsageError("--set: the problem has no parameter \"" + name + "\"" + known_names(name, "parameters", names));
    }
    parameter->second = value;
  }
}

ProblemDocument ProblemOption::load(Mesh& mesh) const {
  const auto member = std::ranges::find(mesh.extra, "problem", &ExtraMembers::value_type::first);
  if (carried_ == nullptr && member == mesh.extra.end())
    throw InputError("",
                     "what is to be solved is not known: the mesh carries no member \"problem\"; --problem FILE "
                     "gives it one");
  const auto carry = [&](std::shared_ptr<const DocumentValue> value) {
    if (member == mesh.extra.end())
      mesh.extra.emplace_back("problem", std::move(value));
    else
      member->second = std::move(value);
  };
  if (carried_ != nullptr) {
    carry(carried_);
    return problem_;
  }
  ProblemDocument problem = read_problem(*member->second);
  if (!set_.empty()) {
    set_parameters(problem);
    carry(problem_value(problem));
  }
  return problem;
}

DiffusionProblem ProblemOption::make_diffusion(const ProblemDocument& problem, const Mesh& mesh) const {
  DiffusionProblem diffusion;
  in_problem([&] { diffusion = make_diffusion_problem(problem, mesh); });
  return diffusion;
}

FlowProblem ProblemOption::make_flow(const ProblemDocument& problem, const Mesh& mesh) const {
  FlowProblem flow;
  in_problem([&] { flow = make_flow_problem(problem, mesh); });
  return flow;
}

void ProblemOption::in_problem(const std::function<void()>& work) const {
  if (carried_ == nullptr) return work();
  with_file(file_, text_, work);
}

}  // namespace pliant
