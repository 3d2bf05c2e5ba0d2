// tools/stages/flipdelaunay.cpp: the options of flipdelaunay.
#include "stages/flipdelaunay.h"

#include <CLI/CLI.hpp>

#include "options/refit_option.h"

namespace pliant {

void FlipDelaunayStage::add_options(CLI::App& app) {
  app.add_option("--max-flips", options_.max_flips, "flip at most N edges; negative: as many as it takes")
      ->type_name("N")
      ->capture_default_str();
  add_projection_option(app, options_.refit);
}

}  // namespace pliant
