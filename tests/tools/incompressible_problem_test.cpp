// tests/tools/incompressible_problem_test.cpp: what the problem of a flow becomes on a mesh, and what does not fit it.
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/boundary/fault.h"
#include "problem/incompressible.h"
#include "problem_samples.h"

using namespace pliant;
using namespace pliant::testing;
using Catch::Matchers::Contains;

namespace {

using Kind = FlowCondition::Kind;

const std::string water = R"("materials": {"*": {"viscosity": 1}})";
const std::string walls = R"({"curve": "*", "velocity": [0, 0]})";
const std::string closed = water + R"(, "conditions": [)" + walls + "]";

/// Members with these conditions in front of walls.
std::string with_conditions(const std::string& conditions) {
  return water + R"(, "conditions": [)" + conditions + ", " + walls + "]";
}

/// All of `words` are in the message.
void check_flow_refused(const Mesh& mesh, const std::string& members, const std::string& pointer,
                        const std::vector<std::string>& words, const std::string& parameters = "{}") {
  CAPTURE(members, parameters);
  const Refusal refusal = refusal_of(flow_problem_of(members, parameters), mesh, make_flow_problem);
  CHECK(refusal.pointer == "/problem" + pointer);
  for (const std::string& word : words) CHECK_THAT(refusal.text, Contains(word));
}

std::vector<bool> follows(const FlowProblem& problem) {
  std::vector<bool> all;
  for (const CurveMotion motion : problem.motion_of_curve) all.push_back(motion == CurveMotion::follows);
  return all;
}

}  // namespace

TEST_CASE("fluids, conditions and tensions stand on the faces and curves that they name", "[tools][problem]") {
  const Mesh mesh = channel(2);
  const FlowProblem problem = make_flow_problem(
      flow_problem_of(R"("materials": {"cell": {"density": "2*k", "viscosity": "1 + x"}, "*": {"viscosity": "k"}},
                         "conditions": [{"curve": "*", "velocity": ["y", "-t"]}, {"curve": "wall 2", "slip": true},
                                        {"curve": "end", "outflow": true}],
                         "surface_tension": {"membrane": "k", "end": 0, "second": "y"}, "gravity": [0, "-k"],
                         "force": ["x", 3], "initial": ["y", "2*x"], "pressure": "continuous")",
                      R"({"k": 0.5})"),
      mesh);
  REQUIRE(problem.materials.size() == 3);
  CHECK(problem.materials[1].density.constant() == 1);
  CHECK_FALSE(problem.materials[1].viscosity.constant());
  for (const std::size_t face : {0, 2}) {
    CHECK(problem.materials[face].density.constant() == 1);
    CHECK(problem.materials[face].viscosity.constant() == 0.5);
  }
  REQUIRE(problem.conditions.size() == 3);
  CHECK(problem.conditions[0].kind == Kind::velocity);
  CHECK(problem.conditions[1].kind == Kind::slip);
  CHECK(problem.conditions[2].kind == Kind::outflow);
  CHECK(problem.conditions[2].place == "/problem/navierstokes/conditions/2");
  // wall 0, end, wall 2, end, membrane, second, slit
  CHECK(problem.condition_of_curve == std::vector<int>{0, 2, 1, 2, none, none, none});
  CHECK(follows(problem) == std::vector<bool>{false, false, false, false, true, true, true});
  REQUIRE(problem.tensions.size() == 7);
  CHECK(problem.tensions[4]->constant() == 0.5);
  CHECK(problem.tensions[1]->constant() == 0);
  CHECK(problem.tensions[3]->constant() == 0);
  for (const std::size_t curve : {0, 2, 6}) CHECK_FALSE(problem.tensions[curve]);
  CHECK_FALSE(problem.pressure_by_face);
  const CoefficientPoint at{mesh, triangle_in(mesh, 1), {1, 0, 0}, {3, 5}, 7};
  CHECK(problem.materials[1].viscosity(at) == 4);
  CHECK(problem.conditions[0].first(at) == 5);
  CHECK(problem.conditions[0].second(at) == -7);
  CHECK((*problem.tensions[5])(at) == 5);
  CHECK(problem.gravity[0](at) == 0);
  CHECK(problem.gravity[1](at) == -0.5);
  CHECK(problem.force[0](at) == 3);
  CHECK(problem.force[1](at) == 3);
  REQUIRE(problem.initial);
  CHECK((*problem.initial)[0](at) == 5);
  CHECK((*problem.initial)[1](at) == 6);
  const std::string place = "/problem/navierstokes/";
  CHECK(problem.materials[1].viscosity.name() == place + "materials/cell/viscosity: 1 + x");
  CHECK(problem.materials[0].density.name() == place + "materials/*/density: 1 (default)");
  CHECK(problem.conditions[0].second.name() == place + "conditions/0/velocity/1: -t");
  CHECK(problem.tensions[5]->name() == place + "surface_tension/second: y");
  CHECK(problem.gravity[1].name() == place + "gravity/1: -k");
  CHECK(problem.force[0].name() == place + "force/0: x");
  CHECK((*problem.initial)[1].name() == place + "initial/1: 2*x");
}

