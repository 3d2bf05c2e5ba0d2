// tests/tools/problem_option_test.cpp: --problem and --set: where a problem comes from, and what is said of faults.
#include "options/problem_option.h"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <memory>
#include <system_error>

#include "problem_samples.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run_tools.h"

using namespace pliant;
using namespace pliant::testing;
using Catch::Matchers::Contains;

namespace {

const std::string document = R"({"format": "pliant-problem", "version": 1,
 "parameters": {"k": 0.5, "h": "2*k"},
 "diffuse": {"field": "u",
   "materials": {"*": {"diffusivity": "k", "capacity": "h"}}}})";

/// A problem option that has parsed and checked these words.
std::unique_ptr<ProblemOption> option_of(Words words) {
  auto option = std::make_unique<ProblemOption>();
  CLI::App app;
  option->add(app);
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  app.parse(words);
  option->check(app);
  return option;
}

double diffusivity(const ProblemOption& option, Mesh& mesh) {
  return *option.make_diffusion(option.load(mesh), mesh).materials[0].diffusivity[0].constant();
}
double capacity(const ProblemOption& option, Mesh& mesh) {
  return *option.make_diffusion(option.load(mesh), mesh).materials[0].capacity.constant();
}

/// What check says of a file with this text.
std::string said_of(const std::string& text, Words words = {}) {
  const TemporaryFile file(text);
  words.insert(words.begin(), {"--problem", file.path()});
  try {
    option_of(words);
  } catch (const Placed& e) {
    CHECK(e.status() == status::bad_input);
    CHECK(std::string(e.what()).starts_with(file.path() + ":"));
    return std::string(e.what()).substr(file.path().size());
  }
  return "accepted";
}

}  // namespace

TEST_CASE("the mesh carries the problem of the file from then on", "[tools][problem]") {
  const TemporaryFile file(document);
  const auto first = option_of({"--problem", file.path()}), later = option_of({});
  CHECK_FALSE(first->wants_explanation());
  CHECK(option_of({"--explain"})->wants_explanation());
  Mesh mesh = channel(1);
  mesh.extra.emplace_back("other", read_value("1"));
  CHECK(diffusivity(*first, mesh) == 0.5);
  CHECK(capacity(*first, mesh) == 1);
  CHECK(mesh.extra.size() == 2);
  // As another program reads it.
  Mesh read = mesh_of(document_of(mesh));
  CHECK(diffusivity(*later, read) == 0.5);
  CHECK(document_of(read) == document_of(mesh));
  CHECK_THAT(document_of(mesh), Contains(R"("problem":{"format":"pliant-problem","version":1,"parameters":{"k":0.5,)"));
}

TEST_CASE("a problem of a file takes the place of the one that the mesh carries", "[tools][problem]") {
  Mesh mesh = channel(1);
  mesh.extra.emplace_back("problem", read_value("17"));
  mesh.extra.emplace_back("other", read_value("1"));
  const TemporaryFile file(document);
  CHECK(diffusivity(*option_of({"--problem", file.path()}), mesh) == 0.5);
  CHECK(mesh.extra.size() == 2);
  CHECK(mesh.extra[0].first == "problem");
}

TEST_CASE("the option --set gives parameters other values, which the mesh carries, too", "[tools][problem]") {
  const TemporaryFile file(document);
  const auto set = option_of({"--problem", file.path(), "--set", "k=3"});
  const auto both = option_of({"--set", "h=7", "--set", "k=+1e-1"}), later = option_of({});
  Mesh mesh = channel(1);
  CHECK(diffusivity(*set, mesh) == 3);
  CHECK(capacity(*set, mesh) == 6);
  CHECK(diffusivity(*later, mesh) == 3);
  CHECK(diffusivity(*both, mesh) == 0.1);
  CHECK(capacity(*both, mesh) == 7);
  CHECK(capacity(*later, mesh) == 7);  // of what the mesh carries now
  CHECK(capacity(*set, mesh) == 6);
}

