// tools/stages/diffuse.h: the stage that solves a convection-diffusion equation, for steps of time or for good.
#pragma once
#include <string>
#include <vector>

#include "options/motion_option.h"
#include "options/problem_option.h"
#include "pliant/fem/diffusion/diffusion.h"
#include "stages/stage.h"

namespace pliant {

class DiffuseStage : public Stage {
 public:
  const char* name() const override { return "diffuse"; }
  const char* description() const override {
    return "Solve a convection-diffusion equation on a mesh, which rests or moves, for a step of time or for its "
           "steady "
           "state.";
  }
  bool advances_time() const override { return !steady_ && steps_ > 0; }
  double time_step() const override { return steps_ * motion_.dt(); }
  int velocity_field(const Mesh& mesh) const override { return motion_.velocity_field(mesh); }
  const char* own_end() const override { return motion_.until() ? "--until" : nullptr; }
  bool explains() const override { return problem_.wants_explanation(); }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  std::string explanation(Mesh& mesh) const override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  PassReport take_steps(Diffusion& diffusion, Mesh& mesh, const StageContext& context) const;
  void add_errors(const ProblemDocument& document, const DiffusionProblem& problem, const Mesh& mesh,
                  PassReport& report) const;

  ProblemOption problem_;
  MotionOption motion_;
  std::string scheme_ = "sdirk2", form_ = "conservative";
  std::vector<std::string> errors_;
  DiffusionOptions options_;
  int steps_ = 1;
  bool steady_ = false;
};

}  // namespace pliant
