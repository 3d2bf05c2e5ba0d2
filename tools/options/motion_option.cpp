// tools/options/motion_option.cpp: reads the options of a step of motion, and takes it.
#include "options/motion_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>
#include <string_view>

#include "options/numbers.h"
#include "pliant/flow/advect_to.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

struct Method {
  std::string_view name;
  TimeMethod method;
};
constexpr Method methods[] = {{"euler", TimeMethod::euler},
                              {"midpoint", TimeMethod::midpoint},
                              {"rk4", TimeMethod::rk4},
                              {"dopri5", TimeMethod::dopri5}};

std::string method_names(const char* separator = ", ") {
  std::string names;
  for (const Method& each : methods) names += (names.empty() ? "" : separator) + std::string(each.name);
  return names;
}

/// Why no step was taken, in words.
std::string explain(const AdvectOutcome& outcome, double time, StepPolicy policy) {
  using Status = AdvectOutcome::Status;
  std::ostringstream text;
  text.precision(6);
  if (outcome.status == Status::no_progress) {  // a loop until some time would never end
    const double next = std::nextafter(time, std::numeric_limits<double>::infinity()) - time;
    text.precision(17);
    text << "the step does not advance the time " << time;
    text.precision(3);
    text << ": the next number is " << next << " later, so that --dt must be at least that; or let the time begin at 0";
    return text.str();
  }
  const std::string note = outcome.report.notes.empty() ? "" : outcome.report.notes.front();
  if (outcome.status == Status::unsafe)
    text << "a step of " << outcome.asked_dt << " is not proved safe beyond " << outcome.fraction << " of it (dt "
         << outcome.fraction * outcome.asked_dt << "): " << note
         << (policy == StepPolicy::refuse ? "; --limit takes a safe part of it" : "; no part of it is worth taking");
  else
    text << "no step was taken: " << note;
  return text.str();
}

/// Options that say how a mesh moves, beside its velocity.
constexpr std::array needing_motion{"--acceleration-field", "--flow-field", "--outside",   "--method",  "--tol",
                                    "--substeps",           "--limit",      "--keep-area", "--min-gap", "--gap"};

/// The first of these options that was given; empty if none was.
std::string find_given(const CLI::App& app, std::span<const char* const> options) {
  const auto given = std::ranges::find_if(options, [&app](const char* option) { return app.count(option) > 0; });
  return given == options.end() ? "" : *given;
}

AdvectOutcome let_time_go_on(Mesh& mesh, double dt) {
  AdvectOutcome outcome{};
  outcome.status = AdvectOutcome::Status::done;
  outcome.dt = outcome.asked_dt = dt;
  outcome.fraction = 1;
  outcome.blocking = none;
  mesh.time += dt;
  outcome.report.add("dt", dt);
  outcome.report.add("time", mesh.time);
  return outcome;
}

}  // namespace

void MotionOption::add(CLI::App& app, Offer offer) {
  offer_ = offer;
  if (!offer.by_itself) flow_.add(app);
  app.add_option("--dt", dt_text_, "the time step")->type_name("DT");
  app.add_option("--until", until_text_, "step by min(DT, T - time); a mesh at T or later passes through")
      ->type_name("T");
  if (!offer.by_itself) add_method(app);
  app.add_flag("--limit", limit_, "where the step is unsafe, take a shorter one that is safe");
  if (offer.may_force) app.add_flag("--force", force_, "take the step also if it inverts elements");
  app.add_flag("--keep-area", options_.keep_area, "keep the area inside each closed curve, by one normal offset");
  app.add_option("--min-gap", min_gap_text_, "refuse the step where boundaries are closer to each other than that")
      ->type_name("LENGTH");
  app.add_option("--gap", gap_, "where a gap would be thinner than --min-gap: stop, or hold what closes it")
      ->type_name("stop|hold")
      ->capture_default_str();
}

void MotionOption::add_method(CLI::App& app) {
  app.add_option("--method", method_, "how points are carried: " + method_names())
      ->type_name(method_names("|"))
      ->capture_default_str();
  app.add_option("--tol", tolerance_text_,
                 "with --method dopri5: what the estimates of the error within DT may sum up to, a length (1e-9 of the "
                 "mesh's size by default)")
      ->type_name("TOL");
  app.add_option("--substeps", options_.substeps, "equal steps of the method within DT")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
}

