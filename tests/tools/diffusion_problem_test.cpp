// tests/tools/diffusion_problem_test.cpp: what a problem becomes on a mesh, and what does not fit it.
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/boundary/fault.h"
#include "problem/diffusion.h"
#include "problem/problem_names.h"
#include "problem_samples.h"

using namespace pliant;
using namespace pliant::testing;
using Catch::Matchers::Contains;

namespace {

using ConditionKind = DiffusionCondition::Kind;

/// All of `words` are in the message.
void check_refused(const Mesh& mesh, const std::string& members, const std::string& pointer,
                   const std::vector<std::string>& words, const std::string& parameters = "{}") {
  CAPTURE(members, parameters);
  const Refusal refusal = refusal_of(problem_of(members, parameters), mesh);
  CHECK(refusal.pointer == "/problem" + pointer);
  for (const std::string& word : words) CHECK_THAT(refusal.text, Contains(word));
}

}  // namespace

TEST_CASE("materials, conditions and initial values stand on the faces and curves that they name", "[tools][problem]") {
  const Mesh mesh = channel(2);
  const DiffusionProblem problem = make_diffusion_problem(
      problem_of(R"("materials": {"cell": {"diffusivity": ["k", 0.01, "2*k"], "capacity": 4, "source": "x"}, "*": {}},
                    "conditions": [{"curve": "*", "robin": {"transfer": 2, "ambient": "18 + t"}},
                                   {"curve": ["end", "slit"], "value": "y"},
                                   {"curve": "membrane", "jump": {"transfer": "k"}}],
                    "initial": {"cell": 37, "plasma": "x"}, "convection": ["-y", 1])",
                 R"({"k": 0.1})"),
      mesh);
  CHECK(problem.field == "u");
  REQUIRE(problem.materials.size() == 3);
  REQUIRE(problem.materials[1].diffusivity.size() == 3);
  CHECK(problem.materials[1].diffusivity[0].constant() == 0.1);
  CHECK(problem.materials[1].diffusivity[2].constant() == 0.2);
  CHECK(problem.materials[1].capacity.constant() == 4);
  REQUIRE(problem.materials[1].source);
  CHECK_FALSE(problem.materials[1].source->constant());
  for (const std::size_t face : {0, 2}) {
    CHECK(problem.materials[face].diffusivity.size() == 1);
    CHECK(problem.materials[face].diffusivity[0].constant() == 1);
    CHECK(problem.materials[face].capacity.constant() == 1);
    CHECK_FALSE(problem.materials[face].source);
  }
  REQUIRE(problem.conditions.size() == 3);
  CHECK(problem.conditions[0].kind == ConditionKind::robin);
  CHECK(problem.conditions[0].first.constant() == 2);
  CHECK(problem.conditions[1].kind == ConditionKind::value);
  CHECK(problem.conditions[2].kind == ConditionKind::jump);
  CHECK(problem.conditions[2].place == "/problem/diffuse/conditions/2");
  // wall 0, end, wall 2, end, membrane, second, slit
  CHECK(problem.condition_of_curve == std::vector<int>{0, 1, 0, 1, 2, none, 1});
  REQUIRE(problem.initial.size() == 3);
  CHECK(problem.initial[1]->constant() == 37);
  CHECK_FALSE(problem.initial[0]->constant());
  CHECK_FALSE(problem.initial[2]);
  REQUIRE(problem.convection.size() == 2);
  const CoefficientPoint at{mesh, triangle_in(mesh, 1), {1, 0, 0}, {3, 5}, 7};
  CHECK((*problem.materials[1].source)(at) == 3);
  CHECK(problem.conditions[0].second(at) == 25);
  CHECK(problem.convection[0](at) == -5);
  CHECK(problem.convection[1](at) == 1);
  CHECK(problem.materials[1].source->name() == "/problem/diffuse/materials/cell/source: x");
  CHECK(problem.materials[1].diffusivity[1].name() == "/problem/diffuse/materials/cell/diffusivity/1: 0.01");
  CHECK(problem.materials[0].capacity.name() == "/problem/diffuse/materials/*/capacity: 1 (default)");
}

TEST_CASE("flux and robin may stand on any curve", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const DiffusionProblem problem = make_diffusion_problem(
      problem_of(plain + R"(, "initial": "x", "conditions": [{"curve": ["second", "slit", "wall 0"], "flux": -3},
                        {"curve": "membrane", "robin": {"transfer": 0, "ambient": -1}}])"),
      mesh);
  CHECK(problem.condition_of_curve == std::vector<int>{0, none, none, none, 1, 0, 0});
  CHECK(problem.conditions[0].kind == ConditionKind::flux);
  CHECK(problem.conditions[0].first.constant() == -3);
  CHECK(problem.conditions[1].second.constant() == -1);
  CHECK(problem.convection.empty());
  for (const auto& initial : problem.initial) CHECK(initial);
}

