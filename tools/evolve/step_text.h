// tools/evolve/step_text.h: the text of a step, a pipe of stages, split into words as a shell splits it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// One word of a step, its quotes removed.
struct StepWord {
  std::string text;
  std::size_t place = 0;  ///< of its first character in the step, in bytes
};

/// One command of the pipe: the name of a tool, then its options.
using StepCommand = std::vector<StepWord>;

/// The commands of a step such as "advect --flow vortex --dt 0.01 | refine", at least one, each with at least one word.
///
/// Words, quotes, backslashes, comments and the ends of lines are taken as a POSIX shell takes them, and `|` ends a
/// command. All else that means something to a shell (variables, lists, redirections, patterns) is refused: a step is
/// not run by a shell.   Complexity O(text)
///
/// Throws      UsageError with the line and column of what is wrong, and what would be right
std::vector<StepCommand> split_step(std::string_view text);

/// "line 1, column 8", both from 1, columns in bytes; for messages about a word of the step.
std::string describe_step_place(std::string_view text, std::size_t place);

}  // namespace pliant