TEST_CASE("what the problem of a flow leaves out has its default", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const FlowProblem problem = make_flow_problem(flow_problem_of(closed), mesh);
  for (const Coefficient& component : {problem.gravity[0], problem.gravity[1], problem.force[0], problem.force[1]})
    CHECK(component.constant() == 0);
  CHECK_FALSE(problem.initial);
  CHECK(problem.pressure_by_face);
  CHECK(std::ranges::none_of(problem.tensions, [](const auto& each) { return each.has_value(); }));
  CHECK(make_flow_problem(flow_problem_of(closed + R"(, "pressure": "by-face")"), mesh).pressure_by_face);
}

TEST_CASE("the mesh follows free surfaces and interfaces, and other curves where it is told to", "[tools][problem]") {
  const Mesh mesh = channel(1);
  struct Case {
    std::string condition;
    Kind kind;
    bool follows;
  };
  for (const Case& each : std::vector<Case>{{R"("velocity": [1, 2])", Kind::velocity, false},
                                            {R"("velocity": [1, 2], "moves": true)", Kind::velocity, true},
                                            {R"("slip": true)", Kind::slip, false},
                                            {R"("slip": true, "moves": true)", Kind::slip, true},
                                            {R"("outflow": true)", Kind::outflow, false},
                                            {R"("outflow": true, "moves": false)", Kind::outflow, false},
                                            {R"("traction": [1, 2])", Kind::traction, true},
                                            {R"("traction": [1, 2], "moves": false)", Kind::traction, false},
                                            {R"("natural": true)", Kind::traction, true},
                                            {R"("natural": true, "moves": false)", Kind::traction, false}}) {
    CAPTURE(each.condition);
    const FlowProblem problem =
        make_flow_problem(flow_problem_of(with_conditions(R"({"curve": "wall 0", )" + each.condition + "}")), mesh);
    REQUIRE(problem.condition_of_curve[0] == 0);
    const FlowCondition& condition = problem.conditions[0];
    CHECK(condition.kind == each.kind);
    CHECK(follows(problem) == std::vector<bool>{each.follows, false, false, false, true, true, true});
    const bool has_value = each.condition.find('[') != std::string::npos;
    CHECK(condition.first.constant() == (has_value ? 1 : 0));
    CHECK(condition.second.constant() == (has_value ? 2 : 0));
  }
  // Inside, a curve may be held.
  const FlowProblem problem = make_flow_problem(
      flow_problem_of(with_conditions(R"({"curve": "membrane", "velocity": [0, 0]}, {"curve": "slit", "slip": true})")),
      mesh);
  CHECK(problem.condition_of_curve == std::vector<int>{2, 2, 2, 2, 0, none, 1});
  CHECK(follows(problem) == std::vector<bool>{false, false, false, false, false, true, false});
}

