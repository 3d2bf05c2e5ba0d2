// tools/evolve/step.h: a step that was read from its text: stages that are ready to run.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "evolve/step_text.h"
#include "pliant/evolve/evolution.h"
#include "stages/stage.h"

namespace pliant {

/// The stages of a step, exactly one of which moves time on.
struct Step {
  std::vector<StepCommand> commands;
  std::vector<std::unique_ptr<Stage>> stages;  ///< one for each command
  std::size_t moving = 0;                      ///< the number of the stage that moves time on

  const Stage& mover() const { return *stages[moving]; }
};

/// Throws      UsageError with the place in the text and what would be right
Step parse_step(std::string_view text);

/// The step in one line, quoted as far as a shell needs it: equal for steps whose words are equal.
std::string text_of(const std::vector<StepCommand>& commands);
/// One command of it.
std::string text_of(const StepCommand& command);

/// The stages as passes of an evolution, each with the change to what the next one would read in a pipe. `running` is
/// told which one runs, and what a pass throws begins with its name. All three must live as long as the passes.
std::vector<StepPass> passes_of(const Step& step, const StageContext& context, std::size_t& running);

}  // namespace pliant
