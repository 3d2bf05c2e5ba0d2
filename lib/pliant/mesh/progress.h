// lib/pliant/mesh/progress.h: how far a long pass has come, for another thread to show.
#pragma once
#include <atomic>

namespace pliant {

/// What a pass counts while it works. The pass only stores, in relaxed order, which costs the same as ordinary stores;
/// the thread that shows the progress may read at any time.
struct Progress {
  std::atomic<const char*> stage{""};  ///< what the pass is doing, in static storage: "generate", "refine"
  std::atomic<const char*> unit{""};   ///< what is counted: "rounds", "points"
  std::atomic<long> done{0};           ///< the count so far in this stage
  std::atomic<double> expected{0};     ///< roughly the count at the end of this stage; 0: not known

  void start(const char* new_stage, const char* new_unit = "", double new_expected = 0) {
    done.store(0, std::memory_order_relaxed);
    expected.store(new_expected, std::memory_order_relaxed);
    unit.store(new_unit, std::memory_order_relaxed);
    stage.store(new_stage, std::memory_order_relaxed);
  }
  void count(long so_far) { done.store(so_far, std::memory_order_relaxed); }
};

}  // namespace pliant
