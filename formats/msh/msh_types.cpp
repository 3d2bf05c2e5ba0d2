// formats/msh/msh_types.cpp: Gmsh's element types, the order of their nodes, and tags.
#include <algorithm>
#include <cassert>

#include "formats/msh/msh_file.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

using Family = MshElementType::Family;

/// Notes the orders of the types that are read: all that a mesh may have as its degree. Type 24, of order 5, has its 15
/// nodes on the edges only, so it is not among them.
void set_orders(std::array<MshElementType, msh_type_count>& types) {
  for (const auto& [number, order] :
       {std::pair(1, 1),  std::pair(8, 2),  std::pair(26, 3), std::pair(27, 4), std::pair(28, 5),
        std::pair(62, 6), std::pair(63, 7), std::pair(64, 8), std::pair(65, 9), std::pair(66, 10),
        std::pair(2, 1),  std::pair(9, 2),  std::pair(21, 3), std::pair(23, 4), std::pair(25, 5),
        std::pair(42, 6), std::pair(43, 7), std::pair(44, 8), std::pair(45, 9), std::pair(46, 10)})
    types[static_cast<std::size_t>(number)].order = order;
}

/// The table of types by their numbers; type 10, the quadrangle of 9 nodes, is {quadrangle, 9}.
std::array<MshElementType, msh_type_count> make_types() {
  std::array<MshElementType, msh_type_count> types;
  const auto set = [&types](Family family, int first, std::initializer_list<int> node_counts) {
    for (const int nodes : node_counts) types[static_cast<std::size_t>(first++)] = {family, nodes, 0};
  };
  set(Family::line, 1, {2});
  set(Family::triangle, 2, {3});
  set(Family::quadrangle, 3, {4});
  set(Family::tetrahedron, 4, {4});
  set(Family::hexahedron, 5, {8});
  set(Family::prism, 6, {6});
  set(Family::pyramid, 7, {5});
  set(Family::line, 8, {3});
  set(Family::triangle, 9, {6});
  set(Family::quadrangle, 10, {9});
  set(Family::tetrahedron, 11, {10});
  set(Family::hexahedron, 12, {27});
  set(Family::prism, 13, {18});
  set(Family::pyramid, 14, {14});
  set(Family::point, 15, {1});
  set(Family::quadrangle, 16, {8});
  set(Family::hexahedron, 17, {20});
  set(Family::prism, 18, {15});
  set(Family::pyramid, 19, {13});
  set(Family::triangle, 20, {9, 10, 12, 15, 15, 21});
  set(Family::line, 26, {4, 5, 6});
  set(Family::tetrahedron, 29, {20, 35, 56, 22, 28});
  set(Family::other, 34, {0, 0});  // polygon, polyhedron
  set(Family::quadrangle, 36, {16, 25, 36, 12, 16, 20});
  set(Family::triangle, 42, {28, 36, 45, 55, 66});
  set(Family::quadrangle, 47, {49, 64, 81, 100, 121});
  set(Family::triangle, 52, {18, 21, 24, 27, 30});
  set(Family::quadrangle, 57, {24, 28, 32, 36, 40});
  set(Family::line, 62, {7, 8, 9, 10, 11});
  set(Family::other, 67, {0, 0, 0, 0});  // with borders, children
  set(Family::tetrahedron, 71, {84, 120, 165, 220, 286});
  set(Family::tetrahedron, 79, {34, 40, 46, 52, 58});
  set(Family::line, 84, {1});
  set(Family::triangle, 85, {1});
  set(Family::quadrangle, 86, {1});
  set(Family::tetrahedron, 87, {1});
  set(Family::hexahedron, 88, {1});
  set(Family::prism, 89, {1, 40, 75});
  set(Family::hexahedron, 92, {64, 125, 216, 343, 512, 729, 1000, 32, 44, 56, 68, 80, 92, 104});
  set(Family::prism, 106, {126, 196, 288, 405, 550, 24, 33, 42, 51, 60, 69, 78});
  set(Family::pyramid, 118, {30, 55, 91, 140, 204, 285, 385, 21, 29, 37, 45, 53, 61, 69, 1});
  set(Family::other, 133, {0, 0, 0, 0});  // subelements
  set(Family::tetrahedron, 137, {16});
  set(Family::triangle, 138, {4});
  set(Family::tetrahedron, 139, {5});
  set(Family::other, 140, {4});
  set_orders(types);
  return types;
}

}  // namespace

