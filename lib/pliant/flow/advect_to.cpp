// lib/pliant/flow/advect_to.cpp: steps of a loop that ends at a given time.
#include "pliant/flow/advect_to.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace pliant {
namespace {

using Status = AdvectOutcome::Status;

/// Two times closer than this part of the step are the same: a sum of steps misses a round time by a few bits, which
/// must not make another step.
constexpr double same_time = 1e-9;

AdvectOutcome stand_still(Status status, double time) {
  AdvectOutcome outcome{};
  outcome.status = status;
  outcome.blocking = none;
  outcome.report.add("dt", 0);
  outcome.report.add("time", time);
  return outcome;
}

}  // namespace

AdvectOutcome advect_to(Mesh& mesh, AdvectOptions options, std::optional<double> until, const Step& step) {
  const double before = mesh.time;
  if (until && !(*until > before)) return stand_still(Status::late, before);
  const bool reaches = until && *until - before <= options.dt * (1 + same_time);
  if (reaches) options.dt = *until - before;
  if (!(before + options.dt > before)) return stand_still(Status::no_progress, before);
  AdvectOutcome outcome = step(options);
  if (outcome.status != Status::done) return outcome;
  mesh.time = reaches ? *until : round_time(mesh.time, options.dt);
  for (auto& [name, value] : outcome.report.values)
    if (name == "time") value = mesh.time;
  return outcome;
}

double round_time(double time, double dt) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.12g", time);
  const double round = std::strtod(digits, nullptr);
  constexpr double few_bits = 4 * std::numeric_limits<double>::epsilon();
  const double allowed = std::min(same_time * dt, few_bits * std::max(std::abs(time), dt));
  return std::abs(round - time) <= allowed ? round : time;
}

AdvectOutcome advect_to(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options,
                        std::optional<double> until) {
  const double unit = mesh.boundary().unit;
  const VelocityField in_unit = [&velocity, unit](const Point& place, double time) {
    return velocity(unit * place, time) / unit;
  };
  return advect_to(mesh, options, until, [&](AdvectOptions step) {
    if (step.tolerance) *step.tolerance /= unit;
    return advect(mesh, unit == 1 ? velocity : in_unit, step);
  });
}

}  // namespace pliant
