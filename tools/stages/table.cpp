// tools/stages/table.cpp: the stages that there are, by the names of their tools.
#include "stages/table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>

#include "options/usage.h"
#include "run/exit_status.h"
#include "stages/advect.h"
#include "stages/coarsen.h"
#include "stages/diffuse.h"
#include "stages/flipdelaunay.h"
#include "stages/measure.h"
#include "stages/navierstokes.h"
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

// One stage a line, in the order of a usual step; clang-format would put two on a line.
// clang-format off
constexpr std::array stages{
    Entry{"advect", make<AdvectStage>},
    Entry{"diffuse", make<DiffuseStage>},
    Entry{"navierstokes", make<NavierStokesStage>},
    Entry{"flipdelaunay", make<FlipDelaunayStage>},
    Entry{"refine", make<RefineStage>},
    Entry{"coarsen", make<CoarsenStage>},
    Entry{"smoothcurves", make<SmoothCurvesStage>},
    Entry{"measure", make<MeasureStage>},
};
// clang-format on

/// The number of the first word that is this one; 0 if none is.
std::size_t find_word(const std::vector<std::string>& words, const std::string& word) {
  const auto found = std::ranges::find(words, word);
  return found == words.end() ? 0 : static_cast<std::size_t>(found - words.begin());
}

/// The number of the first word that is an option which a complaint names; 0 if none is.
std::size_t find_named(const std::vector<std::string>& words, const std::string& complaint) {
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string option = words[k].substr(0, words[k].find('='));
    if (!option.starts_with("--")) continue;
    const std::size_t place = complaint.find(option);
    if (place == std::string::npos) continue;
    const std::size_t end = place + option.size();
    if (end == complaint.size() || (complaint[end] != '-' && std::isalnum(complaint[end]) == 0)) return k;
  }
  return 0;
}

std::string explain(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& left) {
  if (error.get_exit_code() == 0) return "a stage gives no help; `" + app.get_name() + " --help` does";
  if (!left.empty() && (left.front() == "-" || !left.front().starts_with('-')))
    return "a stage reads no INPUT, '" + left.front() + "' is too much";
  return explain_usage(app, error.what());
}

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
  if (stage == nullptr) throw StageUsageError("there is no stage '" + name + "'", 0);
  CLI::App app{stage->description(), name};
  stage->add_options(app);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend() - 1));
    stage->check(app);
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> left = app.remaining();
    const std::size_t word = left.empty() ? find_named(words, error.what()) : find_word(words, left.front());
    throw StageUsageError(name + ": " + explain(app, error, left), word);
  } catch (const UsageError& error) {
    throw StageUsageError(error.what(), find_named(words, error.what()));
  }
  return stage;
}

}  // namespace pliant
