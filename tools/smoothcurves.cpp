// tools/smoothcurves.cpp: makes elements less curved, and untangles those that are not valid.
#include "stages/smoothcurves.h"

#include "run/run_filter.h"
#include "stages/ceres_smoother.h"

int main(int argc, char** argv) {
  pliant::SmoothCurvesStage stage(pliant::ceres_smoother());
  return pliant::run_filter(stage, argc, argv);
}
