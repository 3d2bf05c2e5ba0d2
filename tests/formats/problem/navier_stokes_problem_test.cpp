// tests/formats/problem/navier_stokes_problem_test.cpp: the section `navierstokes` of a problem is lossless and strict.
#include <catch2/catch.hpp>
#include <string>

#include "formats/problem/problem_json.h"
#include "problem_texts.h"

using namespace pliant;
using namespace pliant::testing;

namespace {

/// A document whose section `navierstokes` has these members beside its materials.
std::string with_members(const std::string& members) {
  return with_section("navierstokes", R"({"materials": {}, )" + members + "}");
}
std::string with_fluid(const std::string& material) {
  return with_section("navierstokes", R"({"materials": {"a/b": )" + material + "}}");
}
std::string with_flow_conditions(const std::string& conditions) {
  return with_members(R"("conditions": [)" + conditions + "]");
}

}  // namespace

TEST_CASE("the example of a flow on the page is read as the page says", "[formats][problem]") {
  using Kind = NavierStokesCondition::Kind;
  const ProblemDocument problem = read_problem(example(1));
  CHECK_FALSE(problem.diffuse);
  CHECK(problem.extra.empty());
  REQUIRE(problem.navierstokes);
  const NavierStokesSection& flow = *problem.navierstokes;
  REQUIRE(flow.materials.size() == 2);
  CHECK(flow.materials[0].first == "cell");
  CHECK(flow.materials[0].second.density == ProblemExpression(1.2));
  CHECK(flow.materials[0].second.viscosity == ProblemExpression("10*mu"));
  CHECK(flow.materials[1].first == "*");
  CHECK_FALSE(flow.materials[1].second.density);
  REQUIRE(flow.conditions.size() == 4);
  CHECK(flow.conditions[0].kind == Kind::velocity);
  CHECK(flow.conditions[0].curves == std::vector<std::string>{"inflow"});
  CHECK(flow.conditions[0].components == std::vector<ProblemExpression>{"4*U*y*(H - y)/H^2", 0.0});
  CHECK(flow.conditions[1].components == std::vector<ProblemExpression>{0.0, 0.0});
  CHECK(flow.conditions[2].kind == Kind::slip);
  CHECK(flow.conditions[2].components.empty());
  CHECK(flow.conditions[3].kind == Kind::outflow);
  for (const NavierStokesCondition& condition : flow.conditions) CHECK_FALSE(condition.moves);
  REQUIRE(flow.surface_tension.size() == 1);
  CHECK(flow.surface_tension[0] == std::pair<std::string, ProblemExpression>("membrane", 0.5));
  CHECK(flow.gravity == std::vector<ProblemExpression>{0.0, -9.81});
  CHECK(flow.force.empty());
  CHECK(flow.initial == std::vector<ProblemExpression>{"U", 0.0});
  CHECK_FALSE(flow.pressure);
}

TEST_CASE("each kind of condition says whether the mesh follows, or leaves it open", "[formats][problem]") {
  using Kind = NavierStokesCondition::Kind;
  const ProblemDocument problem = read_problem(with_flow_conditions(
      R"({"moves": true, "curve": ["a", "b"], "traction": ["x", 1]}, {"curve": "*", "natural": true, "moves": false},
         {"curve": "c", "slip": true}, {"curve": "d", "outflow": true, "moves": false})"));
  const auto& conditions = problem.navierstokes->conditions;
  REQUIRE(conditions.size() == 4);
  CHECK(conditions[0].kind == Kind::traction);
  CHECK(conditions[0].curves == std::vector<std::string>{"a", "b"});
  CHECK(conditions[0].moves == true);
  CHECK(conditions[1].kind == Kind::natural);
  CHECK(conditions[1].moves == false);
  CHECK_FALSE(conditions[2].moves);
  CHECK(conditions[3].moves == false);
}

TEST_CASE("a flow that is written, read and written again is the same, byte for byte", "[formats][problem]") {
  for (const std::string& document :
       {example(1), with_fluid(R"({"viscosity": -0.0, "density": "x\ny \u00e9"})"),
        with_members(R"("pressure": "by-face")"),
        with_members(R"("initial": ["x", 1e-300], "surface_tension": {"": 1, "a/b": "t"}, "force": [1, "2"])"),
        with_flow_conditions(
            R"({"curve": ["a"], "natural": true, "moves": true}, {"curve": ["a", "b"], "velocity": [1, 2]})")}) {
    CAPTURE(document);
    const std::string once = written(read_problem(document));
    CHECK(written(read_problem(once)) == once);
    CHECK(once.ends_with("}\n"));
    CHECK(written(read_problem(*problem_value(read_problem(document)))) == once);
  }
  // Members come out in the order of the page's tables, and behind those of `diffuse`.
  CHECK(
      written(read_problem(
          R"({"navierstokes": {"pressure": "continuous", "initial": [5, 6], "force": [3, 4], "gravity": ["g", 2],
                "surface_tension": {"b": 1}, "conditions": [{"moves": false, "traction": [1, 2], "curve": ["c"]},
                {"outflow": true, "curve": "d"}], "materials": {"f": {"viscosity": 2, "density": 0}}}, "note": 1,
                "version": 1, "format": "pliant-problem", "diffuse": {"field": "u", "materials": {}}})")) ==
      R"({"format":"pliant-problem","version":1,"parameters":{},"diffuse":{"field":"u","materials":{},"conditions":[]},)"
      R"("navierstokes":{"materials":{"f":{"density":0,"viscosity":2}},"conditions":[{"curve":"c","traction":[1,2],)"
      R"("moves":false},{"curve":"d","outflow":true}],"surface_tension":{"b":1},"gravity":["g",2],"force":[3,4],)"
      R"("initial":[5,6],"pressure":"continuous"},"note":1})"
      "\n");
  CHECK(written(read_problem(with_section("navierstokes", R"({"materials": {}, "surface_tension": {}})"))) ==
        R"({"format":"pliant-problem","version":1,"parameters":{},"navierstokes":{"materials":{},"conditions":[]}})"
        "\n");
}

