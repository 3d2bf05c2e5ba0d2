// tools/stages/refine.h: the stage that inserts points into elements that are too large or too poor.
#pragma once
#include "options/criteria_options.h"
#include "pliant/improve/refine.h"
#include "stages/stage.h"

namespace pliant {

class RefineStage : public Stage {
 public:
  const char* name() const override { return "refine"; }
  const char* description() const override {
    return "Insert points into elements that are too large or too poor, split edges that turn too much.";
  }
  void add_options(CLI::App& app) override;
  void check(const CLI::App&) override { criteria_.check(); }
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  CriteriaOptions criteria_;
  RefineOptions options_;
};

}  // namespace pliant
