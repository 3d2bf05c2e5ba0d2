// tools/evolve/print_pipe.cpp: the shell loop of tools that a command of evolve equals.
#include "evolve/print_pipe.h"

#include <algorithm>
#include <charconv>

#include "run/exit_status.h"

namespace pliant {
namespace {

std::string text_of(double value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string quoted_word(const std::string& word) { return text_of(StepCommand{{word, 0}}); }

/// The step as a pipe of the shell, which moves to the time in $goal.
std::string pipe_to_goal(const Step& step) {
  std::string pipe;
  for (std::size_t k = 0; k < step.commands.size(); ++k) {
    pipe += (k == 0 ? "" : " | ") + text_of(step.commands[k]);
    if (k != step.moving) continue;
    const bool has_policy = std::ranges::any_of(
        step.commands[k], [](const StepWord& word) { return word.text == "--limit" || word.text == "--force"; });
    pipe += std::string(has_policy ? "" : " --limit") + " --until \"$goal\"";
  }
  return pipe;
}

/// Lines "GOAL FRAME": the times at which steps, or parts of them before a frame, end, and whether one is a frame. Awk
/// counts in doubles, as evolve does.
constexpr const char* goals_in_awk = R"awk(
function text(time) { return sprintf("%.17g", time) }
function size(value) { return value < 0 ? -value : value }
function round(time,  short, few) {  # a round time stays round
  short = sprintf("%.12g", time) + 0
  few = 8.881784197001252e-16 * (size(time) > dt ? size(time) : dt)
  return size(short - time) <= (few < slack ? few : slack) ? short : time
}
function tell(goal, frame) {
  if (until != "" && goal >= until - slack) goal = until + 0
  if (goal - last <= slack) return
  last = goal
  print text(goal), frame
}
BEGIN {
  t0 += 0; dt += 0; slack = 1e-9 * dt; last = t0
  n = split(at, frames, " ")
  k = 1
  while (k <= n && frames[k] + 0 <= t0 + slack) ++k
  for (j = 1; (steps == "" || j <= steps) && (until == "" || last < until - slack); ++j) {
    goal = round(t0 + j * dt)
    if (until != "" && goal >= until - slack) goal = until + 0
    for (; k <= n && frames[k] + 0 <= goal + slack; ++k) {
      if (frames[k] + 0 >= goal - slack) goal = frames[k] + 0
      tell(frames[k] + 0, 1)
    }
    tell(goal, every > 0 && j % every == 0)
  }
})awk";

}  // namespace

std::string pipe_of(const EvolveOptions& options, const Step& step) {
  if (options.courant > 0) throw UsageError("--print-pipe: no loop of tools chooses its steps as --cfl does");
  if (options.steady > 0) throw UsageError("--print-pipe: no loop of tools ends as --until-steady does");
  if (options.tool.to == "cbor")
    throw UsageError("--print-pipe: the loop looks for times in JSON; leave out --to cbor");
  const ScheduleOptions& schedule = options.schedule;
  std::string at;
  std::vector<double> times = schedule.at;
  std::ranges::sort(times);
  for (const double time : times) at += (at.empty() ? "" : " ") + text_of(time);
  const bool to_file = options.tool.output != "-" && !options.is_numbered();
  const std::string add_frame = options.is_numbered() ? "cp \"$work/state\" \"$(printf " + quoted_word(options.frames) +
                                                            " \"$frames\")\"; frames=$((frames + 1))"
                                : to_file ? "cat \"$work/state\" >> " + quoted_word(options.tool.output)
                                          : "cat \"$work/state\"";
  std::string text = "#!/bin/bash\n# The loop of tools that equals:\n#   evolve";
  if (schedule.until) text += " --until " + text_of(*schedule.until);
  if (schedule.steps) text += " --steps " + std::to_string(*schedule.steps);
  text += options.frame_options() + " STEP, with the step that is the pipe below\nset -euo pipefail\nexport LC_ALL=C\n";
  text += "work=$(mktemp -d)\ntrap 'rm -rf \"$work\"' EXIT\n";
  text +=
      "time_of() {\n  awk 'match($0, /\"time\"[ \\t]*:[ \\t]*[-+.0-9eE]+/) {\n"
      "         time = substr($0, RSTART, RLENGTH); sub(/.*:[ \\t]*/, \"\", time); print time; exit\n       }' "
      "\"$1\"\n}\n";
  text += std::string("goals() {\n  awk -v t0=\"$1\" -v dt=") + text_of(step.mover().time_step()) +
          " -v until=" + (schedule.until ? text_of(*schedule.until) : "") +
          " -v steps=" + (schedule.steps ? std::to_string(*schedule.steps) : "") +
          " -v every=" + std::to_string(schedule.every) + " -v at='" + at + "' '" + goals_in_awk + "'\n}\n\n";
  text += "# A mesh that is late passes through: written as the tools write.\n";
  text += "advect --vx 0 --vy 0 --dt 1 --until=-1e308 --to json -- " + quoted_word(options.tool.input) +
          " > \"$work/state\"\n";
  if (to_file) text += ": > " + quoted_word(options.tool.output) + "\n";
  if (options.is_numbered()) text += "frames=0\n";
  text += add_frame + "\nwritten=1\nwhile read -r goal frame; do\n  parts=0\n";
  text +=
      "  while awk -v time=\"$(time_of \"$work/state\")\" -v goal=\"$goal\" 'BEGIN { exit !(time + 0 < goal + 0) }'; "
      "do\n";
  text += "    [ $((parts += 1)) -le 20 ] || { echo \"blocked before time $goal\" >&2; exit 4; }\n";
  text += "    cat \"$work/state\" | " + pipe_to_goal(step) + " > \"$work/next\"\n";
  text += "    mv \"$work/next\" \"$work/state\"\n  done\n";
  text += "  written=$frame\n  if [ \"$written\" = 1 ]; then " + add_frame +
          "; fi\ndone < <(goals \"$(time_of \"$work/state\")\")\n";
  text += "if [ \"$written\" != 1 ]; then " + add_frame + "; fi  # the last state\n";
  return text;
}

}  // namespace pliant
