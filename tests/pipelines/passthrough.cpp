// tests/pipelines/passthrough.cpp: a filter that leaves the mesh alone, or fails as it is told: what every tool
// inherits.
#include <CLI/CLI.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "criteria_options.h"
#include "filter.h"
#include "progress_line.h"

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Pass meshes through.", "passthrough"};
  double stop_at = std::numeric_limits<double>::infinity();
  double spoil_at = std::numeric_limits<double>::infinity();
  std::string fault;
  int naps = 0;
  FilterOptions filter;
  CriteriaOptions criteria;
  app.add_option("--stop-at", stop_at, "no result from this time on");
  app.add_option("--spoil-at", spoil_at, "make a number that is not finite from this time on");
  app.add_option("--fault", fault, "throw an exception that a tool does not expect, of this kind");
  app.add_flag("--tangled", filter.accepts_tangled, "take tangled meshes");
  app.add_option("--naps", naps, "sleep so many tenths of a second a mesh, and count them");
  criteria.add(app);
  filter.prepare = [&](const ToolOptions&) {
    criteria.check();
    if (fault == "early") throw std::runtime_error("told to fail");
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        if (mesh.time >= stop_at) throw NoResult("told to stop");
        if (fault == "logic") throw std::logic_error("told to fail");
        if (fault == "length") throw std::length_error("told to fail");
        if (fault == "integer") throw 7;
        if (mesh.time >= spoil_at) mesh.time = std::numeric_limits<double>::quiet_NaN();
        criteria.apply(mesh.criteria, mesh.boundary());
        Progress* progress = ProgressLine::shown() != nullptr ? ProgressLine::shown()->counters() : nullptr;
        if (progress != nullptr) progress->start("sleep", "naps", naps);
        for (int nap = 0; nap < naps; ++nap) {
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
          if (progress != nullptr) progress->count(nap + 1);
        }
        PassReport report;
        report.add("triangles", mesh.triangle_count());
        report.add("half", 0.5);
        report.refuse("would \"invert\"", 3);
        for (int k = 0; k < 1200; ++k) report.refuse("too far", {0.5 + k, -2});
        report.notes.push_back("nothing was done");
        return report;
      },
      filter);
}
