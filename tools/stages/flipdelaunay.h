// tools/stages/flipdelaunay.h: the stage that flips edges until the logical mesh is Delaunay.
#pragma once
#include "pliant/improve/enforce_delaunay.h"
#include "stages/stage.h"

namespace pliant {

class FlipDelaunayStage : public Stage {
 public:
  const char* name() const override { return "flipdelaunay"; }
  const char* description() const override { return "Flip edges until the logical mesh is Delaunay."; }
  void add_options(CLI::App& app) override;
  void check(const CLI::App&) override {}
  PassReport run(Mesh& mesh, const StageContext&) const override { return enforce_delaunay(mesh, options_); }

 private:
  DelaunayOptions options_;
};

}  // namespace pliant
