// tools/refine.cpp: inserts points into elements that are too large or too poor.
#include "pliant/improve/refine.h"

#include <CLI/CLI.hpp>

#include "criteria_options.h"
#include "filter.h"
#include "progress_line.h"
#include "refit_option.h"

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Insert points into elements that are too large or too poor, split edges that turn too much.", "refine"};
  CriteriaOptions criteria;
  RefineOptions options;
  criteria.add(app);
  app.add_option("--max-insertions", options.max_insertions, "insert at most N points in a mesh; default: any number")
      ->type_name("N")
      ->check(CLI::Range(0L, 1000000000L).description(""));
  add_max_triangles(app, options.max_triangles);
  add_projection_option(app, options.refit);
  FilterOptions filter;
  const ToolOptions* tool = nullptr;
  filter.prepare = [&](const ToolOptions& parsed) {
    tool = &parsed;
    criteria.check();
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        options.goals = criteria.goals(mesh, compile_size);
        warn_of_thin_gaps(*tool, mesh, options.goals);
        options.progress = start_refinement(mesh, options.goals);
        return refine(mesh, options);
      },
      filter);
}
