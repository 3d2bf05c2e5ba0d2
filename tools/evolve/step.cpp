// tools/evolve/step.cpp: reads a step with the very code of its tools, and says where in the text it is wrong.
#include "evolve/step.h"

#include <algorithm>

#include "run/exit_status.h"
#include "stages/run_stage.h"
#include "stages/table.h"

namespace pliant {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

/// The names of the stages that move time on.
std::vector<std::string> mover_names() {
  std::vector<std::string> names = stage_names();
  std::erase_if(names, [](const std::string& name) { return !make_stage(name)->advances_time(); });
  return names;
}

class StepParser {
 public:
  explicit StepParser(std::string_view text) : text_(text) {}

  Step parse() {
    Step step;
    step.commands = split_step(text_);
    bool moves = false;
    for (const StepCommand& command : step.commands) {
      step.stages.push_back(parse_command(command));
      const Stage& stage = *step.stages.back();
      if (stage.explains())
        fail(command.front(), std::string(stage.name()) + ": " + stage.explaining_option() + " does nothing to a mesh");
      if (!stage.advances_time()) continue;
      if (moves) fail(command.front(), "a second stage that moves time on; exactly one may");
      if (stage.own_end() != nullptr)
        fail(command.front(), std::string(stage.name()) + ": " + stage.own_end() +
                                  " belongs to evolve, which tells the step how far to go: give it before STEP");
      moves = true;
      step.moving = step.stages.size() - 1;
    }
    if (!moves)
      throw UsageError("STEP: no stage moves time on, so that the loop would never end; exactly one of " +
                       joined(mover_names()) + " is wanted");
    return step;
  }

 private:
  [[noreturn]] void fail(const StepWord& word, const std::string& what) const {
    throw UsageError("STEP, " + describe_step_place(text_, word.place) + ": " + what);
  }

  std::unique_ptr<Stage> parse_command(const StepCommand& command) const {
    if (make_stage(command.front().text) == nullptr)
      fail(command.front(), "there is no stage '" + command.front().text + "'; the tools that change meshes are " +
                                joined(stage_names()));
    std::vector<std::string> words;
    for (const StepWord& word : command) words.push_back(word.text);
    try {
      return parse_stage(words);
    } catch (const StageUsageError& error) {
      fail(command[error.word()], error.what() + advice(command[error.word()].text));
    }
  }

  /// More on the options that every tool has, but no stage.
  static std::string advice(const std::string& word) {
    const std::string option = word.substr(0, word.find('='));
    if (option == "-o" || option == "--output") return "; evolve writes the frames: give it before STEP";
    if (option == "--report") return "; evolve's own --log tells what each stage did";
    if (option == "--history") return "; give --add-history to evolve, before STEP";
    if (option == "--to") return "; give it to evolve, before STEP: documents are written there";
    if (option == "-q" || option == "--quiet" || option == "-v" || option == "--verbose")
      return "; give it to evolve, before STEP";
    return "";
  }

  std::string_view text_;
};

bool is_plain(const std::string& word) {
  constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+:,./@%^";
  return !word.empty() && word.find_first_not_of(harmless) == std::string::npos;
}

std::string quoted(const std::string& word) {
  if (is_plain(word)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// Runs a stage; what it throws begins with its name.
PassReport run_named(const Stage& stage, const Stage& next, Mesh& mesh, const StageContext& context) {
  const std::string prefix = std::string(stage.name()) + ": ";
  try {
    PassReport report = run_stage(stage, mesh, context);
    hand_over(mesh, stage, next);
    return report;
  } catch (const BadMesh& error) {  // it was valid before
    throw NoResult(prefix + error.what());
  } catch (const InputError& error) {
    throw InputError(error.pointer(), prefix + error.what());
  } catch (const NoResult& error) {
    throw NoResult(prefix + error.what());
  } catch (const std::domain_error& error) {
    throw NoResult(prefix + error.what());
  }
}

}  // namespace

Step parse_step(std::string_view text) { return StepParser(text).parse(); }

std::string text_of(const StepCommand& command) {
  std::string text;
  for (const StepWord& word : command) text += (text.empty() ? "" : " ") + quoted(word.text);
  return text;
}

std::string text_of(const std::vector<StepCommand>& commands) {
  std::string text;
  for (const StepCommand& command : commands) text += (text.empty() ? "" : " | ") + text_of(command);
  return text;
}

std::vector<StepPass> passes_of(const Step& step, const StageContext& context, std::size_t& running) {
  std::vector<StepPass> passes;
  for (std::size_t k = 0; k < step.stages.size(); ++k) {
    const Stage* const stage = step.stages[k].get();
    const Stage* const next = step.stages[(k + 1) % step.stages.size()].get();
    passes.push_back({stage->name(), stage->advances_time(), [=, &context, &running](Mesh& mesh, double until) {
                        running = k;
                        StageContext towards = context;
                        if (stage->advances_time()) towards.goal = until;
                        return run_named(*stage, *next, mesh, towards);
                      }});
  }
  return passes;
}

}  // namespace pliant
