// lib/pliant/fem/navier_stokes/segment_tree.h: distances from many places to many line segments.
#pragma once
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// A line segment, and the length in which distances from it are measured.
struct MeasuringSegment {
  Point from, to;
  double unit = 1;  ///< positive
};

/// A binary tree of boxes around segments. The same question always has the same answer.
class SegmentTree {
 public:
  /// Complexity  O(n log n)
  explicit SegmentTree(std::vector<MeasuringSegment> segments);

  /// The least of distance / unit over the segments, or `most` where none has less.
  /// Complexity  expected O(log n); O(1) far from all segments
  double least(const Point& p, double most) const;

 private:
  struct Node {
    Box box;
    double greatest_unit = 0;
    int first = 0, end = 0;  // the segments below
    int right = 0;           // the second child; the first one follows its parent; 0: the node has none
  };
  void build(int first, int end);
  double bound(int node, const Point& p) const;
  double least_below(int node, const Point& p, double most) const;

  std::vector<MeasuringSegment> segments_;
  std::vector<Node> nodes_;
};

}  // namespace pliant
