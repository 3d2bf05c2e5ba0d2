// tests/formats/problem/problem_test.cpp: the problem document is lossless and strict, and says where it is wrong.
#include <catch2/catch.hpp>
#include <random>
#include <sstream>
#include <string>

#include "formats/document/mesh_document.h"
#include "formats/document/read_json.h"
#include "formats/problem/names.h"
#include "formats/problem/problem_json.h"
#include "problem_texts.h"

using namespace pliant;
using namespace pliant::testing;
using Catch::Matchers::Contains;

namespace {

/// A document whose section `diffuse` has this material, or these conditions.
std::string with_diffuse(const std::string& section) { return with_section("diffuse", section); }
std::string with_material(const std::string& material) {
  return with_diffuse(R"({"field": "u", "materials": {"a/b": )" + material + "}}");
}
std::string with_conditions(const std::string& conditions) {
  return with_diffuse(R"({"field": "u", "materials": {}, "conditions": [)" + conditions + "]}");
}
std::string with_parameters(const std::string& parameters) { return with_section("parameters", parameters); }

}  // namespace

TEST_CASE("the example of the page is read as the page says", "[formats][problem]") {
  using Kind = ProblemCondition::Kind;
  const ProblemDocument problem = read_problem(example(0));
  REQUIRE(problem.parameters.size() == 3);
  CHECK(problem.parameters[0] == std::pair<std::string, ProblemExpression>("k", 0.1));
  CHECK(problem.parameters[2] == std::pair<std::string, ProblemExpression>("k_cell", "contrast*k"));
  REQUIRE(problem.diffuse);
  const DiffuseSection& diffuse = *problem.diffuse;
  CHECK(diffuse.field == "temperature");
  REQUIRE(diffuse.materials.size() == 2);
  CHECK(diffuse.materials[0].first == "cell");
  CHECK(diffuse.materials[0].second.diffusivity == std::vector<ProblemExpression>{"k_cell"});
  CHECK(diffuse.materials[0].second.capacity == ProblemExpression(4.0));
  CHECK_FALSE(diffuse.materials[0].second.source);
  CHECK(diffuse.materials[1].first == "*");
  CHECK(diffuse.materials[1].second.diffusivity == std::vector<ProblemExpression>{"k", 0.0, "k*(1 + y^2)"});
  CHECK(diffuse.materials[1].second.source == ProblemExpression("0.01*sin(pi*t)"));
  REQUIRE(diffuse.conditions.size() == 4);
  CHECK(diffuse.conditions[0].kind == Kind::jump);
  CHECK(diffuse.conditions[0].first == ProblemExpression(5.0));
  CHECK(diffuse.conditions[1].kind == Kind::value);
  CHECK(diffuse.conditions[1].curves == std::vector<std::string>{"inflow", "outflow"});
  CHECK(diffuse.conditions[2].kind == Kind::flux);
  CHECK(diffuse.conditions[2].first == ProblemExpression("0.5*(t < 1)"));
  CHECK(diffuse.conditions[3].kind == Kind::robin);
  CHECK(diffuse.conditions[3].first == ProblemExpression(2.0));
  CHECK(diffuse.conditions[3].second == ProblemExpression("18 + x"));
  REQUIRE(diffuse.initial.size() == 2);
  CHECK(diffuse.initial[1] == std::pair<std::string, ProblemExpression>("*", 20.0));
  CHECK(diffuse.convection.empty());
}

