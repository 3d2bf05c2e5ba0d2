// tools/flipdelaunay.cpp: flips edges until the logical mesh is Delaunay.
#include <CLI/CLI.hpp>

#include "filter.h"
#include "pliant/improve/enforce_delaunay.h"
#include "refit_option.h"

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Flip edges until the logical mesh is Delaunay.", "flipdelaunay"};
  DelaunayOptions options;
  app.add_option("--max-flips", options.max_flips, "flip at most N edges; negative: as many as it takes")
      ->type_name("N")
      ->capture_default_str();
  add_projection_option(app, options.refit);
  return run_filter(app, argc, argv, [&](Mesh& mesh) { return enforce_delaunay(mesh, options); });
}
