// lib/pliant/mesh/triangle_tree.cpp: the tree of boxes packed, from the elements up.
#include "pliant/mesh/triangle_tree.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "pliant/mesh/hilbert_order.h"

namespace pliant {

void TriangleTree::build(const Mesh& mesh, double margin) {
  clear();
  std::vector<Box> boxes(static_cast<std::size_t>(mesh.triangle_slots()));
  Box all;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    Box& box = boxes[static_cast<std::size_t>(t)];
    for (const PointId q : mesh.net(t)) box.extend(mesh.point(q));
    all.extend(box.low);
    all.extend(box.high);
  }
  // Elements far smaller than 2^-32 of the mesh may share a place on the curve; they then keep the order of their
  // numbers.
  const HilbertOrder order(all, 32);
  std::vector<std::pair<std::uint64_t, TriangleId>> places;
  places.reserve(static_cast<std::size_t>(mesh.triangle_count()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    const Box& box = boxes[static_cast<std::size_t>(t)];
    places.emplace_back(order(0.5 * box.low + 0.5 * box.high), t);
  }
  std::sort(places.begin(), places.end());

  boxes_.reserve(places.size() + places.size() / 3 + 2 * max_levels);
  for (const auto& [place, t] : places) {
    order_.push_back(t);
    const Box& box = boxes[static_cast<std::size_t>(t)];
    boxes_.push_back({box.low - Point{margin, margin}, box.high + Point{margin, margin}});
  }
  levels_ = {0, boxes_.size()};
  while (levels_.back() - levels_[levels_.size() - 2] > 1) {
    const std::size_t first = levels_[levels_.size() - 2], last = levels_.back();
    for (std::size_t k = first; k < last; k += fanout) {
      Box box;
      for (std::size_t m = k; m < std::min(k + fanout, last); ++m) {
        const Box& below = boxes_[m];
        box.extend(below.low);
        box.extend(below.high);
      }
      boxes_.push_back(box);
    }
    levels_.push_back(boxes_.size());
  }
}

}  // namespace pliant