TEST_CASE("one option serves many meshes, and nothing of one is left for the next", "[tools][problem]") {
  const TemporaryFile file(R"({"format": "pliant-problem", "version": 1,
    "diffuse": {"field": "u", "materials": {"*": {"source": "w"}}}})");
  const auto option = option_of({"--problem", file.path()});
  Mesh with = channel(2), without = channel(1);
  set_field(with, "w", 1, none, [](const Point&, std::span<double> v) { v[0] = 2; });
  const auto source = [&](Mesh& mesh) {
    const DiffusionProblem problem = option->make_diffusion(option->load(mesh), mesh);
    return (*problem.materials[0].source)(point_of(mesh, TriangleId{0}, {1, 0, 0}));
  };
  CHECK(source(with) == 2);
  CHECK_THROWS_WITH(source(without), Contains("\"w\" is no name"));
  CHECK(source(with) == 2);
  Mesh again = with;
  CHECK(source(again) == 2);
  CHECK(document_of(again) == document_of(with));
}

TEST_CASE("a mesh without a problem, or with a faulty one, is refused", "[tools][problem]") {
  const auto option = option_of({});
  const auto refusal = [&](const ProblemOption& asked, const std::string& carried) {
    Mesh mesh = channel(1);
    if (!carried.empty()) mesh.extra.emplace_back("problem", read_value(carried));
    try {
      asked.make_diffusion(asked.load(mesh), mesh);
    } catch (const InputError& e) {
      return e.pointer() + ": " + e.what();
    }
    return std::string("accepted");
  };
  CHECK_THAT(refusal(*option, ""), Contains("carries no member \"problem\"") && Contains("--problem FILE"));
  CHECK_THAT(refusal(*option, "17"), Contains("/problem: should be an object"));
  CHECK_THAT(refusal(*option, R"({"format": "pliant-problem", "version": 1, "parameters": {"k": "q"}, "diffuse":
             {"field": "u", "materials": {}}})"),
             Contains("/problem/parameters/k: ") && Contains("\"q\" is no name"));
  CHECK(refusal(*option, document) == "accepted");
  Mesh mesh = channel(1);
  mesh.extra.emplace_back("problem", read_value(document));
  const auto unknown = option_of({"--set", "K=1"});
  CHECK_THROWS_AS(unknown->load(mesh), UsageError);
  CHECK_THROWS_WITH(unknown->load(mesh), Contains("no parameter \"K\"; the parameters are \"k\" and \"h\"") ||
                                             Contains("is \"k\" meant? the parameters are \"k\" and \"h\""));
  CHECK(write_value(*mesh.extra[0].second) == write_value(*read_value(document)));
}

TEST_CASE("a fault of the file on a mesh tells the line of the file", "[tools][problem]") {
  const TemporaryFile file(R"({"format": "pliant-problem", "version": 1,
    "diffuse": {"field": "u",
      "materials": {"*": {},
        "cel": {}}}})");
  const auto option = option_of({"--problem", file.path()});
  Mesh mesh = channel(1);
  const ProblemDocument problem = option->load(mesh);
  try {
    option->make_diffusion(problem, mesh);
    FAIL("accepted");
  } catch (const InputError& e) {
    CHECK(e.pointer().empty());
    CHECK_THAT(e.what(), Contains(file.path() + ":4: /diffuse/materials/cel: there is no face \"cel\"") &&
                             Contains("(column 16)"));
  }
}

