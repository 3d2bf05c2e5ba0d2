// tools/stages/diffuse.cpp: the options of diffuse, its steps, and what it tells of them.
#include "stages/diffuse.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/fem/error_norms.h"
#include "pliant/geometry/index.h"
#include "problem/diffusion.h"
#include "problem/exact_solution.h"
#include "problem/problem_names.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

constexpr std::pair<std::string_view, TimeScheme> schemes[] = {
    {"sdirk2", TimeScheme::sdirk2}, {"crank-nicolson", TimeScheme::crank_nicolson}, {"euler", TimeScheme::euler}};

}  // namespace

void DiffuseStage::add_options(CLI::App& app) {
  problem_.add(app);
  app.add_flag("--steady", steady_, "solve for the state that does not change in time, at the time of the mesh");
  app.add_option("--steps", steps_,
                 "so many steps of DT, one after the other; 0: only make the field, from its initial values")
      ->type_name("N")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  app.add_option("--scheme", scheme_,
                 "how a step is taken: sdirk2 (order 2, damping), crank-nicolson (order 2) or euler")
      ->type_name("sdirk2|crank-nicolson|euler")
      ->capture_default_str();
  app.add_option("--form", form_, "what is exact to rounding: conservative, the total; nonconservative, constants")
      ->type_name("conservative|nonconservative")
      ->capture_default_str();
  app.add_option(
         "--error", errors_,
         "report the norms of the difference to an expression in x, y, t and parameters, on all faces or on one "
         "(repeatable)")
      ->type_name("[FACE=]EXPR")
      ->allow_extra_args(false);
  motion_.add(app, {.may_rest = true});
}

void DiffuseStage::check(const CLI::App& app) {
  problem_.check(app);
  const auto* const scheme = std::ranges::find(schemes, scheme_, [](const auto& each) { return each.first; });
  if (scheme == std::end(schemes))
    throw UsageError("--scheme: there is no scheme \"" + scheme_ + "\"; there are sdirk2, crank-nicolson and euler");
  options_.scheme = scheme->second;
  if (form_ != "conservative" && form_ != "nonconservative")
    throw UsageError("--form: \"" + form_ + "\" is neither conservative nor nonconservative");
  options_.conservative = form_ == "conservative";
  if (!options_.conservative && options_.scheme == TimeScheme::crank_nicolson)
    throw UsageError("--form nonconservative goes with --scheme sdirk2 or euler");
  if (!steady_ && steps_ > 0 && !problem_.wants_explanation()) return motion_.check(app);
  if (!steady_ && steps_ == 0 && MotionOption::is_given(app))
    throw UsageError("--steps 0 takes no step: --dt, --until and the options of motion have no meaning with it");
  if (!steady_) return;
  for (const char* option : {"--steps", "--scheme", "--form"})
    if (app.count(option) > 0) throw UsageError(std::string(option) + " has no meaning with --steady");
  if (MotionOption::is_given(app))
    throw UsageError("--steady takes no step: --dt, --until and the options of motion have no meaning with it");
}

std::string DiffuseStage::explanation(Mesh& mesh) const {
  const ProblemDocument document = problem_.load(mesh);
  const DiffusionProblem problem = problem_.make_diffusion(document, mesh);
  std::string text = explain(problem, document, mesh);
  const DiffusionEquation equation(problem, mesh);
  const auto fixed = std::ranges::count_if(equation.is_fixed(), [](char c) { return c != 0; });
  std::ostringstream more;
  const double entries = static_cast<double>(equation.pattern().columns.size());
  const double unknowns = equation.space().size(), elements = mesh.triangle_count(), net = mesh.net_size();
  // Three matrices with their pattern, where entries of elements go, some vectors; the factor of a direct solver comes
  // on top of it and is not known before.
  const double bytes = entries * (3 * 8 + 4) + elements * net * (4 * net + 12) + unknowns * 8 * 12;
  more << "unknowns: " << equation.space().size() << " (degree " << mesh.degree() << ", " << mesh.triangle_count()
       << " triangles), " << fixed << " of them with a given value\n"
       << "matrix: " << equation.pattern().columns.size() << " entries, "
       << (equation.is_symmetric() ? "symmetric" : "not symmetric") << "\n";
  more.precision(3);
  more << "memory: about " << bytes / 1e6 << " MB beside the mesh, without the factors of a direct solver\n";
  return text + more.str();
}

PassReport DiffuseStage::run(Mesh& mesh, const StageContext& context) const {
  const ProblemDocument document = problem_.load(mesh);
  const DiffusionProblem problem = problem_.make_diffusion(document, mesh);
  DiffusionOptions options = options_;
  options.needs_initial = !steady_;
  options.wants_fluxes = context.wants_details;
  PassReport report;
  try {
    problem_.in_problem([&] {
      Diffusion diffusion(problem, mesh, options);
      if (steady_)
        diffusion.solve_steady();
      else
        report = take_steps(diffusion, mesh, context);
      if (context.wants_details) diffusion.report(report);
    });
  } catch (const NoSolution& error) {
    throw NoResult(error.what());
  }
  add_errors(document, problem, mesh, report);
  return report;
}

PassReport DiffuseStage::take_steps(Diffusion& diffusion, Mesh& mesh, const StageContext& context) const {
  PassReport report;
  double taken = 0;
  for (int k = 0; k < steps_; ++k) {
    const double before = mesh.time;
    std::vector<Point> from;
    if (motion_.moves()) from.assign(mesh.points().begin(), mesh.points().end());
    AdvectOutcome outcome = motion_.move(mesh, context.goal);
    if (outcome.status != AdvectOutcome::Status::late) diffusion.step(from, before);
    if (outcome.status == AdvectOutcome::Status::late && k > 0) break;
    taken += outcome.dt;
    report = std::move(outcome.report);
    if (outcome.status != AdvectOutcome::Status::done) break;
  }
  for (auto& [name, value] : report.values)
    if (name == "dt") value = taken;
  return report;
}

void DiffuseStage::add_errors(const ProblemDocument& document, const DiffusionProblem& problem, const Mesh& mesh,
                              PassReport& report) const {
  if (errors_.empty()) return;
  const ProblemNames names(document, mesh, problem.field);
  std::vector<std::optional<Coefficient>> exact(mesh.boundary().faces.size());
  for (const std::string& text : errors_) {
    // "FACE=" opens the text only if there is such a face: "a==b" is an expression.
    const std::size_t equals = text.find('=');
    const FaceId face = equals == std::string::npos ? outside : find_face(mesh.boundary(), text.substr(0, equals));
    const Coefficient compared = exact_solution(names, text, face == outside ? text : text.substr(equals + 1));
    for (std::size_t f = 0; f < exact.size(); ++f)
      if (face == outside || index(face) == f) exact[f] = compared;
  }
  const ErrorNorms norms = error_norms(mesh, problem.field, exact);
  report.add("error_l2", norms.l2);
  report.add("error_h1", norms.h1);
  report.add("error_rule", norms.exact_degree);
}

}  // namespace pliant
