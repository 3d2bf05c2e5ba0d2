// tools/evolve/interrupt.h: Ctrl-C and SIGTERM end a simulation at the end of a step.
#pragma once

namespace pliant {

/// From now on the first SIGINT or SIGTERM is only noted, unless it was ignored before (nohup); a second SIGINT ends
/// the process at once.
void catch_interrupts();
/// The signal that has come; 0: none.
int interrupted_by();

}  // namespace pliant
