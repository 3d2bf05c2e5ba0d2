// lib/pliant/generate/delaunay.h: an incremental constrained Delaunay triangulation (private to generate).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// The Delaunay triangulation of points, into which segments are then forced.
///
/// Beyond every edge of the convex hull lies a ghost triangle, which joins the edge to the vertex `infinite`; so every
/// edge has two triangles. Half-edge 3t + e runs from corner e of triangle t to corner (e + 1) % 3, counter-clockwise.
class Delaunay {
 public:
  static constexpr int infinite = -1;

  /// Throws      std::invalid_argument where two points are the same
  /// Complexity  O(n log n) expected: points are inserted in rounds, each along a Hilbert curve
  explicit Delaunay(std::span<const Point> points);

  /// Makes a-b an edge that no flip removes; the other edges stay locally Delaunay, or constrained.
  /// Throws      std::invalid_argument where it crosses another segment or passes through a point
  /// Complexity  O(edges crossed), usually
  void insert_segment(int a, int b);

  /// All triangles but the ghosts.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  static constexpr int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static constexpr int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  const Point& point(int v) const { return points_[static_cast<std::size_t>(v)]; }
  int origin(int h) const { return origin_[static_cast<std::size_t>(h)]; }
  int target(int h) const { return origin(next(h)); }
  int apex(int h) const { return origin(previous(h)); }
  int twin(int h) const { return twin_[static_cast<std::size_t>(h)]; }
  bool is_constrained(int h) const { return constrained_[static_cast<std::size_t>(h)] != 0; }

  std::vector<int> insertion_order() const;
  bool make_first_triangle(std::vector<int>& order);
  int add_triangle(int a, int b, int c);
  void set_triangle(int t, int a, int b, int c);
  void link(int h, int g);
  int ghost_edge(int t) const;
  int locate(int v) const;
  bool conflicts(int t, const Point& p) const;
  void insert(int v);
  [[noreturn]] void refuse(int a, int b, const char* how, int c, int d) const;

  int find_edge(int a, int b) const;
  int first_crossed(int a, int b) const;
  std::vector<std::array<int, 2>> crossed_edges(int a, int b) const;
  bool is_flippable(int h) const;
  void flip(int h);
  void make_delaunay(std::vector<std::array<int, 2>> edges);
  void constrain(int h);

  std::span<const Point> points_;
  std::vector<int> origin_, twin_;
  std::vector<char> constrained_;
  std::vector<int> leaving_;  // a half-edge from each point
  int recent_ = 0;            // a finite triangle near the last insertion
  // Scratch memory of insert().
  struct RimEdge {
    int from, to, beyond;
  };
  std::vector<RimEdge> rim_;
  std::vector<int> cavity_, fan_;
  std::vector<int> mark_;
  int marker_ = 0;
};

}  // namespace pliant
