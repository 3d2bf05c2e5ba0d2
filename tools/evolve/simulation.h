// tools/evolve/simulation.h: one command of evolve: reads, runs the loop, writes frames and logs.
#pragma once
#include "evolve/evolve_options.h"

namespace pliant {

/// Returns the exit status; throws what run_tool turns into others.
int simulate(const EvolveOptions& options);

}  // namespace pliant
