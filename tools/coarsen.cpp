// tools/coarsen.cpp: removes vertices that neither size nor geometry needs.
#include "pliant/improve/coarsen.h"

#include <CLI/CLI.hpp>

#include "criteria_options.h"
#include "filter.h"
#include "refit_option.h"

namespace {
constexpr double default_tolerance = 1e-3;  // of the mesh's size
constexpr double default_share = 0.1;       // of the tolerance, for one removal
}  // namespace

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Remove vertices that neither size nor geometry needs.", "coarsen"};
  CriteriaOptions criteria;
  CoarsenOptions options, given;  // for the mesh at hand; lengths as given, in the document's unit
  std::string tolerance, step_tolerance, polygon_tolerance, factor = "1", feature_share;
  criteria.add(app);
  app.add_option("--tolerance", tolerance,
                 "bound of what knot removals change of a curve in all, as the document keeps account of it; 0: curves "
                 "stay as they are; default: 0.001 of the mesh's size")
      ->type_name("LENGTH");
  app.add_option("--step-tolerance", step_tolerance, "bound of what one removal changes; default: 0.1 of --tolerance")
      ->type_name("LENGTH");
  app.add_option("--polygon-tolerance", polygon_tolerance,
                 "keep the knots whose control points Douglas-Peucker keeps at this tolerance; default: not asked")
      ->type_name("LENGTH");
  app.add_option("--factor", factor, "scale the distance at which vertices are kept")
      ->type_name("F")
      ->capture_default_str();
  app.add_option("--feature-size", feature_share,
                 "wanted edges no longer than this part of the local feature size of the curves; default: not asked")
      ->type_name("F");
  app.add_option_function<std::string>(
         "--region-change",
         [&](const std::string& name) {
           options.refit.region_change = name == "conserve" ? RegionChange::conserve : RegionChange::reproduce;
         },
         "what fields keep where a curve moves: linear functions (default), or integrals")
      ->type_name("reproduce|conserve")
      ->check(CLI::IsMember({"reproduce", "conserve"}).description(""));
  app.add_flag("--keep-area", options.keep_area, "removals keep the area inside their curve");
  add_projection_option(app, options.refit);
  FilterOptions filter;
  filter.prepare = [&](const ToolOptions&) {
    criteria.check();
    options.factor = parse_positive("--factor", factor);
    if (!polygon_tolerance.empty())
      options.polygon_tolerance = parse_positive("--polygon-tolerance", polygon_tolerance);
    if (!feature_share.empty()) options.feature_share = parse_positive("--feature-size", feature_share);
    if (!tolerance.empty()) options.tolerance = parse_not_negative("--tolerance", tolerance);
    if (!step_tolerance.empty()) options.step_tolerance = parse_not_negative("--step-tolerance", step_tolerance);
    given = options;
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        options.goals = criteria.goals(mesh, compile_size);
        const double unit = mesh.boundary().unit;
        options.tolerance = tolerance.empty() ? default_tolerance * mesh.size() : given.tolerance / unit;
        options.step_tolerance =
            step_tolerance.empty() ? default_share * options.tolerance : given.step_tolerance / unit;
        options.polygon_tolerance = given.polygon_tolerance / unit;
        return coarsen(mesh, options);
      },
      filter);
}