TEST_CASE("names of a flow that the mesh does not have are errors that list those it has", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const std::string materials = "/navierstokes/materials", fluid = R"({"viscosity": 1})";
  check_flow_refused(
      mesh, R"("materials": {"*": )" + fluid + R"(, "cel": )" + fluid + "}", materials + "/cel",
      {"there is no face \"cel\"", "is \"cell\" meant?", "the faces are \"plasma\", \"cell\" and \"other\""});
  check_flow_refused(mesh, R"("materials": {"cell": )" + fluid + "}", materials,
                     {"the faces \"plasma\" and \"other\" have no material", "\"*\" stands for all"});
  check_flow_refused(mesh, R"("materials": {"cell": )" + fluid + R"(, "plasma": )" + fluid + "}", materials,
                     {"the face \"other\" has no material"});
  check_flow_refused(mesh, with_conditions(R"({"curve": "wall 1", "slip": true})"), "/navierstokes/conditions/0/curve",
                     {"there is no curve \"wall 1\"", "is \"wall 0\" meant?", "the curves are \"wall 0\", \"end\""});
  check_flow_refused(mesh, with_conditions(R"({"curve": ["end", "exit"], "slip": true})"),
                     "/navierstokes/conditions/0/curve/1", {"there is no curve \"exit\""});
  check_flow_refused(mesh, closed + R"(, "surface_tension": {"membrane": 1, "mem/brane": 1})",
                     "/navierstokes/surface_tension/mem~1brane",
                     {"there is no curve \"mem/brane\"", "is \"membrane\" meant?"});
  check_flow_refused(mesh, R"("materials": {"*": {"viscosity": "nu"}})", materials + "/*/viscosity",
                     {"\"nu\" is no name", "parameters: \"mu\"", "fields: \"velocity_x\" and \"velocity_y\""},
                     R"({"mu": 1})");
  check_flow_refused(mesh, closed + R"(, "force": ["velocity", 0])", "/navierstokes/force/0",
                     {"the field \"velocity\" has 2 components, velocity_x and velocity_y"});
}

TEST_CASE("each curve of the outer boundary has one condition", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const std::string at = "/navierstokes/conditions";
  check_flow_refused(
      mesh, water, at,
      {"every curve of the outer boundary needs a condition: \"wall 0\", \"end\" and \"wall 2\" have none"});
  check_flow_refused(
      mesh, water + R"(, "conditions": [{"curve": ["end", "wall 2", "slit"], "slip": true}])", at,
      {"every curve of the outer boundary needs a condition: \"wall 0\" has none", "\"*\" stands for all"});
  check_flow_refused(mesh,
                     with_conditions(R"({"curve": "end", "slip": true}, {"curve": ["slit", "end"], "slip": true})"),
                     at + "/1/curve/1", {"curve 'end' (1)", "that of conditions/0"});
  check_flow_refused(mesh, with_conditions(R"({"curve": ["end", "end"], "slip": true})"), at + "/0/curve/1",
                     {"named twice"});
  check_flow_refused(mesh, with_conditions(R"({"curve": "*", "slip": true})"), at + "/1/curve",
                     {"that of conditions/0"});
}

TEST_CASE("a stress from outside and an outflow stand on the outer boundary", "[tools][problem]") {
  const Mesh mesh = channel(1);
  for (const std::string condition : {R"("traction": [0, 0])", R"("outflow": true)", R"("natural": true)"}) {
    const std::string kind = condition.substr(0, condition.find(':'));
    check_flow_refused(
        mesh, with_conditions(R"({"curve": ["end", "membrane"], )" + condition + "}"),
        "/navierstokes/conditions/0/curve/1",
        {"curve 'membrane' (4) lies between 'cell' and 'plasma'", kind + " can only stand on the outer"});
    check_flow_refused(mesh, with_conditions(R"({"curve": "slit", )" + condition + "}"),
                       "/navierstokes/conditions/0/curve", {"curve 'slit' (6) lies in 'plasma'", kind});
    // By "*" it stands on outer curves only.
    const FlowProblem problem =
        make_flow_problem(flow_problem_of(water + R"(, "conditions": [{"curve": "*", )" + condition + "}]"), mesh);
    CHECK(problem.condition_of_curve == std::vector<int>{0, 0, 0, 0, none, none, none});
  }
  check_flow_refused(mesh, with_conditions(R"({"curve": "end", "moves": true, "outflow": true})"),
                     "/navierstokes/conditions/0/moves", {"is true, but fluid passes through an outflow"});
}