TEST_CASE("a problem that is written, read and written again is the same, byte for byte", "[formats][problem]") {
  for (const std::string& document :
       {example(0), with_parameters("{}"), with_conditions(R"({"curve": ["a"], "value": -0.0})"),
        with_material(R"({"diffusivity": "2", "capacity": 1e-300, "source": "x\ny \u00e9"})"),
        with_diffuse(R"({"field": "u", "materials": {"*": {}}, "initial": {"*": 1}, "convection": ["-y", 3]})"),
        with_diffuse(R"({"field": "u", "materials": {}, "initial": {"": 1, "*": "x"}})"),
        std::string(R"({"elasticity": {"b": [1.0, {"c": null}]}, "format": "pliant-problem", "version": 1})")}) {
    CAPTURE(document);
    const std::string once = written(read_problem(document));
    CHECK(written(read_problem(once)) == once);
    CHECK(once.ends_with("}\n"));
    CHECK(written(read_problem(*problem_value(read_problem(document)))) == once);
  }
  CHECK(written(read_problem(with_conditions(R"({"value": 1, "curve": ["a"]})"))) ==
        R"({"format":"pliant-problem","version":1,"parameters":{},"diffuse":{"field":"u","materials":{},)"
        R"("conditions":[{"curve":"a","value":1}]}})"
        "\n");
}

TEST_CASE("sections of other tools are kept behind the known members", "[formats][problem]") {
  const std::string text = written(read_problem(
      R"({"elasticity": {"b": [1.0, {"c": null}]}, "format": "pliant-problem", "note": "é", "version": 1})"));
  CHECK(text ==
        R"({"format":"pliant-problem","version":1,"parameters":{},"elasticity":{"b":[1,{"c":null}]},"note":"é"})"
        "\n");
}

