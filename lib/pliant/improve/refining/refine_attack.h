// lib/pliant/improve/refining/refine_attack.h: which triangles refinement attacks, and in which order.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "pliant/improve/sizing.h"

namespace pliant {

/// Why refinement attacks a triangle.
struct Attack {
  const char* reason = nullptr;  ///< null: it does not
  double excess = 0;             ///< the measure that exceeds its bound, in bounds; the greatest is attacked first
  HalfEdgeId edge = none;        ///< of a triangle that is too curved: the edge to split
  bool is_poor = false;          ///< the reason is its shape
};

/// An element whose longest edge has this many wanted lengths is too large.
inline constexpr double size_slack = 1.5;

/// The angle, in radians, by which an edge's control polygon turns from one end to the other.
double edge_turning(const Mesh& mesh, HalfEdgeId h);

/// The edge of a triangle with the shortest chord; among equal ones the first.
HalfEdgeId shortest_edge(const Mesh& mesh, TriangleId t);

/// Checks a triangle against the goals: whether it is too curved first, then too large, then too poor.
Attack attack_on(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

/// A triangle that waits to be attacked.
struct AttackEntry {
  TriangleId triangle;
  std::array<PointId, 3> corners;  ///< when it was queued; with others, the slot has become another triangle
};

/// Gives out the triangle with the greatest excess, up to a factor of two. Among those it is the one that was queued
/// last, so that the work stays in one place of the mesh, and of the memory.
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
