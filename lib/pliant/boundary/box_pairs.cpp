// lib/pliant/boundary/box_pairs.cpp: which of many boxes overlap?
#include "pliant/boundary/box_pairs.h"

#include <algorithm>
#include <numeric>

namespace pliant {
namespace {

/// A balanced tree over the boxes, each node a range of `order`, split at the median of the wider direction.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
  }

  void visit_pairs(const PairVisitor& visit) const {
    if (!nodes_.empty()) (void)within(0, visit);
  }

 private:
  static constexpr int leaf_size = 6;
  struct Node {
    Box box;
    int first, last;
    int left = -1, right = -1;
  };
  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  const Box& box_at(int i) const { return boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])]; }

  int build(int first, int last) {
    const int here = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, first, last});
    Box all, centres;
    const auto centre = [](const Box& b) { return Point{b.low.x / 2 + b.high.x / 2, b.low.y / 2 + b.high.y / 2}; };
    for (int i = first; i < last; ++i) {
      all.extend(box_at(i).low);
      all.extend(box_at(i).high);
      centres.extend(centre(box_at(i)));
    }
    nodes_[static_cast<std::size_t>(here)].box = all;
    if (last - first <= leaf_size) return here;
    const bool by_x = centres.high.x - centres.low.x > centres.high.y - centres.low.y;
    const int middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int i, int j) {
      const Point a = centre(boxes_[static_cast<std::size_t>(i)]), b = centre(boxes_[static_cast<std::size_t>(j)]);
      return by_x ? a.x < b.x : a.y < b.y;
    });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[static_cast<std::size_t>(here)].left = left;
    nodes_[static_cast<std::size_t>(here)].right = right;
    return here;
  }

  // Each of the following is false once the visitor wants no more.

  bool show(int i, int j, const PairVisitor& visit) const {
    if (!box_at(i).overlaps(box_at(j))) return true;
    const int a = order_[static_cast<std::size_t>(i)], b = order_[static_cast<std::size_t>(j)];
    return visit(std::min(a, b), std::max(a, b));
  }

  bool within(int n, const PairVisitor& visit) const {
    const Node& a = node(n);
    if (a.left >= 0) return within(a.left, visit) && within(a.right, visit) && between(a.left, a.right, visit);
    for (int i = a.first; i < a.last; ++i)
      for (int j = i + 1; j < a.last; ++j)
        if (!show(i, j, visit)) return false;
    return true;
  }

  bool between(int m, int n, const PairVisitor& visit) const {
    const Node &a = node(m), &b = node(n);
    if (!a.box.overlaps(b.box)) return true;
    if (a.left >= 0 && (b.left < 0 || a.last - a.first >= b.last - b.first))
      return between(a.left, n, visit) && between(a.right, n, visit);
    if (b.left >= 0) return between(m, b.left, visit) && between(m, b.right, visit);
    for (int i = a.first; i < a.last; ++i)
      for (int j = b.first; j < b.last; ++j)
        if (!show(i, j, visit)) return false;
    return true;
  }

  std::span<const Box> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace

void visit_overlapping_pairs(std::span<const Box> boxes, const PairVisitor& visit) {
  BoxTree(boxes).visit_pairs(visit);
}

std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes) {
  std::vector<std::array<int, 2>> pairs;
  visit_overlapping_pairs(boxes, [&pairs](int i, int j) {
    pairs.push_back({i, j});
    return true;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pliant
