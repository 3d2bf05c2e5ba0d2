// tools/refine.cpp: inserts points into elements that are too large or too poor.
#include "stages/refine.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::RefineStage stage;
  return pliant::run_filter(stage, argc, argv);
}
