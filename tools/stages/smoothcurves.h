// tools/stages/smoothcurves.h: the stage that makes elements less curved, and untangles those that are not valid.
#pragma once
#include <string>

#include "pliant/improve/smooth_curves.h"
#include "stages/global_smoothing.h"
#include "stages/stage.h"

namespace pliant {

class SmoothCurvesStage : public Stage {
 public:
  /// With the global smoother of the program, or none.
  explicit SmoothCurvesStage(const GlobalSmoother* global = nullptr) : global_(global) {}
  const char* name() const override { return "smoothcurves"; }
  const char* description() const override {
    return "Smooth the edges of elements that are too curved, and untangle those that are not valid.";
  }
  bool accepts_tangled() const override { return true; }
  bool may_leave_tangled() const override { return keep_going_; }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  void add_bounds(CLI::App& app);
  void add_moves(CLI::App& app);

  GlobalSmoothing global_;
  SmoothOptions options_;
  bool keep_going_ = false;
  std::string distortion_ = "1.1", peak_ = "2", shape_ = "0.5", turning_ = "90", jacobian_ = "0.3";
  std::string measure_ = "element";
};

}  // namespace pliant