TEST_CASE("a faulty file is refused with its place before any mesh is read", "[tools][problem]") {
  CHECK(said_of(document) == "accepted");
  CHECK_THAT(said_of(""), Contains("empty"));
  CHECK_THAT(said_of("{\n \"format\": 1}"), Contains(":2: /format: should be a string"));
  CHECK_THAT(said_of(document_of(channel(1))),
             Contains("this is a mesh") && Contains("--problem wants a problem document"));
  CHECK_THAT(said_of(R"({"format": "pliant-boundary", "version": 1})"),
             Contains("this is a boundary") && Contains("--problem wants a problem document"));
  CHECK_THAT(said_of("<svg/>"), Contains("SVG") && Contains("--problem wants a problem document"));
  CHECK_THAT(said_of("$MeshFormat\n"), Contains("MSH") && Contains("--problem wants a problem document"));
  CHECK_THAT(said_of(R"({"format": "pliant-problem",
    "version": 1, "parameters": {"a": 1,
     "b": "2*c"}})"),
             Contains(":3: /parameters/b: ") && Contains("\"c\" is no name"));
  CHECK_THAT(said_of(std::string(std::size_t{65} << 20, ' ')), Contains("larger than any problem"));
  CHECK_THROWS_AS(option_of({"--problem", "/nowhere/heat.json"}), std::system_error);
  CHECK_THROWS_AS(option_of({"--problem", std::filesystem::temp_directory_path().string()}), std::system_error);
  CHECK_THROWS_WITH(option_of({"--problem", "-"}), Contains("standard input is for meshes"));
}

TEST_CASE("the option makes the problem of a flow, too, and tells the line of the file", "[tools][problem]") {
  const TemporaryFile file(R"({"format": "pliant-problem", "version": 1, "parameters": {"mu": 2},
    "navierstokes": {
      "materials": {"*": {"viscosity": "mu"}},
      "conditions": [{"curve": "*", "velocity": [0, 0]},
        {"curve": "membrane", "outflow": true}]}})");
  const auto option = option_of({"--problem", file.path()});
  Mesh mesh = channel(1);
  const ProblemDocument problem = option->load(mesh);
  CHECK_THROWS_WITH(option->make_flow(problem, mesh),
                    Contains(file.path() + ":5: /navierstokes/conditions/1/curve: curve 'membrane' (4) lies between"));
  const TemporaryFile good(R"({"format": "pliant-problem", "version": 1, "parameters": {"mu": 2},
    "navierstokes": {"materials": {"*": {"viscosity": "mu"}}, "conditions": [{"curve": "*", "slip": true}]}})");
  const auto set = option_of({"--problem", good.path(), "--set", "mu=3"}), later = option_of({});
  CHECK(set->make_flow(set->load(mesh), mesh).materials[0].viscosity.constant() == 3);
  CHECK(later->make_flow(later->load(mesh), mesh).materials[0].viscosity.constant() == 3);
}

TEST_CASE("the option --set wants parameters of the problem and finite numbers", "[tools][problem]") {
  const TemporaryFile file(document);
  const auto refused = [&](Words words, const std::string& text) {
    words.insert(words.begin(), {"--problem", file.path()});
    CHECK_THROWS_AS(option_of(words), UsageError);
    CHECK_THROWS_WITH(option_of(words), Contains(text));
  };
  refused({"--set", "kk=1"}, "no parameter \"kk\"");
  refused({"--set", "kk=1"}, "the parameters are \"k\" and \"h\"");
  refused({"--set", "k"}, "NAME=VALUE is wanted");
  refused({"--set", "=1"}, "NAME=VALUE is wanted");
  refused({"--set", "k="}, "not a finite number");
  refused({"--set", "k=nan"}, "not a finite number");
  refused({"--set", "k=inf"}, "not a finite number");
  refused({"--set", "k=1=2"}, "not a finite number");
  refused({"--set", "k=2*h"}, "not a finite number");
  refused({"--set", "k=1", "--set", "k=2"}, "given twice");
  // A value may make what is computed from it no number, which is then the fault of the file.
  CHECK_THAT(
      said_of(R"({"format": "pliant-problem", "version": 1, "parameters": {"k": 1, "r": "1/k"}})", {"--set", "k=0"}),
      Contains("/parameters/r: \"1/k\" is inf"));
}

TEST_CASE("a problem as the input of another tool is named", "[tools][problem]") {
  CHECK(describe_other_format("pliant-problem") != "");
  CHECK_THAT(describe_other_kind(document, FileKind::svg),
             Contains("this is a problem, which diffuse and navierstokes read"));
}
