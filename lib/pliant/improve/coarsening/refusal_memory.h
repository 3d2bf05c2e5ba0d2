// lib/pliant/improve/coarsening/refusal_memory.h: which removals were refused, and what that depended on.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/improve/coarsening/removal_chain.h"

namespace pliant {

/// Remembers refused removals, since they would be refused again as long as what decided them has not changed: the
/// stars of some vertices, and which of these are slated.
class RefusalMemory {
 public:
  /// `slots`: of the mesh's points. Nothing is allocated before the first note.
  explicit RefusalMemory(PointId slots) : slots_(index(slots)) {}

  /// Notes that the removal of v was refused at the time `when`. `decided_by` may have a vertex several times.
  void note(PointId v, const RemovalRefusal& refusal, long when, std::span<const PointId> decided_by,
            const std::vector<bool>& slated) {
    if (places_.empty()) {
      places_.assign(slots_, none);
      noted_.assign(slots_, none);
    }
    std::int32_t& place = places_[index(v)];
    if (place == none) {
      place = static_cast<std::int32_t>(entries_.size());
      entries_.emplace_back();
    }
    ++notes_;
    Entry& entry = entries_[index(place)];
    live_ -= entry.count;
    entry = {refusal, when, decided_by_.size(), 0};
    for (const PointId w : decided_by) {
      if (noted_[index(w)] == notes_) continue;
      noted_[index(w)] = notes_;
      decided_by_.push_back(2 * w + (slated[index(w)] ? 1 : 0));
    }
    entry.count = decided_by_.size() - entry.first;
    live_ += entry.count;
    if (decided_by_.size() > 2 * live_ + 1000) compact();
  }

  /// True if the removal of v was refused and would be refused again. `changed`: the time of the last change of each
  /// vertex's star.
  bool is_refused(PointId v, const std::vector<long>& changed, const std::vector<bool>& slated) const {
    if (places_.empty() || places_[index(v)] == none) return false;
    const Entry& entry = entries_[index(places_[index(v)])];
    const auto by = std::span(decided_by_).subspan(entry.first, entry.count);
    return std::all_of(by.begin(), by.end(), [&](PointId noted) {
      const PointId w = noted / 2;
      return changed[index(w)] <= entry.when && slated[index(w)] == (noted % 2 != 0);
    });
  }

  /// Requires    a note for v
  const RemovalRefusal& refusal(PointId v) const { return entries_[index(places_[index(v)])].refusal; }

 private:
  struct Entry {
    RemovalRefusal refusal;
    long when = 0;
    std::size_t first = 0, count = 0;  // in decided_by_
  };

  /// Drops what notes have replaced.
  void compact() {
    std::vector<PointId> kept;
    kept.reserve(live_);
    for (Entry& entry : entries_) {
      const auto by = std::span(decided_by_).subspan(entry.first, entry.count);
      entry.first = kept.size();
      kept.insert(kept.end(), by.begin(), by.end());
    }
    decided_by_ = std::move(kept);
  }

  std::size_t slots_, live_ = 0;
  std::int32_t notes_ = none;
  std::vector<std::int32_t> places_;  // by vertex: its entry; none: it has none
  std::vector<std::int32_t> noted_;   // by vertex: the last note that lists it
  std::vector<Entry> entries_;
  std::vector<PointId> decided_by_;  // for each vertex of an entry twice its number, plus one if it was slated
};

}  // namespace pliant
