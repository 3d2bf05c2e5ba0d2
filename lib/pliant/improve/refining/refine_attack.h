// lib/pliant/improve/refining/refine_attack.h: which triangles refinement attacks, and in which order.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "pliant/improve/sizing.h"

namespace pliant {

/// Why a triangle is attacked.
struct Attack {
  const char* reason = nullptr;
  double excess = 0;       // how far beyond its bound: worst first
  HalfEdgeId edge = none;  // too curved: the edge to split
  bool is_poor = false;
};

/// An element whose longest edge has this many wanted lengths is too large.
inline constexpr double size_slack = 1.5;

/// By how much an edge's tangent turns from one end to the other.
double edge_turning(const Mesh& mesh, HalfEdgeId h);

/// By chords; of equal ones the first.
HalfEdgeId shortest_edge(const Mesh& mesh, TriangleId t);

/// Too curved before too large before too poor.
Attack attack_on(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

/// A triangle to be attacked.
struct AttackEntry {
  TriangleId triangle;
  std::array<PointId, 3> corners;  // as queued: the slot may have become another triangle
};

/// Worst first, to a power of two; of those the one queued last, which keeps the work in one place and with it the
/// memory that is needed near by.
class AttackQueue {
 public:
  void push(double excess, const AttackEntry& entry) {
    const double place = std::log2(excess);
    const auto bucket = static_cast<std::size_t>(std::clamp(place, 0.0, double(buckets_.size() - 1)));
    buckets_[bucket].push_back(entry);
    top_ = std::max(top_, bucket);
  }
  std::optional<AttackEntry> pop() {
    while (buckets_[top_].empty()) {
      if (top_ == 0) return std::nullopt;
      --top_;
    }
    const AttackEntry entry = buckets_[top_].back();
    buckets_[top_].pop_back();
    return entry;
  }

 private:
  std::array<std::vector<AttackEntry>, 1024> buckets_;
  std::size_t top_ = 0;
};

}  // namespace pliant
