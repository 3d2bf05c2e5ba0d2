// tests/pipelines/passthrough.cpp: a filter that leaves the mesh alone, or fails as it is told: what every tool
// inherits
#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "criteria_options.h"
#include "filter.h"

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Pass meshes through.", "passthrough"};
  double stop_at = std::numeric_limits<double>::infinity();
  double spoil_at = std::numeric_limits<double>::infinity();
  FilterOptions filter;
  CriteriaOptions criteria;
  app.add_option("--stop-at", stop_at, "no result from this time on");
  app.add_option("--spoil-at", spoil_at, "make a number that is not finite from this time on");
  app.add_flag("--tangled", filter.accepts_tangled, "take tangled meshes");
  criteria.add(app);
  filter.prepare = [&](const ToolOptions&) { criteria.check(); };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        if (mesh.time >= stop_at) throw NoResult("told to stop");
        if (mesh.time >= spoil_at) mesh.time = std::numeric_limits<double>::quiet_NaN();
        criteria.apply(mesh.criteria, mesh.boundary());
        PassReport report;
        report.add("triangles", mesh.triangle_count());
        report.add("half", 0.5);
        report.refuse("would \"invert\"", 3);
        report.notes.push_back("nothing was done");
        return report;
      },
      filter);
}
