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

  void collect(std::vector<std::array<int, 2>>& pairs) const {
    if (!nodes_.empty()) within(0, pairs);
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

  void report(int i, int j, std::vector<std::array<int, 2>>& pairs) const {
    if (!box_at(i).overlaps(box_at(j))) return;
    const int a = order_[static_cast<std::size_t>(i)], b = order_[static_cast<std::size_t>(j)];
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }

  void within(int n, std::vector<std::array<int, 2>>& pairs) const {
    const Node& a = node(n);
    if (a.left < 0) {
      for (int i = a.first; i < a.last; ++i)
        for (int j = i + 1; j < a.last; ++j) report(i, j, pairs);
      return;
    }
    within(a.left, pairs);
    within(a.right, pairs);
    between(a.left, a.right, pairs);
  }

  void between(int m, int n, std::vector<std::array<int, 2>>& pairs) const {
    const Node &a = node(m), &b = node(n);
    if (!a.box.overlaps(b.box)) return;
    if (a.left < 0 && b.left < 0) {
      for (int i = a.first; i < a.last; ++i)
        for (int j = b.first; j < b.last; ++j) report(i, j, pairs);
    } else if (b.left < 0 || (a.left >= 0 && a.last - a.first >= b.last - b.first)) {
      between(a.left, n, pairs);
      between(a.right, n, pairs);
    } else {
      between(m, b.left, pairs);
      between(m, b.right, pairs);
    }
  }

  std::span<const Box> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes) {
  std::vector<std::array<int, 2>> pairs;
  BoxTree(boxes).collect(pairs);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pliant