TEST_CASE("constants of a flow out of their ranges are refused at once", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const auto fluid = [](const std::string& members) { return R"("materials": {"*": {)" + members + "}}"; };
  const std::string at = "/navierstokes/materials/*";
  check_flow_refused(mesh, fluid(R"("viscosity": 0)"), at + "/viscosity", {"the viscosity is 0", "above zero"});
  check_flow_refused(mesh, fluid(R"("viscosity": -1)"), at + "/viscosity", {"the viscosity is -1", "above zero"});
  check_flow_refused(mesh, fluid(R"("viscosity": "k - 1")"), at + "/viscosity", {"is -0.5"}, R"({"k": 0.5})");
  check_flow_refused(mesh, fluid(R"("viscosity": "1/0")"), at + "/viscosity", {"finite"});
  check_flow_refused(mesh, fluid(R"("viscosity": 1, "density": -1e-9)"), at + "/density",
                     {"the density is -1e-09", "not be negative"});
  check_flow_refused(mesh, closed + R"(, "surface_tension": {"membrane": -2})",
                     "/navierstokes/surface_tension/membrane", {"the surface tension is -2", "not be negative"});
  check_flow_refused(mesh, closed + R"(, "surface_tension": {"membrane": "0/0"})",
                     "/navierstokes/surface_tension/membrane", {"finite"});
  check_flow_refused(mesh, with_conditions(R"({"curve": "end", "velocity": [0, "1/0"]})"),
                     "/navierstokes/conditions/0/velocity/1", {"finite"});
  check_flow_refused(mesh, with_conditions(R"({"curve": "end", "traction": ["1/0", 0]})"),
                     "/navierstokes/conditions/0/traction/0", {"finite"});
  for (const std::string member : {"gravity", "force", "initial"})
    check_flow_refused(mesh, closed + ", \"" + member + R"(": [1, "1/0"])", "/navierstokes/" + member + "/1",
                       {"finite"});
  // Without density it is the flow of Stokes; what is no constant is looked at where it is evaluated.
  const FlowProblem stokes = make_flow_problem(
      flow_problem_of(R"("materials": {"*": {"density": 0, "viscosity": "-1 - x"}}, "conditions": [)" + walls + "]"),
      mesh);
  CHECK(stokes.materials[0].density.constant() == 0);
}

TEST_CASE("a flow knows whether its coefficients depend on time and fields", "[tools][problem]") {
  Mesh mesh = channel(1);
  set_field(mesh, "w", 1, none, [](const Point&, std::span<double> v) { v[0] = 1; });
  struct Case {
    std::string members;
    bool time;
  };
  const std::string conditions = R"(, "conditions": [)" + walls + "]";
  for (const Case& each :
       std::vector<Case>{{closed, false},
                         {closed + R"(, "force": ["x", "y^2"])", false},
                         {closed + R"(, "initial": ["t", "w"])", false},
                         {closed + R"(, "force": ["t", 0])", true},
                         {closed + R"(, "gravity": [0, "w"])", true},
                         {closed + R"(, "surface_tension": {"membrane": "1 + t"})", true},
                         {closed + R"(, "force": ["-velocity_x", 0])", true},
                         {R"("materials": {"*": {"viscosity": "1 + x^2"}})" + conditions, false},
                         {R"("materials": {"*": {"viscosity": "1 + velocity_y^2"}})" + conditions, true},
                         {R"("materials": {"*": {"viscosity": 1, "density": "t"}})" + conditions, true},
                         {with_conditions(R"({"curve": "end", "velocity": [0, "2*t"]})"), true},
                         {with_conditions(R"({"curve": "end", "traction": ["w", 0]})"), true}}) {
    CAPTURE(each.members);
    CHECK(make_flow_problem(flow_problem_of(each.members), mesh).depends_on_time == each.time);
  }
}

TEST_CASE("a coefficient of a flow may use the velocity, also where the mesh gets it later", "[tools][problem]") {
  Mesh mesh = channel(2);
  const FlowProblem problem =
      make_flow_problem(flow_problem_of(closed + R"(, "force": ["velocity_x + 10*velocity_y", 0])"), mesh);
  const auto force = [&] { return problem.force[0](point_of(mesh, TriangleId{0}, {1, 0, 0})); };
  CHECK(std::isnan(force()));
  set_field(mesh, "velocity", 2, none, [](const Point&, std::span<double> v) { v[0] = 2, v[1] = 3; });
  CHECK(force() == 32);
  check_flow_refused(mesh, closed + R"(, "initial": [0, "2*velocity_x"])", "/navierstokes/initial/1",
                     {"uses the unknown \"velocity\""});
}

TEST_CASE("a problem that is none of a flow for this mesh is refused", "[tools][problem]") {
  const Mesh mesh = channel(1);
  const Refusal other = refusal_of(problem_of(plain), mesh, make_flow_problem);
  CHECK(other.pointer == "/problem");
  CHECK_THAT(other.text, Contains("lacks the section \"navierstokes\"; its other members are \"diffuse\""));
  const Refusal reverse = refusal_of(flow_problem_of(closed), mesh);
  CHECK_THAT(reverse.text, Contains("lacks the section \"diffuse\"; its other members are \"navierstokes\""));
  const Refusal empty =
      refusal_of(read_problem(R"({"format": "pliant-problem", "version": 1})"), mesh, make_flow_problem);
  CHECK(empty.text == "lacks the section \"navierstokes\"");
}

