// lib/pliant/fem/navier_stokes/segment_tree.cpp: halves segments by their middles, and asks the nearer half first.
#include "pliant/fem/navier_stokes/segment_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr int leaf_size = 4;

double distance_from(const MeasuringSegment& segment, const Point& p) {
  const Vector along = segment.to - segment.from;
  const double square = squared_length(along);
  const double s = square > 0 ? std::clamp(dot(p - segment.from, along) / square, 0.0, 1.0) : 0;
  return distance(p, segment.from + s * along);
}

}  // namespace

SegmentTree::SegmentTree(std::vector<MeasuringSegment> segments) : segments_(std::move(segments)) {
  assert(std::ranges::all_of(segments_, [](const MeasuringSegment& each) { return each.unit > 0; }));
  if (!segments_.empty()) build(0, static_cast<int>(segments_.size()));
}

void SegmentTree::build(int first, int end) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  Box box, middles;
  double greatest = 0;
  for (int k = first; k < end; ++k) {
    const MeasuringSegment& segment = segments_[index(k)];
    box.extend(segment.from);
    box.extend(segment.to);
    middles.extend(0.5 * (segment.from + segment.to));
    greatest = std::max(greatest, segment.unit);
  }
  nodes_[node] = {box, greatest, first, end, 0};
  if (end - first <= leaf_size) return;
  const bool by_x = middles.high.x - middles.low.x >= middles.high.y - middles.low.y;
  const auto key = [by_x](const MeasuringSegment& s) {
    const double x = s.from.x + s.to.x, y = s.from.y + s.to.y;
    return by_x ? std::tuple(x, y, s.from.x, s.from.y) : std::tuple(y, x, s.from.x, s.from.y);
  };
  const int middle = first + (end - first) / 2;
  std::nth_element(segments_.begin() + first, segments_.begin() + middle, segments_.begin() + end,
                   [&key](const MeasuringSegment& a, const MeasuringSegment& b) { return key(a) < key(b); });
  build(first, middle);
  nodes_[node].right = static_cast<int>(nodes_.size());
  build(middle, end);
}

double SegmentTree::least(const Point& p, double most) const {
  return nodes_.empty() || bound(0, p) >= most ? most : least_below(0, p, most);
}

double SegmentTree::bound(int node, const Point& p) const {
  const Box& box = nodes_[index(node)].box;
  const Point nearest{std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)};
  return distance(p, nearest) / nodes_[index(node)].greatest_unit;
}

double SegmentTree::least_below(int node, const Point& p, double most) const {
  const Node& here = nodes_[index(node)];
  if (here.right == 0) {
    for (int k = here.first; k < here.end; ++k)
      most = std::min(most, distance_from(segments_[index(k)], p) / segments_[index(k)].unit);
    return most;
  }
  std::pair nearer(bound(node + 1, p), node + 1), other(bound(here.right, p), here.right);
  if (other < nearer) std::swap(nearer, other);
  for (const auto& [least_there, child] : {nearer, other})
    if (least_there < most) most = least_below(child, p, most);
  return most;
}

}  // namespace pliant
