// tools/stages/coarsen.h: the stage that removes vertices that neither size nor geometry needs.
#pragma once
#include <optional>
#include <string>

#include "options/criteria_options.h"
#include "pliant/improve/coarsen.h"
#include "stages/stage.h"

namespace pliant {

class CoarsenStage : public Stage {
 public:
  const char* name() const override { return "coarsen"; }
  const char* description() const override { return "Remove vertices that neither size nor geometry needs."; }
  void add_options(CLI::App& app) override;
  void check(const CLI::App&) override;
  PassReport run(Mesh& mesh, const StageContext&) const override;

 private:
  CriteriaOptions criteria_;
  CoarsenOptions options_;  ///< lengths in units of the document
  std::optional<std::string> tolerance_, step_tolerance_, polygon_tolerance_, feature_share_;
  std::string factor_ = "1";
};

}  // namespace pliant