TEST_CASE("each fault of a problem document is named by its place", "[formats][problem]") {
  check_refused("", "", "empty");
  check_refused("[]", "", "should be an object");
  check_refused("{}", "", "lacks the member \"format\"");
  check_refused(R"({"format": "pliant-problem"})", "", "lacks the member \"version\"");
  check_refused(R"({"format": "pliant-mesh", "version": 1})", "/format", "this is a mesh");
  check_refused(R"({"format": "pliant-problem", "version": 2})", "/version", "version 1");
  check_refused(R"({"format": "pliant-problem", "version": 1} {})", "", "nothing may follow");
  check_refused(R"({"format": "pliant-problem", "version": 1, "paramters": {}})", "/paramters", "\"parameters\" meant");
  check_refused(R"({"format": "pliant-problem", "version": 1, "Diffuse": {}})", "/Diffuse", "\"diffuse\" meant");
  check_refused(R"({"format": "pliant-problem", "version": 1, "navier-stokes": {}})", "/navier-stokes",
                "\"navierstokes\" meant");

  check_refused(with_parameters("[]"), "/parameters", "should be an object");
  check_refused(with_parameters(R"({"k": true})"), "/parameters/k", "a number, or an expression");
  check_refused(with_parameters(R"({"k": null})"), "/parameters/k", "a number, or an expression");
  check_refused(with_parameters(R"({"k": 1e400})"), "/parameters/k", "too large");
  check_refused(with_parameters(R"({"k": 1, "k": 2})"), "/parameters", "twice");
  check_refused(with_parameters(R"({"": 1})"), "/parameters/", "letters, digits");
  check_refused(with_parameters(R"({"2k": 1})"), "/parameters/2k", "begin with a digit");
  check_refused(with_parameters(R"({"k-1": 1})"), "/parameters/k-1", "letters, digits");
  check_refused(with_parameters(R"({"ä": 1})"), "/parameters/ä", "letters, digits");
  check_refused(with_parameters("{\"" + std::string(65, 'k') + "\": 1}"), "/parameters/" + std::string(65, 'k'), "64");
  check_refused(with_parameters(R"({"x": 1})"), "/parameters/x", "coordinate");
  check_refused(with_parameters(R"({"t": 1})"), "/parameters/t", "time");
  check_refused(with_parameters(R"({"pi": 1})"), "/parameters/pi", "number of its own");
  check_refused(with_parameters(R"({"_e": 1})"), "/parameters/_e", "number of its own");
  for (const std::string& name : expression_functions())
    check_refused(with_parameters("{\"" + name + "\": 1}"), "/parameters/" + name, "function");

  check_refused(with_diffuse("7"), "/diffuse", "should be an object");
  check_refused(with_diffuse(R"({"materials": {}})"), "/diffuse", "lacks the member \"field\"");
  check_refused(with_diffuse(R"({"field": "u"})"), "/diffuse", "lacks the member \"materials\"");
  check_refused(with_diffuse(R"({"field": "", "materials": {}})"), "/diffuse/field", "not empty");
  check_refused(with_diffuse(R"({"field": 3, "materials": {}})"), "/diffuse/field", "name in quotes");
  check_refused(with_diffuse(R"({"field": "u", "material": {}})"), "/diffuse/material",
                "is \"materials\" meant? the members are \"field\", \"materials\", \"conditions\", \"initial\" and "
                "\"convection\"");
  check_refused(with_diffuse(R"({"field": "u", "materials": {}, "initial": [1]})"), "/diffuse/initial",
                "a number, or an expression");
  check_refused(with_diffuse(R"({"field": "u", "materials": {}, "initial": {"a": {}}})"), "/diffuse/initial/a",
                "a number, or an expression");
  check_refused(with_diffuse(R"({"field": "u", "materials": {}, "convection": 1})"), "/diffuse/convection", "an array");
  check_refused(with_diffuse(R"({"field": "u", "materials": {}, "convection": [1]})"), "/diffuse/convection",
                "too few");
  check_refused(with_diffuse(R"({"field": "u", "materials": {}, "convection": [1, 2, 3]})"), "/diffuse/convection/2",
                "too many");

  check_refused(with_material("1"), "/diffuse/materials/a~1b", "should be an object");
  check_refused(with_material(R"({"difusivity": 1})"), "/diffuse/materials/a~1b/difusivity",
                "is \"diffusivity\" meant? the members are \"diffusivity\", \"capacity\" and \"source\"");
  check_refused(with_material(R"({"diffusivity": [1, 2]})"), "/diffuse/materials/a~1b/diffusivity", "[xx, xy, yy]");
  check_refused(with_material(R"({"diffusivity": [1, 2, 3, 4]})"), "/diffuse/materials/a~1b/diffusivity/3",
                "[xx, xy, yy]");
  check_refused(with_material(R"({"diffusivity": [1, [2], 3]})"), "/diffuse/materials/a~1b/diffusivity/1",
                "a number, or an expression");
  check_refused(with_material(R"({"capacity": {}})"), "/diffuse/materials/a~1b/capacity", "a number, or an expression");

  const std::string at = "/diffuse/conditions/1";
  const std::string good = R"({"curve": "c", "value": 1}, )";
  check_refused(with_conditions(good + "1"), at, "should be an object");
  check_refused(with_conditions(good + R"({"value": 1})"), at, "lacks the member \"curve\"");
  check_refused(with_conditions(good + R"({"curve": "c"})"), at, "\"value\", \"flux\", \"robin\" or \"jump\"");
  check_refused(with_conditions(good + R"({"curve": [], "value": 1})"), at + "/curve", "should name a curve");
  check_refused(with_conditions(good + R"({"curve": ["a", 2], "value": 1})"), at + "/curve/1", "name in quotes");
  check_refused(with_conditions(good + R"({"curve": 2, "value": 1})"), at + "/curve", "name in quotes");
  check_refused(with_conditions(good + R"({"curve": "c", "value": 1, "flux": 2})"), at + "/flux", "beside \"value\"");
  check_refused(with_conditions(good + R"({"curve": "c", "jump": {"transfer": 1}, "robin": {}})"), at + "/robin",
                "beside \"jump\"");
  check_refused(with_conditions(good + R"({"curve": "c", "vlaue": 1})"), at + "/vlaue", "is \"value\" meant?");
  check_refused(with_conditions(good + R"({"curve": "c", "robin": 1})"), at + "/robin", "should be an object");
  check_refused(with_conditions(good + R"({"curve": "c", "robin": {"transfer": 1}})"), at + "/robin",
                "lacks the member \"ambient\"");
  check_refused(with_conditions(good + R"({"curve": "c", "robin": {"ambient": 1}})"), at + "/robin",
                "lacks the member \"transfer\"");
  check_refused(with_conditions(good + R"({"curve": "c", "jump": {}})"), at + "/jump", "lacks the member \"transfer\"");
  check_refused(with_conditions(good + R"({"curve": "c", "jump": {"transfer": 1, "ambient": 1}})"),
                at + "/jump/ambient", "there is only \"transfer\"");
}

