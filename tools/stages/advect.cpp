// tools/stages/advect.cpp: the options of advect, and its step.
#include "stages/advect.h"

namespace pliant {

void AdvectStage::add_options(CLI::App& app) {
  motion_.add(app, {.may_force = true});
  fields_.add(app);
}

void AdvectStage::check(const CLI::App& app) {
  motion_.check(app);
  fields_.check();
}

PassReport AdvectStage::run(Mesh& mesh, const StageContext& context) const {
  fields_.apply(mesh);
  const AdvectOutcome outcome = motion_.move(mesh, context.goal);
  if (motion_.forces() && outcome.blocking != none)
    context.say("forced an unsafe step: " + outcome.report.notes.back());
  return outcome.report;
}

}  // namespace pliant
