// tools/stages/advect.h: the stage that carries meshes along in a flow by one step.
#pragma once
#include <optional>
#include <string>

#include "options/field_option.h"
#include "options/velocity_option.h"
#include "pliant/flow/advect.h"
#include "stages/stage.h"

namespace pliant {

class AdvectStage : public Stage {
 public:
  const char* name() const override { return "advect"; }
  const char* description() const override {
    return "Carry a mesh along in a flow by one step, certified: no element is inverted on the way.";
  }
  bool advances_time() const override { return true; }
  double time_step() const override { return options_.dt; }
  int velocity_field(const Mesh& mesh) const override { return flow_.velocity() ? none : flow_.find_field(mesh); }
  bool keeps_refused_mesh() const override { return fields_.empty(); }
  const char* own_end() const override { return until_ ? "--until" : nullptr; }
  bool may_leave_tangled() const override { return options_.policy == StepPolicy::force; }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  void check_method(const CLI::App& app);

  VelocityOption flow_;
  FieldOption fields_;
  AdvectOptions options_;
  std::optional<double> until_;
  std::string dt_text_, until_text_, method_ = "rk4", tolerance_text_;
  std::string min_gap_text_, gap_ = "stop";
  double min_gap_ = 0;
  bool limit_ = false, force_ = false;
};

}  // namespace pliant