TEST_CASE("a fault of a problem that a mesh carries has a pointer of the mesh, and no column", "[formats][problem]") {
  const auto fault_of = [](const std::string& value) {
    try {
      read_problem(*read_value(value));
    } catch (const InputError& e) {
      return e.pointer() + ": " + e.what();
    }
    return std::string("accepted");
  };
  CHECK_THAT(fault_of("17"), Contains("/problem: should be an object"));
  const std::string text = fault_of(with_material(R"({"flow": 1})"));
  CHECK_THAT(text, Contains("/problem/diffuse/materials/a~1b/flow: is not known"));
  CHECK_THAT(text, !Contains("column"));
}

TEST_CASE("names are listed up to a limit, and the nearest one is asked about", "[formats][problem]") {
  CHECK(quote_names({}).empty());
  CHECK(quote_names({"a"}) == "\"a\"");
  CHECK(quote_names({"a", "b\"", "c"}) == R"("a", "b\"" and "c")");
  std::vector<std::string> many;
  for (int k = 0; k < 1000; ++k) many.push_back("face" + std::to_string(k));
  CHECK_THAT(quote_names(many), Contains("\"face19\" and 980 more") && !Contains("face20"));
  CHECK(known_names("cel", "faces", {"cell", "fluid"}) == "; is \"cell\" meant? the faces are \"cell\" and \"fluid\"");
  CHECK(known_names("outflow", "faces", {"cell"}) == "; there is only \"cell\"");
  CHECK(known_names("wall", "faces", {}) == "; there are no faces");
}

TEST_CASE("a mutilated problem is read or refused, and what is read is written stably",
          "[formats][problem][property]") {
  const int which = GENERATE(0, 1);
  CAPTURE(which);
  const std::string whole = example(which);
  std::mt19937 random(18);
  int read = 0, refused = 0;
  const auto attempt = [&](const std::string& text) {
    try {
      const std::string once = written(read_problem(text));
      ++read;
      if (written(read_problem(once)) != once) FAIL("not stable: " << text);
    } catch (const DocumentError& e) {
      ++refused;
      if (std::string(e.what()).empty()) FAIL("no message: " << text);
    }
  };
  for (std::size_t size = 0; size < whole.size(); ++size) attempt(whole.substr(0, size));
  CHECK(read == 0);
  for (int k = 0; k < 20000; ++k) {
    std::string text = whole;
    for (auto edits = 1 + random() % 3; edits > 0; --edits) {
      const std::size_t at = random() % text.size(), from = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, 1 + random() % 20);
          break;
        case 2:
          text.insert(at, text.substr(from, random() % 40));
          break;
        default:
          text[at] = R"("{}[],:0-.ex*)"[random() % 13];
      }
      if (text.empty()) text = "{";
    }
    attempt(text);
  }
  CHECK(read > 100);
  CHECK(refused > 1000);
}

TEST_CASE("the page names every function, and nothing else as one", "[formats][problem]") {
  const std::string text = page();
  const std::size_t start = text.find("the functions `");
  REQUIRE(start != std::string::npos);
  std::istringstream words(text.substr(start, text.find(';', start) - start));
  std::vector<std::string> names;
  for (std::string word; words >> word;)
    if (word.front() == '`') names.push_back(word.substr(1, word.size() - 2));
  CHECK(names == expression_functions());
}
