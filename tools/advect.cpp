// tools/advect.cpp: carries meshes along in a flow by one step.
#include "stages/advect.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::AdvectStage stage;
  return pliant::run_filter(stage, argc, argv);
}