TEST_CASE("an explanation of a flow says what stands on each face and curve, and what nobody wrote",
          "[tools][problem]") {
  Mesh mesh = channel(1);
  set_field(mesh, "my field", 1, none, [](const Point&, std::span<double> v) { v[0] = 1; });
  const ProblemDocument problem = flow_problem_of(
      R"("materials": {"cell": {"density": "h", "viscosity": "10*mu"}, "*": {"viscosity": "mu"}},
         "conditions": [{"curve": "*", "velocity": ["k*y", 0]}, {"curve": "end", "outflow": true},
                        {"curve": "wall 2", "slip": true, "moves": false}, {"curve": "slit", "velocity": [0, 0], "moves": true}],
         "surface_tension": {"membrane": "k"}, "gravity": [0, -9.81], "initial": ["k*y", 0])",
      R"({"k": 0.1, "h": "20*k", "mu": 3})");
  CHECK(explain(make_flow_problem(problem, mesh), problem, mesh) ==
        R"(unknowns: the fields "velocity" and "pressure"; the mesh has no velocity yet: it begins with the initial one
note: the field "my field" cannot be used in an expression: a name in expressions consists of letters, digits and _, and does not begin with a digit
parameter k = 0.1
parameter h = 2 (20*k)
parameter mu = 3
face 'plasma' (0), by "*": density 1 (default); viscosity mu (mu = 3)
face 'cell' (1): density h (h = 2); viscosity 10*mu (mu = 3)
face 'other' (2), by "*": density 1 (default); viscosity mu (mu = 3)
curve 'wall 0' (0), outer boundary of 'plasma': the velocity is [k*y (k = 0.1), 0]; the mesh does not move (default), by conditions/0, "*"
curve 'end' (1), outer boundary of 'plasma': the fluid leaves freely; the mesh does not move (default), by conditions/1
curve 'wall 2' (2), outer boundary of 'plasma': nothing crosses it, and nothing holds the fluid back along it; the mesh does not move, by conditions/2
curve 'end' (3), outer boundary of 'plasma': the fluid leaves freely; the mesh does not move (default), by conditions/1
curve 'membrane' (4), between 'cell' and 'plasma': the velocity is continuous (default); the mesh follows the flow (default); surface tension k (k = 0.1)
curve 'second' (5), between 'other' and 'plasma': the velocity is continuous (default); the mesh follows the flow (default)
curve 'slit' (6), in 'plasma': the velocity is [0, 0]; the mesh follows the flow, by conditions/3
gravity: [0, -9.81]
force per area: none (default)
initial velocity: [k*y (k = 0.1), 0]
pressure: by face, it may jump across curves where the fluid changes, surface tension acts or a velocity or slip is given (default)
the equations are those of Navier and Stokes; coefficients do not use the time or fields
)");

  set_field(mesh, "velocity", 2, none, [](const Point&, std::span<double> v) { v[0] = v[1] = 0; });
  const ProblemDocument stokes = flow_problem_of(
      R"("materials": {"*": {"density": 0, "viscosity": 1}}, "pressure": "continuous", "force": ["t", "velocity_x"],
         "conditions": [{"curve": "end", "traction": ["x", 1]}, {"curve": "*", "natural": true}])");
  const std::string text = explain(make_flow_problem(stokes, mesh), stokes, mesh);
  for (const char* line : {"the mesh has a velocity: its values are those to begin with\n",
                           "(1), outer boundary of 'plasma': the stress from outside is [x, 1]; the mesh follows the "
                           "flow (default), by conditions/0\n",
                           "(0), outer boundary of 'plasma': there is no stress from outside; the mesh follows the "
                           "flow (default), by conditions/1, \"*\"\n",
                           "\ngravity: none (default)\nforce per area: [t, velocity_x]\ninitial velocity: [0, 0] "
                           "(default)\npressure: continuous\n",
                           "the equations are those of Stokes; coefficients use the time or fields\n"})
    CHECK_THAT(text, Contains(line));
}
