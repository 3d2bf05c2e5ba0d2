// lib/pliant/evolve/evolution.cpp: runs the passes again and again, towards goals in time.
#include "pliant/evolve/evolution.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <sstream>

namespace pliant {

Evolution::Evolution(Mesh& mesh, double first_time, std::vector<StepPass> passes, EvolutionOptions options,
                     long steps_done)
    : mesh_(mesh),
      passes_(std::move(passes)),
      options_(std::move(options)),
      schedule_(first_time, options_.schedule),
      counted_steps_(steps_done) {
  assert(std::ranges::count(passes_, true, &StepPass::advances_time) == 1);
}

long Evolution::steps_done() const {
  return options_.schedule.even_steps ? schedule_.steps_done(mesh_.time) : counted_steps_;
}

bool Evolution::is_done() const { return !schedule_.next_goal(mesh_.time, steps_done(), options_.schedule.dt); }

StepRecord Evolution::advance() {
  const long done = steps_done();
  const std::optional<double> goal = schedule_.next_goal(mesh_.time, done, options_.longest_step(mesh_));
  assert(goal);
  if (!(*goal > mesh_.time)) {
    std::ostringstream text;
    text.precision(17);
    text << "at time " << mesh_.time << ": a step of " << options_.schedule.dt
         << " does not advance the time, whose digits are too many";
    throw StepBlocked(text.str());
  }
  StepRecord record;
  record.step = done + 1;
  record.part = ++part_;
  const double before = mesh_.time;
  const PassReport* moved = nullptr;
  record.work.reserve(passes_.size());
  for (const StepPass& pass : passes_) {
    const auto start = std::chrono::steady_clock::now();
    PassReport report = pass.run(mesh_, *goal);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    record.work.push_back({std::move(report), passed.count()});
    if (pass.advances_time) moved = &record.work.back().report;
  }
  record.time = mesh_.time;
  record.dt = mesh_.time - before;
  const bool reached = mesh_.time >= *goal;
  record.ends_step = reached && schedule_.ends_step(mesh_.time);
  if (!options_.schedule.even_steps) ++counted_steps_;
  if (reached)
    part_ = 0;
  else
    require_progress(record, *moved);
  return record;
}

void Evolution::require_progress(const StepRecord& record, const PassReport& moved) {
  const bool is_small = !(record.dt >= options_.least_part * options_.schedule.dt);
  if (!is_small && record.part < options_.most_parts) return;
  std::ostringstream text;
  text.precision(12);
  text << "at time " << record.time << ", in step " << record.step << ": ";
  if (is_small)
    text << "only " << record.dt << " of a step of " << options_.schedule.dt << " could be taken";
  else
    text << record.part << " parts of the step have not finished it";
  if (!moved.notes.empty()) text << "; " << moved.notes.front();
  throw StepBlocked(text.str());
}

}  // namespace pliant
