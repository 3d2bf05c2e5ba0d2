// tools/stages/navierstokes.cpp: the options of navierstokes, its steps, and what it tells of them.
#include "stages/navierstokes.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include "formats/problem/flow_memory.h"
#include "pliant/boundary/fault.h"
#include "pliant/fem/error_norms.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "problem/exact_solution.h"
#include "problem/incompressible.h"
#include "problem/problem_names.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

constexpr std::pair<std::string_view, MeshMotion> motions[] = {{"lagrangian", MeshMotion::lagrangian},
                                                               {"harmonic", MeshMotion::harmonic},
                                                               {"blend", MeshMotion::blend},
                                                               {"fixed", MeshMotion::fixed}};

/// What --error can compare, as fields and components.
struct Quantity {
  const char* name;
  const char* field;
  int component;
};
constexpr Quantity quantities[] = {
    {"velocity_x", "velocity", 0}, {"velocity_y", "velocity", 1}, {"pressure", "pressure", 0}};

/// Is the fluid at rest on every curve that stays?
bool rests_where_mesh_stays(const FlowProblem& problem) {
  for (std::size_t c = 0; c < problem.motion_of_curve.size(); ++c) {
    if (problem.motion_of_curve[c] == CurveMotion::follows) continue;
    const int k = problem.condition_of_curve[c];
    if (k == none) return false;
    const FlowCondition& condition = problem.conditions[index(k)];
    if (condition.kind != FlowCondition::Kind::velocity || condition.first.constant() != 0.0 ||
        condition.second.constant() != 0.0)
      return false;
  }
  return true;
}

}  // namespace

void NavierStokesStage::add_options(CLI::App& app) {
  problem_.add(app);
  app.add_flag("--steady", steady_, "solve for the flow that does not change in time, on the mesh as it is");
  app.add_option("--steps", steps_,
                 "so many steps of DT, one after the other; 0: only make the velocity, from its initial values")
      ->type_name("N")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  app.add_option("--scheme", scheme_, "how a step is taken: bdf2 (order 2) or euler")
      ->type_name("bdf2|euler")
      ->capture_default_str();
  app.add_option("--corrections", options_.corrections,
                 "solve a step again so often, with the velocity that came out as the one that convects")
      ->type_name("N")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("--mesh-velocity", mesh_velocity_,
                 "how the mesh moves between curves that follow the flow and curves that stay: harmonic, blend, "
                 "lagrangian (with the fluid) or fixed (not at all)")
      ->type_name("harmonic|blend|lagrangian|fixed")
      ->capture_default_str();
  app.add_flag("--vorticity", vorticity_, "make the field `vorticity`, dv/dx - du/dy, too");
  app.add_option("--error", errors_,
                 "report the norms of the difference to an expression in x, y, t and parameters; NAME is velocity_x, "
                 "velocity_y or pressure (repeatable)")
      ->type_name("NAME=EXPR")
      ->allow_extra_args(false);
  motion_.add(app, {.by_itself = true});
}

void NavierStokesStage::check(const CLI::App& app) {
  problem_.check(app);
  if (scheme_ != "bdf2" && scheme_ != "euler")
    throw UsageError("--scheme: there is no scheme \"" + scheme_ + "\"; there are bdf2 and euler");
  options_.scheme = scheme_ == "euler" ? FlowOptions::Scheme::euler : FlowOptions::Scheme::bdf2;
  const auto* const motion = std::ranges::find(motions, mesh_velocity_, [](const auto& each) { return each.first; });
  if (motion == std::end(motions))
    throw UsageError("--mesh-velocity: there is no \"" + mesh_velocity_ +
                     "\"; there are lagrangian, harmonic, blend and fixed");
  mesh_motion_ = motion->second;
  for (const std::string& text : errors_) {
    const std::size_t equals = text.find('=');
    if (std::ranges::none_of(quantities, [&](const Quantity& q) { return text.substr(0, equals) == q.name; }) ||
        equals == std::string::npos)
      throw UsageError("--error " + text + ": velocity_x=EXPR, velocity_y=EXPR or pressure=EXPR is wanted");
  }
  const bool takes_steps = !steady_ && steps_ > 0;
  if (takes_steps && !problem_.wants_explanation()) return motion_.check(app);
  if (takes_steps) return;
  for (const char* option : {"--dt", "--until", "--limit", "--keep-area", "--min-gap", "--gap", "--scheme",
                             "--corrections", "--mesh-velocity"})
    if (app.count(option) > 0)
      throw UsageError(std::string(option) + " has no meaning with " + (steady_ ? "--steady" : "--steps 0"));
  if (steady_ && app.count("--steps") > 0) throw UsageError("--steps has no meaning with --steady");
}

FlowOptions NavierStokesStage::flow_options(const FlowProblem& problem) const {
  FlowOptions options = options_;
  const bool has_tension = std::ranges::any_of(problem.tensions, [](const auto& each) { return each.has_value(); });
  options.by_splines = has_tension || (!steady_ && mesh_motion_ != MeshMotion::fixed);
  options.mesh_follows = mesh_motion_ == MeshMotion::lagrangian && rests_where_mesh_stays(problem);
  return options;
}