TEST_CASE("names that the mesh does not have are errors that list those it has", "[tools][problem]") {
  const Mesh mesh = channel(1);
  check_refused(mesh, R"("materials": {"*": {}, "cel": {}})", "/diffuse/materials/cel",
                {"there is no face \"cel\"", "is \"cell\" meant?", "the faces are \"plasma\", \"cell\" and \"other\""});
  check_refused(mesh, plain + R"(, "initial": {"a/b~c": 1})", "/diffuse/initial/a~1b~0c", {"the faces are"});
  check_refused(mesh, R"("materials": {"cell": {}})", "/diffuse/materials",
                {"the faces \"plasma\" and \"other\" have no material"});
  check_refused(mesh, R"("materials": {"cell": {}, "plasma": {}})", "/diffuse/materials",
                {"the face \"other\" has no material"});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": "wall 1", "value": 1}])", "/diffuse/conditions/0/curve",
                {"there is no curve \"wall 1\"", "is \"wall 0\" meant?",
                 "the curves are \"wall 0\", \"end\", \"wall 2\", \"membrane\", \"second\" and \"slit\""});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": ["end", "exit"], "value": 1}])",
                "/diffuse/conditions/0/curve/1", {"there is no curve \"exit\""});
}

TEST_CASE("a curve has one condition, and a jump stands between two faces", "[tools][problem]") {
  const Mesh mesh = channel(1);
  check_refused(mesh,
                plain + R"(, "conditions": [{"curve": "end", "value": 1}, {"curve": ["slit", "end"], "flux": 1}])",
                "/diffuse/conditions/1/curve/1", {"curve 'end' (1)", "that of conditions/0"});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": ["end", "end"], "value": 1}])",
                "/diffuse/conditions/0/curve/1", {"named twice"});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": "*", "value": 1}, {"curve": "*", "flux": 1}])",
                "/diffuse/conditions/1/curve", {"that of conditions/0"});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": "wall 2", "jump": {"transfer": 1}}])",
                "/diffuse/conditions/0/curve", {"curve 'wall 2' (2)", "outer boundary", "\"robin\""});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": "*", "jump": {"transfer": 1}}])",
                "/diffuse/conditions/0/curve", {"outer boundary"});
  check_refused(mesh, plain + R"(, "conditions": [{"curve": "slit", "jump": {"transfer": 1}}])",
                "/diffuse/conditions/0/curve", {"\"plasma\" on both sides"});
  // Where all outer curves are named, nothing is left for "*".
  const DiffusionProblem problem =
      make_diffusion_problem(problem_of(plain + R"(, "conditions": [{"curve": "*", "jump": {"transfer": 1}},
                                             {"curve": ["wall 0", "end", "wall 2"], "value": 1}])"),
                             mesh);
  CHECK(problem.condition_of_curve == std::vector<int>{1, 1, 1, 1, none, none, none});
}

TEST_CASE("constants out of their ranges are refused at once, also where a text makes them", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const auto material = [](const std::string& members) { return R"("materials": {"*": {)" + members + "}}"; };
  const std::string at = "/diffuse/materials/*";
  check_refused(mesh, material(R"("diffusivity": -1)"), at + "/diffusivity", {"is -1", "above zero"});
  check_refused(mesh, material(R"("diffusivity": 0)"), at + "/diffusivity", {"is 0", "above zero"});
  check_refused(mesh, material(R"("diffusivity": "k - 1")"), at + "/diffusivity", {"is -0.5"}, R"({"k": 0.5})");
  check_refused(mesh, material(R"("diffusivity": "1/0")"), at + "/diffusivity", {"\"1/0\" is inf", "finite"});
  check_refused(mesh, material(R"("diffusivity": [-1, 0, "x"])"), at + "/diffusivity/0", {"diagonal is -1"});
  check_refused(mesh, material(R"("diffusivity": ["x", 0, 0])"), at + "/diffusivity/2", {"diagonal is 0"});
  check_refused(mesh, material(R"("diffusivity": [1, 2, 3])"), at + "/diffusivity",
                {"[1, 2, 3] is not positive definite"});
  check_refused(mesh, material(R"("diffusivity": [1, "sqrt(-1)*1", 3])"), at + "/diffusivity/1", {"nan"});
  check_refused(mesh, material(R"("capacity": 0)"), at + "/capacity", {"capacity is 0", "above zero"});
  check_refused(mesh, material(R"("source": "log(0)*1")"), at + "/source", {"not a finite number"});
  const std::string condition = plain + R"(, "conditions": [{"curve": "membrane", )";
  check_refused(mesh, condition + R"("jump": {"transfer": -1}}])", "/diffuse/conditions/0/jump/transfer",
                {"transfer is -1", "not be negative"});
  check_refused(mesh, condition + R"("robin": {"transfer": -1e-9, "ambient": 0}}])",
                "/diffuse/conditions/0/robin/transfer", {"not be negative"});
  check_refused(mesh, condition + R"("robin": {"transfer": 1, "ambient": "1/0"}}])",
                "/diffuse/conditions/0/robin/ambient", {"finite"});
  check_refused(mesh, condition + R"("value": "0/0"}])", "/diffuse/conditions/0/value", {"finite"});
  check_refused(mesh, condition + R"("flux": "1/0"}])", "/diffuse/conditions/0/flux", {"finite"});
  check_refused(mesh, plain + R"(, "initial": "1/0")", "/diffuse/initial", {"finite"});
  check_refused(mesh, plain + R"(, "convection": [1, "1/0"])", "/diffuse/convection/1", {"finite"});
  // What is no constant is looked at where it is evaluated.
  CHECK(refusal_of(problem_of(material(R"("diffusivity": "-1 - x", "capacity": "0*t")")), mesh).pointer == "accepted");
}

