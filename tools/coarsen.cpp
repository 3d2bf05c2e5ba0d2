// tools/coarsen.cpp: removes vertices that neither size nor geometry needs.
#include "stages/coarsen.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::CoarsenStage stage;
  return pliant::run_filter(stage, argc, argv);
}