bool MotionOption::is_given(const CLI::App& app) {
  return VelocityOption::is_given(app) || app.count("--dt") > 0 || app.count("--until") > 0 ||
         !find_given(app, needing_motion).empty();
}

void MotionOption::check(const CLI::App& app) {
  moves_ = !offer_.may_rest || (!offer_.by_itself && VelocityOption::is_given(app));
  if (!moves_)
    if (const std::string option = find_given(app, needing_motion); !option.empty())
      throw UsageError(option +
                       " has no meaning for a mesh at rest; a velocity makes it move (--vx with --vy, --flow or "
                       "--velocity-field)");
  if (limit_ && force_) throw UsageError("--limit and --force exclude each other");
  if (app.count("--dt") == 0) throw UsageError("--dt is required");
  options_.dt = parse_positive("--dt", dt_text_);
  if (app.count("--until") > 0) until_ = parse_number("--until", until_text_);
  options_.policy = limit_ ? StepPolicy::limit : force_ ? StepPolicy::force : StepPolicy::refuse;
  if (gap_ != "stop" && gap_ != "hold") throw UsageError("--gap: '" + gap_ + "' is neither stop nor hold");
  if (app.count("--gap") > 0 && app.count("--min-gap") == 0) throw UsageError("--gap needs --min-gap");
  options_.gap = gap_ == "hold" ? GapPolicy::hold : GapPolicy::stop;
  if (app.count("--min-gap") > 0) min_gap_ = parse_positive("--min-gap", min_gap_text_);
  if (!moves_ || offer_.by_itself) return;
  flow_.check(app);
  check_method(app);
}

void MotionOption::check_method(const CLI::App& app) {
  const auto named = std::ranges::find(methods, method_, &Method::name);
  if (named == std::end(methods))
    throw UsageError("--method: there is no method \"" + method_ + "\"; there are " + method_names());
  options_.method = named->method;
  const bool adaptive = options_.method == TimeMethod::dopri5;
  if (app.count("--velocity-field") > 0 && app.count("--method") > 0)
    throw UsageError("--method has no meaning with --velocity-field, whose field is known at one time only");
  if (app.count("--tol") > 0 && !adaptive) throw UsageError("--tol needs --method dopri5");
  if (app.count("--substeps") > 0 && adaptive)
    throw UsageError("--substeps has no meaning with --method dopri5, which chooses its steps");
  if (app.count("--tol") > 0) options_.tolerance = parse_positive("--tol", tolerance_text_);
}

AdvectOutcome MotionOption::move(Mesh& mesh, std::optional<double> goal) const {
  if (!moves_) return rest(mesh, goal);
  if (!flow_.velocity())
    return move(mesh, goal, [this, &mesh](const AdvectOptions& step) {
      return advect_by_field(mesh, flow_.find_field(mesh), step, flow_.find_acceleration(mesh));
    });
  return take(mesh, goal, [this, &mesh](const AdvectOptions& options, std::optional<double> until) {
    return advect_to(mesh, flow_.velocity(), options, until);
  });
}

AdvectOutcome MotionOption::rest(Mesh& mesh, std::optional<double> goal) const {
  return move(mesh, goal, [&mesh](const AdvectOptions& step) { return let_time_go_on(mesh, step.dt); });
}

AdvectOutcome MotionOption::move(Mesh& mesh, std::optional<double> goal, const Step& step) const {
  return take(mesh, goal, [&](const AdvectOptions& options, std::optional<double> until) {
    return advect_to(mesh, options, until, step);
  });
}

AdvectOutcome MotionOption::take(Mesh& mesh, std::optional<double> goal, const Towards& advance) const {
  const double before = mesh.time;
  AdvectOptions options = options_;
  options.min_gap = min_gap_ / mesh.boundary().unit;
  if (goal && options.policy == StepPolicy::refuse) options.policy = StepPolicy::limit;
  AdvectOutcome outcome = advance(options, goal ? goal : until_);
  using Status = AdvectOutcome::Status;
  if (outcome.status != Status::done && outcome.status != Status::limited && outcome.status != Status::late)
    throw NoResult(explain(outcome, before, options.policy));
  return outcome;
}

}  // namespace pliant
