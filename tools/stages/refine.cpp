// tools/stages/refine.cpp: the options of refine, and its pass.
#include "stages/refine.h"

#include <CLI/CLI.hpp>

#include "options/refit_option.h"
#include "options/triangle_limit.h"

namespace pliant {

void RefineStage::add_options(CLI::App& app) {
  criteria_.add(app);
  app.add_option("--max-insertions", options_.max_insertions, "insert at most N points in a mesh; default: any number")
      ->type_name("N")
      ->check(CLI::Range(0L, 1000000000L).description(""));
  add_max_triangles(app, options_.max_triangles);
  add_projection_option(app, options_.refit);
}

PassReport RefineStage::run(Mesh& mesh, const StageContext& context) const {
  RefineOptions options = options_;
  options.goals = criteria_.goals(mesh);
  options.progress = context.progress;
  warn_of_thin_gaps(mesh, *options.goals, context.say);
  return refine(mesh, options);
}

}  // namespace pliant
