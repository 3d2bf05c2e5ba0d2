// lib/pliant/improve/smoothing/worst_first.h: visits elements that are too curved, the worst first (private to
// smooth_curves).
#pragma once
#include <queue>
#include <span>
#include <vector>

#include "pliant/improve/smoothing/smoothing_moves.h"

namespace pliant {

/// The queue of smooth_curves, and what it remembers about each element: how often it was visited, when it last
/// changed, and which visits found nothing to change.
class WorstFirst {
 public:
  /// `options` says what visits may do. The caller may change it between two runs; all references are kept.
  WorstFirst(Mesh& mesh, SmoothingMoves& moves, const SmoothOptions& options)
      : mesh_(mesh), moves_(moves), options_(options) {}

  /// Visits these elements, and those that a change makes worth a visit, until nothing improves.
  void run(std::span<const TriangleId> elements);
  /// Makes all elements worth a visit again: a new option may help where the ones before it did not.
  void forget_failures();

  /// Notes elements that something else than a visit has changed.
  void add_changed(std::span<const TriangleId> elements);
  /// The time now, which add_changed and every visit that changes something advance.
  long now() const { return clock_; }
  bool has_changed_since(TriangleId t, long time) const {
    return static_cast<std::size_t>(t) < changed_.size() && changed_[static_cast<std::size_t>(t)] > time;
  }

  /// The elements that were added or have changed: no other one can be too curved. Ascending after a run.
  std::span<const TriangleId> suspects() const { return suspects_; }
  void add_suspect(TriangleId t) { suspects_.push_back(t); }
  /// Has anything in the mesh changed?
  bool has_changed() const { return has_changed_; }

 private:
  struct Entry {
    double excess;
    TriangleId triangle;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.excess != b.excess ? a.excess < b.excess : a.triangle > b.triangle;
    }
  };
  bool is_worth_a_visit(TriangleId t) const;
  bool change(TriangleId t, double before);
  void visit(TriangleId t, double before);

  Mesh& mesh_;
  SmoothingMoves& moves_;
  const SmoothOptions& options_;
  std::priority_queue<Entry> queue_;
  std::vector<TriangleId> suspects_;
  // By element:
  std::vector<int> visits_;               // in this run
  std::vector<double> last_;              // its excess after the last visit of this run; 0: none
  std::vector<int> searches_, failures_;  // searches made, visits in vain, since failures were forgotten
  std::vector<long> changed_, failed_;    // the times of its last change and of its last visit in vain; 0: never
  long clock_ = 1, visited_ = 0;
  bool has_changed_ = false;
};

}  // namespace pliant
