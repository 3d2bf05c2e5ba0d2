// tools/stages/advect.h: the stage that carries meshes along in a flow by one step.
#pragma once
#include "options/field_option.h"
#include "options/motion_option.h"
#include "stages/stage.h"

namespace pliant {

class AdvectStage : public Stage {
 public:
  const char* name() const override { return "advect"; }
  const char* description() const override {
    return "Carry a mesh along in a flow by one step, certified: no element is inverted on the way.";
  }
  bool advances_time() const override { return true; }
  double time_step() const override { return motion_.dt(); }
  int velocity_field(const Mesh& mesh) const override { return motion_.velocity_field(mesh); }
  bool keeps_refused_mesh() const override { return fields_.empty(); }
  const char* own_end() const override { return motion_.until() ? "--until" : nullptr; }
  bool may_leave_tangled() const override { return motion_.forces(); }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  MotionOption motion_;
  FieldOption fields_;
};

}  // namespace pliant