TEST_CASE("parameters are numbers, or expressions in those before them", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const auto values = parameter_values(problem_of(plain, R"({"a": 2, "b": "a^3 + pi", "c": "2*b"})"));
  REQUIRE(values.size() == 3);
  CHECK(values[2].second == 2 * (8 + std::acos(-1)));
  check_refused(mesh, plain, "/parameters/b", {"\"a\" is no name", "a parameter may name those before it"},
                R"({"b": "a", "a": 1})");
  check_refused(mesh, plain, "/parameters/b", {"variables are x, y and t; parameters: \"a\""},
                R"({"a": 1, "b": "2*c"})");
  check_refused(mesh, plain, "/parameters/a", {"uses x"}, R"({"a": "x"})");
  check_refused(mesh, plain, "/parameters/a", {"uses t"}, R"({"a": "2*t"})");
  check_refused(mesh, plain, "/parameters/a", {"not a finite number"}, R"({"a": "1/0"})");
  check_refused(mesh, plain, "/parameters/a", {"the expression is empty"}, R"({"a": " "})");
}

TEST_CASE("unknown names in expressions are errors that list variables, parameters and fields", "[tools][problem]") {
  Mesh mesh = channel(1);
  const auto ones = [](const Point&, std::span<double> v) { std::fill(v.begin(), v.end(), 1.0); };
  set_field(mesh, "vel", 2, none, ones);
  set_field(mesh, "many", 4, none, ones);
  set_field(mesh, "my field", 1, none, ones);
  set_field(mesh, "sin", 1, none, ones);
  set_field(mesh, "k", 1, none, ones);
  set_field(mesh, "vel_x", 1, none, ones);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    check_refused(mesh, R"("materials": {"*": {"source": ")" + text + "\"}}", "/diffuse/materials/*/source", words,
                  R"({"k": 2, "h": 1})");
  };
  refused("2*z", {"\"z\" is no name", "character 3", "variables are x, y and t; parameters: \"k\" and \"h\"; fields: ",
                  "\"vel_y\"", "\"many_4\"", "\"u\""});
  refused("2*sn(x)", {"\"sn\" is no name", "is \"sin\" meant?"});
  refused("sin", {"the function is written sin(...)"});
  refused("vel_z", {"is \"vel_x\" meant?"});
  refused("vel", {"the field \"vel\" has 2 components, vel_x and vel_y"});
  refused("1 + many", {"the field \"many\" has 4 components, many_1 to many_4"});
  refused("my field", {"the field \"my field\" cannot be used in an expression", "letters, digits"});
  refused("2*sin", {"the field \"sin\" cannot be used in an expression", "\"sin\" is a function"});
  refused("k + 1", {"the field \"k\" cannot be used in an expression", "\"k\" is a parameter, too"});
  refused("vel_x", {"\"vel_x\" is also a name of the field \"vel\""});
  refused("h = 3", {"\"==\""});
  refused("u = 3", {"\"==\""});
  refused("1, 2", {"one value"});
  refused("", {"empty"});
  // Names that only contain those that are of no use.
  const CoefficientPoint at = point_of(mesh, TriangleId{0}, {1, 0, 0});
  CHECK(value_at("sin(h) + kk + vel_y", at, R"({"k": 2, "h": 0, "kk": 5})") == 6);
}

