// tools/measure.cpp: runs the measure stage over a series of meshes.
#include "stages/measure.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::MeasureStage stage;
  return pliant::run_filter(stage, argc, argv);
}
