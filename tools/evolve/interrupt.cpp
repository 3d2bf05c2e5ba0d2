// tools/evolve/interrupt.cpp: Ctrl-C and SIGTERM end a simulation at the end of a step.
#include "evolve/interrupt.h"

#include <csignal>

#include "run/output_file.h"

namespace pliant {
namespace {

volatile std::sig_atomic_t signal_seen = 0;

void note(int signal) {
  if (signal_seen != 0) {
    remove_unfinished_files();
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
  signal_seen = signal;
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;  // a write that was begun goes on
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

int interrupted_by() { return signal_seen; }

}  // namespace pliant