TEST_CASE("a problem knows what its coefficients depend on", "[tools][problem]") {
  Mesh mesh = channel(1);
  set_field(mesh, "w", 1, none, [](const Point&, std::span<double> v) { v[0] = 1; });
  struct Case {
    std::string members;
    bool unknown, time, matrices;
  };
  for (const Case& each : std::vector<Case>{
           {R"("materials": {"*": {"diffusivity": "1 + x^2"}}, "initial": "t*w")", false, false, false},
           {R"("materials": {"*": {"source": "t"}})", false, true, false},
           {R"("materials": {"*": {"source": "w"}})", false, true, false},
           {R"("materials": {"*": {"source": "u"}})", true, true, false},
           {R"("materials": {"*": {"diffusivity": "1 + u"}})", true, true, true},
           {R"("materials": {"*": {"diffusivity": [1, "t", 9]}})", false, true, true},
           {R"("materials": {"*": {"capacity": "sin(t) + 2"}})", false, true, true},
           {R"("materials": {"*": {}}, "convection": [0, "w"])", false, true, true},
           {R"("materials": {"*": {}}, "conditions": [{"curve": "*", "value": "t"}])", false, true, false},
           {R"("materials": {"*": {}}, "conditions": [{"curve": "*", "robin": {"transfer": 1, "ambient": "t"}}])",
            false, true, false},
           {R"("materials": {"*": {}}, "conditions": [{"curve": "*", "robin": {"transfer": "t", "ambient": 1}}])",
            false, true, true}}) {
    CAPTURE(each.members);
    const DiffusionProblem problem = make_diffusion_problem(problem_of(each.members), mesh);
    CHECK(problem.depends_on_unknown == each.unknown);
    CHECK(problem.depends_on_time == each.time);
    CHECK(problem.matrices_depend_on_time == each.matrices);
  }
}

TEST_CASE("what is no problem for this mesh is refused", "[tools][problem]") {
  Mesh mesh = channel(1);
  const Refusal missing =
      refusal_of(read_problem(R"({"format": "pliant-problem", "version": 1, "elasticity": {}, "note": 1})"), mesh);
  CHECK(missing.pointer == "/problem");
  CHECK_THAT(missing.text, Contains("lacks the section \"diffuse\"") && Contains("\"elasticity\" and \"note\""));
  check_refused(mesh, plain + R"(, "initial": "u + 1")", "/diffuse/initial", {"uses the unknown \"u\""});
  set_field(mesh, "u", 2, none, [](const Point&, std::span<double> v) { v[0] = v[1] = 1; });
  check_refused(mesh, plain, "/diffuse/field", {"\"u\" has 2 components", "scalar"});
}

TEST_CASE("an explanation says what stands on each face and curve, and what nobody wrote", "[tools][problem]") {
  Mesh mesh = channel(1);
  set_field(mesh, "my field", 1, none, [](const Point&, std::span<double> v) { v[0] = 1; });
  const ProblemDocument problem = problem_of(
      R"("materials": {"cell": {"diffusivity": ["k", 0, "h*k"], "capacity": 4, "source": "x"}, "*": {}},
         "conditions": [{"curve": "*", "robin": {"transfer": 2, "ambient": "18 + k*t"}},
                        {"curve": "end", "value": "y"}, {"curve": "slit", "flux": 0.5},
                        {"curve": "membrane", "jump": {"transfer": "k"}}],
         "initial": {"cell": 37})",
      R"({"k": 0.1, "h": "20*k"})");
  CHECK(explain(make_diffusion_problem(problem, mesh), problem, mesh) ==
        R"(unknown: the field "u", which the mesh does not have yet: it begins with the initial values
note: the field "my field" cannot be used in an expression: a name in expressions consists of letters, digits and _, and does not begin with a digit
parameter k = 0.1
parameter h = 2 (20*k)
face 'plasma' (0), by "*": diffusivity 1 (default); capacity 1 (default); source none (default); initially nothing is given (default)
face 'cell' (1): diffusivity [k (k = 0.1), 0, h*k (k = 0.1, h = 2)]; capacity 4; source x; initially 37
face 'other' (2), by "*": diffusivity 1 (default); capacity 1 (default); source none (default); initially nothing is given (default)
curve 'wall 0' (0), outer boundary of 'plasma': the transfer 2 times how far the unknown is above 18 + k*t (k = 0.1) leaves per length and time, by conditions/0, "*"
curve 'end' (1), outer boundary of 'plasma': the unknown is y, by conditions/1
curve 'wall 2' (2), outer boundary of 'plasma': the transfer 2 times how far the unknown is above 18 + k*t (k = 0.1) leaves per length and time, by conditions/0, "*"
curve 'end' (3), outer boundary of 'plasma': the unknown is y, by conditions/1
curve 'membrane' (4), between 'cell' and 'plasma': the unknown may jump, and the transfer k (k = 0.1) times its jump crosses, by conditions/3
curve 'second' (5), between 'other' and 'plasma': the unknown is continuous, and nothing enters (default)
curve 'slit' (6), in 'plasma': 0.5 enters per length and time, by conditions/2
convection relative to the mesh: none (default)
the equation is linear; coefficients use the time or fields
)");
}
