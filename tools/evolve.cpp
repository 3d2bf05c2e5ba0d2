// tools/evolve.cpp: runs a step, the text of a pipe of tools, again and again in one process.
#include <CLI/CLI.hpp>

#include "evolve/evolve_options.h"
#include "evolve/simulation.h"
#include "run/run_tool.h"

int main(int argc, char** argv) {
  CLI::App app{"Run a whole simulation: a step, written as the pipe of tools that it equals, again and again.",
               "evolve"};
  pliant::EvolveCommand command;
  command.add(app);
  return pliant::run_tool(app, argc, argv, command.tool_options(), [&] { return pliant::simulate(command.read(app)); });
}
