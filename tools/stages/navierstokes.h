// tools/stages/navierstokes.h: the stage that moves a mesh with an incompressible flow, and solves for the flow.
#pragma once
#include <string>
#include <vector>

#include "options/motion_option.h"
#include "options/problem_option.h"
#include "pliant/fem/navier_stokes/mesh_velocity.h"
#include "pliant/fem/navier_stokes/navier_stokes.h"
#include "stages/stage.h"

namespace pliant {

class NavierStokesStage : public Stage {
 public:
  const char* name() const override { return "navierstokes"; }
  const char* description() const override {
    return "Solve the Navier-Stokes equations on a mesh that moves with the fluid, for a step of time or for a steady "
           "flow.";
  }
  bool advances_time() const override { return !steady_ && steps_ > 0; }
  double time_step() const override { return steps_ * motion_.dt(); }
  const char* own_end() const override { return motion_.until() ? "--until" : nullptr; }
  bool explains() const override { return problem_.wants_explanation(); }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  std::string explanation(Mesh& mesh) const override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  FlowOptions flow_options(const FlowProblem& problem) const;
  PassReport take_steps(const FlowProblem& problem, Mesh& mesh, const FlowOptions& options,
                        const StageContext& context) const;
  AdvectOutcome move(const FlowProblem& problem, Mesh& mesh, const StageContext& context) const;
  void add_errors(const ProblemDocument& document, const Mesh& mesh, PassReport& report) const;

  ProblemOption problem_;
  MotionOption motion_;
  std::string scheme_ = "bdf2", mesh_velocity_ = "harmonic";
  MeshMotion mesh_motion_ = MeshMotion::harmonic;
  std::vector<std::string> errors_;
  FlowOptions options_;
  int steps_ = 1;
  bool steady_ = false, vorticity_ = false;
};

}  // namespace pliant
