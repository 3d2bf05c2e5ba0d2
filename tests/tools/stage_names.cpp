// tests/tools/stage_names.cpp: writes the names of all stages, one a line, for the shell cases.
#include <cstdio>

#include "stages/table.h"

int main() {
  for (const std::string& name : pliant::stage_names()) std::printf("%s\n", name.c_str());
  return 0;
}
