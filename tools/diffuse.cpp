// tools/diffuse.cpp: solves convection-diffusion equations on meshes, at rest or in motion.
#include "stages/diffuse.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::DiffuseStage stage;
  return pliant::run_filter(stage, argc, argv);
}