const MshElementType& msh_element_type(std::int64_t type) {
  static const std::array<MshElementType, msh_type_count> types = make_types();
  return types[type > 0 && type < msh_type_count ? static_cast<std::size_t>(type) : 0];
}

std::string describe_left_out(std::int64_t type, std::uint64_t count) {
  static constexpr std::array<const char*, 10> names = {"element",     "point",      "line",  "triangle", "quadrangle",
                                                        "tetrahedron", "hexahedron", "prism", "pyramid",  "element"};
  const MshElementType& of = msh_element_type(type);
  std::string text = std::to_string(count) + " " + names[of.family] + (count == 1 ? "" : "s");
  if (of.family == Family::triangle && of.nodes > 1)
    text += of.nodes == 4 ? " with a bubble" : " without all their inner nodes";
  else if (of.nodes > 1)
    text += " of " + std::to_string(of.nodes) + " nodes";
  return text + " (type " + std::to_string(type) + ")";
}

std::vector<int> msh_net_order(int order) { return nested_net_order(order); }

std::uint64_t TagRuns::tag_of(std::size_t index) const {
  const auto behind =
      std::upper_bound(runs_.begin(), runs_.end(), index, [](std::size_t i, const Run& run) { return i < run.first; });
  const Run& run = *(behind - 1);
  return run.tag + (index - run.first);
}

const std::uint64_t* MshNodeTags::prepare() {
  const std::vector<TagRuns::Run>& runs = tags_.runs();
  is_one_run_ = runs.size() <= 1;
  if (runs.empty()) return nullptr;
  lowest_ = runs.front().tag;
  if (is_one_run_) return nullptr;
  ranges_.clear();
  table_.clear();
  ranges_.reserve(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::size_t end = k + 1 < runs.size() ? runs[k + 1].first : tags_.size();
    ranges_.push_back({runs[k].tag, runs[k].tag + (end - runs[k].first - 1), runs[k].first});
  }
  std::sort(ranges_.begin(), ranges_.end(), [](const Range& a, const Range& b) { return a.tag < b.tag; });
  for (std::size_t k = 1; k < ranges_.size(); ++k)
    if (ranges_[k].tag <= ranges_[k - 1].last) {
      twice_ = ranges_[k].tag;
      return &twice_;
    }
  lowest_ = ranges_.front().tag;
  if ((ranges_.back().last - lowest_) / 4 >= tags_.size()) return nullptr;
  table_.assign(static_cast<std::size_t>(ranges_.back().last - lowest_) + 1, none);
  for (const Range& range : ranges_)
    for (std::uint64_t tag = range.tag; tag <= range.last; ++tag)
      table_[static_cast<std::size_t>(tag - lowest_)] = static_cast<PointId>(range.first + (tag - range.tag));
  return nullptr;
}

std::uint64_t MshNodeTags::highest() const {
  if (tags_.size() == 0) return 0;
  return is_one_run_ ? lowest_ + tags_.size() - 1 : ranges_.back().last;
}

PointId MshNodeTags::search(std::uint64_t tag) const {
  const auto behind = std::upper_bound(ranges_.begin(), ranges_.end(), tag,
                                       [](std::uint64_t wanted, const Range& range) { return wanted < range.tag; });
  if (behind == ranges_.begin()) return none;
  const Range& range = *(behind - 1);
  return tag <= range.last ? static_cast<PointId>(range.first + (tag - range.tag)) : none;
}

}  // namespace pliant