std::string NavierStokesStage::explanation(Mesh& mesh) const {
  const ProblemDocument document = problem_.load(mesh);
  const FlowProblem problem = problem_.make_flow(document, mesh);
  std::string text = explain(problem, document, mesh);
  const FlowOptions options = flow_options(problem);
  const FlowEquation equation(problem, mesh, options.by_splines);
  std::ostringstream more;
  more << "unknowns: " << equation.velocities().size() << " of the velocity (degree " << mesh.degree() << "), "
       << equation.pressures().size() << " of the pressure (degree " << equation.pressures().degree()
       << (equation.pressure_jumps() ? ", by face" : ", continuous") << "), on " << mesh.triangle_count()
       << " triangles\n"
       << "matrix: " << equation.pattern().columns.size() << " entries"
       << (equation.form().is_symmetric ? ", symmetric without convection" : ", not symmetric") << "; viscous terms as "
       << (equation.form().is_stress ? "stress" : "gradients") << "\n";
  return text + more.str();
}

PassReport NavierStokesStage::run(Mesh& mesh, const StageContext& context) const {
  const ProblemDocument document = problem_.load(mesh);
  const FlowProblem problem = problem_.make_flow(document, mesh);
  const FlowOptions options = flow_options(problem);
  PassReport report;
  try {
    problem_.in_problem([&] {
      if (steady_ || steps_ == 0) {
        NavierStokes flow(problem, mesh, options);
        if (steady_)
          flow.solve_steady();
        else
          flow.initialise();
        if (vorticity_) flow.put_vorticity();
        remember_flow(mesh.extra, {std::nullopt, flow.forces()});
        if (context.wants_details) flow.report(report);
      } else {
        report = take_steps(problem, mesh, options, context);
      }
    });
  } catch (const NoSolution& error) {
    throw NoResult(error.what());
  }
  add_errors(document, mesh, report);
  return report;
}

AdvectOutcome NavierStokesStage::move(const FlowProblem& problem, Mesh& mesh, const StageContext& context) const {
  if (mesh_motion_ == MeshMotion::fixed) return motion_.rest(mesh, context.goal);
  return motion_.move(mesh, context.goal, [&](const AdvectOptions& step) {
    const auto values = [&mesh](int k) { return mesh.fields()[index(k)].values; };
    const MeshVelocity extension(mesh, problem.motion_of_curve, mesh_motion_);
    const std::vector<double> velocity = extension.extend(values(find_field(mesh, "velocity")));
    const int k = find_field(mesh, "acceleration");
    const bool accelerates = k != none && options_.scheme == FlowOptions::Scheme::bdf2;
    return advect_by_values(mesh, velocity, accelerates ? extension.extend(values(k)) : std::vector<double>(), step);
  });
}

PassReport NavierStokesStage::take_steps(const FlowProblem& problem, Mesh& mesh, const FlowOptions& options,
                                         const StageContext& context) const {
  NavierStokes::require_fields(mesh);  // the motion reads them before there is a flow
  PassReport report;
  FlowMemory memory = recall_flow(mesh.extra);
  double taken = 0;
  std::optional<NavierStokes> flow;
  if (find_field(mesh, "velocity") == none) flow.emplace(problem, mesh, options).initialise();
  for (int k = 0; k < steps_; ++k) {
    const double before = mesh.time;
    std::vector<Point> from;
    if (mesh_motion_ != MeshMotion::fixed) from.assign(mesh.points().begin(), mesh.points().end());
    AdvectOutcome outcome = move(problem, mesh, context);
    if (outcome.status == AdvectOutcome::Status::late && k > 0) break;
    report = std::move(outcome.report);
    if (outcome.status == AdvectOutcome::Status::late) break;
    // On a mesh that does not move, unknowns and the order of elimination serve all steps.
    if (!flow || mesh_motion_ != MeshMotion::fixed) {
      const FlowCounts counts = flow ? flow->counts : FlowCounts{};
      flow.emplace(problem, mesh, options).counts = counts;
    }
    flow->step(from, before, memory.dt);
    taken += mesh.time - before;
    memory = {mesh.time - before, flow->forces()};
    if (outcome.status != AdvectOutcome::Status::done) break;
  }
  if (flow && vorticity_) flow->put_vorticity();
  if (flow && context.wants_details) flow->report(report);
  for (auto& [name, value] : report.values)
    if (name == "dt") value = taken;
  remember_flow(mesh.extra, memory);
  return report;
}

void NavierStokesStage::add_errors(const ProblemDocument& document, const Mesh& mesh, PassReport& report) const {
  if (errors_.empty()) return;
  const ProblemNames names(document, mesh, "velocity", 2);
  for (const std::string& text : errors_) {
    const std::size_t equals = text.find('=');
    const auto* const quantity =
        std::ranges::find_if(quantities, [&](const Quantity& q) { return text.substr(0, equals) == q.name; });
    const std::vector<std::optional<Coefficient>> exact(mesh.boundary().faces.size(),
                                                        exact_solution(names, text, text.substr(equals + 1)));
    const ErrorNorms norms = error_norms(mesh, quantity->field, exact, quantity->component);
    report.add("error_l2:" + std::string(quantity->name), norms.l2);
    report.add("error_h1:" + std::string(quantity->name), norms.h1);
  }
}

}  // namespace pliant
