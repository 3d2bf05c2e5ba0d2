// tools/navierstokes.cpp: moves meshes with incompressible flows, and solves for these.
#include "stages/navierstokes.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::NavierStokesStage stage;
  return pliant::run_filter(stage, argc, argv);
}
