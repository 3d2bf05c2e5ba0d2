// tools/stages/coarsen.cpp: the options of coarsen, and its pass.
#include "stages/coarsen.h"

#include <CLI/CLI.hpp>

#include "options/numbers.h"
#include "options/refit_option.h"

namespace pliant {
void CoarsenStage::add_options(CLI::App& app) {
  criteria_.add(app);
  app.add_option("--tolerance", tolerance_,
                 "bound of what knot removals change of a curve in all, as the document keeps account of it; 0: curves "
                 "stay as they are; default: 0.001 of the mesh's size")
      ->type_name("LENGTH");
  app.add_option("--step-tolerance", step_tolerance_, "bound of what one removal changes; default: 0.1 of --tolerance")
      ->type_name("LENGTH");
  app.add_option("--polygon-tolerance", polygon_tolerance_,
                 "keep the knots whose control points Douglas-Peucker keeps at this tolerance; default: not asked")
      ->type_name("LENGTH");
  app.add_option("--factor", factor_, "scale the distance at which vertices are kept")
      ->type_name("F")
      ->capture_default_str();
  app.add_option("--feature-size", feature_share_,
                 "wanted edges no longer than this part of the local feature size of the curves; default: not asked")
      ->type_name("F");
  app.add_option_function<std::string>(
         "--region-change",
         [this](const std::string& name) {
           options_.refit.region_change = name == "conserve" ? RegionChange::conserve : RegionChange::reproduce;
         },
         "what fields keep where a curve moves: linear functions (default), or integrals")
      ->type_name("reproduce|conserve")
      ->check(CLI::IsMember({"reproduce", "conserve"}).description(""));
  app.add_flag("--keep-area", options_.keep_area, "removals keep the area inside their curve");
  add_projection_option(app, options_.refit);
}

void CoarsenStage::check(const CLI::App&) {
  criteria_.check();
  options_.factor = parse_positive("--factor", factor_);
  if (polygon_tolerance_) options_.polygon_tolerance = parse_positive("--polygon-tolerance", *polygon_tolerance_);
  if (feature_share_) options_.feature_share = parse_positive("--feature-size", *feature_share_);
  if (tolerance_) options_.tolerance = parse_not_negative("--tolerance", *tolerance_);
  if (step_tolerance_) options_.step_tolerance = parse_not_negative("--step-tolerance", *step_tolerance_);
}

PassReport CoarsenStage::run(Mesh& mesh, const StageContext&) const {
  CoarsenOptions options = options_;
  options.goals = criteria_.goals(mesh);
  const double unit = mesh.boundary().unit;
  if (options.tolerance) *options.tolerance /= unit;
  if (options.step_tolerance) *options.step_tolerance /= unit;
  options.polygon_tolerance /= unit;
  return coarsen(mesh, options);
}

}  // namespace pliant
