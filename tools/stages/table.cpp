// tools/stages/table.cpp: the stages that there are, by the names of their tools.
#include "stages/table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "options/usage.h"
#include "run/exit_status.h"
#include "stages/advect.h"
#include "stages/coarsen.h"
#include "stages/flipdelaunay.h"
#include "stages/refine.h"
#include "stages/smoothcurves.h"

namespace pliant {
namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Stage> (*make)();
};

template <class Kind>
std::unique_ptr<Stage> make() {
  return std::make_unique<Kind>();
}

constexpr std::array stages{
    Entry{"advect", make<AdvectStage>},
    Entry{"flipdelaunay", make<FlipDelaunayStage>},
    Entry{"refine", make<RefineStage>},
    Entry{"coarsen", make<CoarsenStage>},
    Entry{"smoothcurves", make<SmoothCurvesStage>},
};

}  // namespace

std::vector<std::string> stage_names() {
  std::vector<std::string> names;
  for (const Entry& entry : stages) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Stage> make_stage(const std::string& name) {
  const auto* const found = std::ranges::find(stages, name, &Entry::name);
  return found == stages.end() ? nullptr : found->make();
}

std::unique_ptr<Stage> parse_stage(const std::vector<std::string>& words) {
  const std::string name = words.empty() ? "" : words.front();
  std::unique_ptr<Stage> stage = make_stage(name);
  if (stage == nullptr) throw UsageError("there is no stage '" + name + "'");
  CLI::App app{stage->description(), name};
  stage->add_options(app);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend() - 1));
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> words_left = app.remaining();
    if (!words_left.empty() && !words_left.front().starts_with('-'))
      throw UsageError(name + ": a stage reads no INPUT, '" + words_left.front() + "' is too much");
    throw UsageError(name + ": " + explain_usage(app, error.what()));
  }
  stage->check(app);
  return stage;
}

}  // namespace pliant