TEST_CASE("each fault of the section of a flow is named by its place", "[formats][problem]") {
  const std::string section = "/navierstokes";
  check_refused(with_section("navierstokes", "7"), section, "should be an object");
  check_refused(with_section("navierstokes", "{}"), section, "lacks the member \"materials\"");
  check_refused(
      with_members(R"("surface_tensions": {})"), section + "/surface_tensions",
      R"(is "surface_tension" meant? the members are "materials", "conditions", "surface_tension", "gravity", )"
      R"("force", "initial" and "pressure")");
  check_refused(with_members(R"("materials": {})"), section, "twice");
  check_refused(with_members(R"("conditions": {})"), section + "/conditions", "an array");

  for (const std::string member : {"gravity", "force", "initial"}) {
    const std::string at = section + "/" + member;
    const auto with = [&member](const std::string& value) { return with_members("\"" + member + "\": " + value); };
    check_refused(with("1"), at, "an array");
    check_refused(with("[1]"), at, "has too few: a");
    check_refused(with("[1, 2, 3]"), at + "/2", "is one too many: a");
    check_refused(with("[1, null]"), at + "/1", "a number, or an expression");
  }
  check_refused(with_members(R"("surface_tension": 1)"), section + "/surface_tension", "should be an object");
  check_refused(with_members(R"("surface_tension": {"a/b": [1]})"), section + "/surface_tension/a~1b",
                "a number, or an expression");
  check_refused(with_members(R"("surface_tension": {"a": 1, "*": 2})"), section + "/surface_tension/*",
                "is no curve: each curve with surface tension is named");
  check_refused(with_members(R"("pressure": "by_face")"), section + "/pressure", R"("by-face" or "continuous")");
  check_refused(with_members(R"("pressure": true)"), section + "/pressure", R"("by-face" or "continuous")");

  const std::string material = section + "/materials/a~1b";
  check_refused(with_fluid("1"), material, "should be an object");
  check_refused(with_fluid(R"({"density": 1})"), material, "lacks the member \"viscosity\"");
  check_refused(with_fluid(R"({"viscosty": 1})"), material + "/viscosty",
                R"(is "viscosity" meant? the members are "density" and "viscosity")");
  check_refused(with_fluid(R"({"viscosity": [1, 0, 1]})"), material + "/viscosity", "a number, or an expression");
  check_refused(with_fluid(R"({"viscosity": 1, "density": {}})"), material + "/density", "a number, or an expression");
}

TEST_CASE("each fault of a condition of a flow is named by its place", "[formats][problem]") {
  const std::string at = "/navierstokes/conditions/1";
  const auto refused = [&at](const std::string& condition, const std::string& pointer, const std::string& text) {
    check_refused(with_flow_conditions(R"({"curve": "c", "slip": true}, )" + condition), at + pointer, text);
  };
  refused("1", "", "should be an object");
  refused(R"({"slip": true})", "", "lacks the member \"curve\"");
  refused(R"({"curve": "c", "moves": true})", "",
          R"("velocity", "slip", "traction", "outflow" or "natural" is wanted)");
  refused(R"({"curve": [], "slip": true})", "/curve", "should name a curve");
  refused(R"({"curve": ["a", 2], "slip": true})", "/curve/1", "name in quotes");
  refused(R"({"curve": 2, "slip": true})", "/curve", "name in quotes");
  refused(R"({"curve": "c", "slip": true, "natural": true})", "/natural", "beside \"slip\"");
  refused(R"({"curve": "c", "velocity": [0, 0], "slip": true})", "/slip", "beside \"velocity\"");
  refused(R"({"curve": "c", "velocity": 0})", "/velocity", "an array");
  refused(R"({"curve": "c", "velocity": [0]})", "/velocity", "has too few: a velocity is [EXPR, EXPR]");
  refused(R"({"curve": "c", "traction": [0, 0, 0]})", "/traction/2", "is one too many: a traction is [EXPR, EXPR]");
  refused(R"({"curve": "c", "traction": [0, false]})", "/traction/1", "a number, or an expression");
  for (const std::string kind : {"slip", "outflow", "natural"}) {
    refused(R"({"curve": "c", ")" + kind + R"(": false})", "/" + kind,
            "should be true: a condition that does not hold");
    refused(R"({"curve": "c", ")" + kind + R"(": [0, 0]})", "/" + kind, "should be true or false");
    refused(R"({"curve": "c", ")" + kind + R"(": "true"})", "/" + kind, "should be true or false");
    refused(R"({"curve": "c", ")" + kind + R"(": tru})", "/" + kind, "tru");
  }
  refused(R"({"curve": "c", "slip": true, "moves": 1})", "/moves", "should be true or false");
  refused(R"({"curve": "c", "slip": true, "moves": null})", "/moves", "should be true or false");
  refused(
      R"({"curve": "c", "slip": true, "move": true})", "/move",
      R"(is "moves" meant? the members are "curve", "velocity", "slip", "traction", "outflow", "natural" and "moves")");
  refused(R"({"curve": "c", "value": 1})", "/value", "is not known here");
}
