// tools/stages/advect.cpp: the options of advect, and its step.
#include "stages/advect.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "options/numbers.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

/// Two times closer than this part of the step are the same: a sum of steps misses a round time by a few bits.
constexpr double same_time = 1e-9;

/// Why no step was taken, in words.
std::string explain(const AdvectOutcome& outcome, double dt) {
  using Status = AdvectOutcome::Status;
  std::ostringstream text;
  text.precision(6);
  const std::string note = outcome.report.notes.empty() ? "" : outcome.report.notes.front();
  if (outcome.status == Status::unsafe)
    text << "a step of " << dt << " is not proved safe beyond " << outcome.fraction << " of it (dt "
         << outcome.fraction * dt << "): " << note << "; --limit takes a safe part of it";
  else
    text << "no step was taken: " << note;
  return text.str();
}

/// The time that a step led to, without the rounding errors that steps of a round length pile up: 100 steps of 0.05
/// from 0 end at 5. It is the nearest number of at most 12 digits, if that is the same time.
double round_time(double time, double dt) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.12g", time);
  const double round = std::strtod(digits, nullptr);
  constexpr double few_bits = 4 * std::numeric_limits<double>::epsilon();
  const double allowed = std::min(same_time * dt, few_bits * std::max(std::abs(time), dt));
  return std::abs(round - time) <= allowed ? round : time;
}

/// A loop until some time would never end.
void require_progress(double before, double after) {
  if (after > before) return;
  const double next = std::nextafter(before, std::numeric_limits<double>::infinity()) - before;
  std::ostringstream text;
  text.precision(17);
  text << "the step does not advance the time " << before;
  text.precision(3);
  text << ": the next number is " << next << " later, so that --dt must be at least that; or let the time begin at 0";
  throw NoResult(text.str());
}

/// What is reported of a mesh that is late enough already.
PassReport report_no_step(const Mesh& mesh) {
  PassReport passed;
  passed.add("dt", 0);
  passed.add("time", mesh.time);
  return passed;
}

}  // namespace

void AdvectStage::add_options(CLI::App& app) {
  flow_.add(app);
  app.add_option("--dt", dt_text_, "the time step")->type_name("DT");
  app.add_option("--until", until_text_, "step by min(DT, T - time); a mesh at T or later passes through")
      ->type_name("T");
  app.add_option("--substeps", options_.substeps, "Runge-Kutta steps within DT")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_flag("--limit", limit_, "where the step is unsafe, take a shorter one that is safe");
  app.add_flag("--force", force_, "take the step also if it inverts elements");
  app.add_flag("--keep-area", options_.keep_area, "keep the area inside each closed curve, by one normal offset");
  fields_.add(app);
}

void AdvectStage::check(const CLI::App& app) {
  if (limit_ && force_) throw UsageError("--limit and --force exclude each other");
  if (app.count("--dt") == 0) throw UsageError("--dt is required");
  options_.dt = parse_positive("--dt", dt_text_);
  if (app.count("--until") > 0) until_ = parse_number("--until", until_text_);
  options_.policy = limit_ ? StepPolicy::limit : force_ ? StepPolicy::force : StepPolicy::refuse;
  flow_.check(app);
  fields_.check();
}

PassReport AdvectStage::run(Mesh& mesh, const StageContext& context) const {
  fields_.apply(mesh);
  AdvectOptions options = options_;
  const double before = mesh.time;
  bool reaches = false;  // the time at which to stop
  if (until_) {
    const double left = *until_ - before;
    if (!(left > 0)) return report_no_step(mesh);
    reaches = left <= options_.dt * (1 + same_time);
    if (reaches) options.dt = left;
  }
  require_progress(before, reaches ? *until_ : before + options.dt);
  const double unit = mesh.boundary().unit;
  const VelocityField in_unit = [this, unit](const Point& place, double time) {
    return flow_.velocity()(unit * place, time) / unit;
  };
  AdvectOutcome outcome = flow_.velocity() ? advect(mesh, unit == 1 ? flow_.velocity() : in_unit, options)
                                           : advect_by_field(mesh, flow_.find_field(mesh), options);
  using Status = AdvectOutcome::Status;
  if (outcome.status != Status::done && outcome.status != Status::limited) throw NoResult(explain(outcome, options.dt));
  if (options.policy == StepPolicy::force && outcome.blocking != none)
    context.say("forced an unsafe step: " + outcome.report.notes.back());
  require_progress(before, mesh.time);
  if (outcome.status == Status::done) mesh.time = reaches ? *until_ : round_time(mesh.time, options.dt);
  for (auto& [name, value] : outcome.report.values)
    if (name == "time") value = mesh.time;
  return outcome.report;
}

}  // namespace pliant
