// tools/flipdelaunay.cpp: flips edges until the logical mesh is Delaunay.
#include "stages/flipdelaunay.h"

#include "run/run_filter.h"

int main(int argc, char** argv) {
  pliant::FlipDelaunayStage stage;
  return pliant::run_filter(stage, argc, argv);
}
