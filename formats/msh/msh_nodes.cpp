// formats/msh/msh_nodes.cpp: the section $Nodes of MSH 2.2 and 4.1.
#include <algorithm>
#include <cmath>

#include "formats/msh/msh_file.h"

namespace pliant {
namespace {

constexpr std::uint64_t largest_tag = std::uint64_t{1} << 62;

/// Takes the nodes of a file one by one.
class NodeSink {
 public:
  NodeSink(const MshCursor& in, MshFile& file, std::uint64_t count)
      : in_(in), file_(file), before_(file.nodes.size()), wanted_(count) {
    // No test reaches this line: its file would have tens of gigabytes.
    if (count > static_cast<std::uint64_t>(std::numeric_limits<PointId>::max()) - before_)
      in.fail(std::to_string(before_ + count) + " nodes are more than can be numbered");
    file.nodes.reserve(before_ + static_cast<std::size_t>(count));
  }

  void tag(std::uint64_t tag, const char* where) {
    if (tag > largest_tag) in_.fail_at(where, "expected a node tag, found " + std::to_string(tag));
    file_.tags.add(tag);
  }
  void place(double x, double y, double z, const char* where) {
    // The comparison is false, too, where a coordinate is not a number.
    if (!(std::fabs(x) <= msh_largest && std::fabs(y) <= msh_largest && std::fabs(z) <= msh_largest))
      in_.fail_at(where, "node " + std::to_string(file_.tags.tag_of(static_cast<PointId>(file_.nodes.size()))) +
                             ": expected three finite coordinates up to 1e300");
    if (file_.nodes.empty()) file_.plane = z;
    file_.nodes.push_back({x, y});
    if (z != file_.plane || !file_.z.empty()) keep_z(z);
  }
  /// Fails unless there is room for `count` more nodes.
  void block(std::uint64_t count) {
    if (count > wanted_ - taken())
      in_.fail("the section announces " + std::to_string(wanted_) +
               " nodes, but its blocks hold more: " + std::to_string(taken()) + " and then " + std::to_string(count));
  }
  void finish() {
    if (taken() != wanted_)
      in_.fail("the section announces " + std::to_string(wanted_) + " nodes, but its blocks hold " +
               std::to_string(taken()));
    if (const std::uint64_t* twice = file_.tags.prepare())
      in_.fail("the section $Nodes, which ends here, has two nodes of tag " + std::to_string(*twice) +
               (before_ > 0 ? ", itself or with an earlier section" : ""));
  }

 private:
  /// How many nodes this section has so far.
  std::uint64_t taken() const { return file_.nodes.size() - before_; }
  void keep_z(double z) {
    if (file_.z.empty()) {
      file_.z.reserve(before_ + static_cast<std::size_t>(wanted_));
      file_.z.assign(file_.nodes.size() - 1, file_.plane);
    }
    file_.z.push_back(z);
  }
  const MshCursor& in_;
  MshFile& file_;
  std::size_t before_;  ///< nodes of earlier sections
  std::uint64_t wanted_;
};

template <bool swap>
void place_binary(NodeSink& nodes, const char* at, std::size_t count, std::size_t stride) {
  for (std::size_t k = 0; k < count; ++k, at += stride)
    nodes.place(load<double, swap>(at), load<double, swap>(at + 8), load<double, swap>(at + 16), at);
}

template <bool swap>
void read_block_4(MshCursor& in, NodeSink& nodes, std::size_t count, std::size_t parameters) {
  const std::size_t stride = 8 * (3 + parameters);
  const char* tags = in.take(count, 8 + stride, "nodes");
  for (std::size_t k = 0; k < count; ++k) nodes.tag(load<std::uint64_t, swap>(tags + 8 * k), tags + 8 * k);
  place_binary<swap>(nodes, tags + 8 * count, count, stride);
}

void read_text_place(MshCursor& in, NodeSink& nodes) {
  in.skip_space();
  const char* where = in.at();
  const double x = in.text_number("a coordinate"), y = in.text_number("a coordinate");
  nodes.place(x, y, in.text_number("a coordinate"), where);
}

template <bool swap>
void read_binary_2(MshCursor& in, NodeSink& nodes, std::size_t count) {
  constexpr std::size_t each = 4 + 3 * 8;
  const char* at = in.take(count, each, "nodes");
  for (std::size_t k = 0; k < count; ++k, at += each) {
    const auto tag = load<std::int32_t, swap>(at);
    if (tag < 0) in.fail_at(at, "expected a node number, found " + std::to_string(tag));
    nodes.tag(static_cast<std::uint64_t>(tag), at);
    nodes.place(load<double, swap>(at + 4), load<double, swap>(at + 12), load<double, swap>(at + 20), at);
  }
}

/// Reads nodes of version 4.0, each with its tag (4 bytes) before its coordinates.
void read_block_4_0(MshCursor& in, NodeSink& nodes, std::size_t count, std::size_t parameters) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t tag = in.int32("a node tag");
    if (tag < 0) in.fail("expected a node tag, found " + std::to_string(tag));
    nodes.tag(static_cast<std::uint64_t>(tag), in.at());
    const char* where = in.at();
    const double x = in.number("a coordinate"), y = in.number("a coordinate");
    nodes.place(x, y, in.number("a coordinate"), where);
    for (std::size_t p = 0; p < parameters; ++p) in.number("a parameter");
  }
}

/// Reads nodes of version 2 with Mesh.SaveParametric, where the entity of each node and its parameters there follow its
/// coordinates.
void read_parametric(MshCursor& in, NodeSink& nodes, std::uint64_t count) {
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::int32_t tag = in.int32("a node number");
    if (tag < 0) in.fail("expected a node number, found " + std::to_string(tag));
    nodes.tag(static_cast<std::uint64_t>(tag), in.at());
    const char* where = in.at();
    const double x = in.number("a coordinate"), y = in.number("a coordinate");
    nodes.place(x, y, in.number("a coordinate"), where);
    const std::int32_t dimension = in.int32("the dimension of a node's entity");
    if (dimension < 0 || dimension > 3)
      in.fail("expected the dimension of a node's entity, 0 to 3, found " + std::to_string(dimension));
    in.int32("the tag of a node's entity");
    for (int p = 0; p < (dimension == 3 ? 0 : dimension); ++p) in.number("a parameter");
  }
}

}  // namespace

void read_nodes_1(MshCursor& in, MshFile& file) {
  const std::uint64_t count = in.text_size("the number of nodes");
  in.room_for(count, 8, "nodes");
  NodeSink nodes(in, file, count);
  for (std::uint64_t k = 0; k < count; ++k) {
    nodes.tag(in.text_size("a node number"), in.at());
    read_text_place(in, nodes);
    in.line();  // with Mesh.SaveParametric Gmsh adds the entity and its parameters
  }
  nodes.finish();
}

void read_nodes_2(MshCursor& in, MshFile& file, bool parametric) {
  const std::uint64_t count = in.text_size("the number of nodes");
  in.end_line("the number of nodes");
  in.room_for(count, in.binary ? 4 + 3 * 8 : 8, "nodes");
  NodeSink nodes(in, file, count);
  if (parametric) {
    read_parametric(in, nodes, count);
  } else if (in.binary) {
    in.swapped ? read_binary_2<true>(in, nodes, static_cast<std::size_t>(count))
               : read_binary_2<false>(in, nodes, static_cast<std::size_t>(count));
  } else {
    for (std::uint64_t k = 0; k < count; ++k) {
      nodes.tag(in.text_size("a node number"), in.at());
      read_text_place(in, nodes);
    }
  }
  nodes.finish();
}

void read_nodes_4(MshCursor& in, MshFile& file, bool is_4_0) {
  const std::uint64_t blocks = in.size("the number of blocks");
  const std::uint64_t count = in.size("the number of nodes");
  if (!is_4_0) {
    in.size("the least node tag");
    in.size("the greatest node tag");
  }
  in.room_for(count, in.binary ? (is_4_0 ? 4 : 8) + 3 * 8 : 8, "nodes");
  NodeSink nodes(in, file, count);
  for (std::uint64_t block = 0; block < blocks; ++block) {
    std::int32_t dimension = in.int32(is_4_0 ? "an entity's tag" : "a block's dimension");
    const std::int32_t second = in.int32(is_4_0 ? "a block's dimension" : "an entity's tag");
    if (is_4_0) dimension = second;
    const std::int32_t parametric = in.int32("0 or 1 (parametric)");
    if (dimension < 0 || dimension > 3 || parametric < 0 || parametric > 1)
      in.fail("expected a block of nodes: a dimension from 0 to 3, a tag, 0 or 1 (parametric), a number of nodes");
    const std::uint64_t here = in.size("the block's number of nodes");
    nodes.block(here);
    const auto parameters = static_cast<std::size_t>(parametric * dimension);
    if (is_4_0) {
      read_block_4_0(in, nodes, static_cast<std::size_t>(here), parameters);
      continue;
    }
    if (in.binary) {
      in.swapped ? read_block_4<true>(in, nodes, static_cast<std::size_t>(here), parameters)
                 : read_block_4<false>(in, nodes, static_cast<std::size_t>(here), parameters);
      continue;
    }
    for (std::uint64_t k = 0; k < here; ++k) nodes.tag(in.text_size("a node tag"), in.at());
    for (std::uint64_t k = 0; k < here; ++k) {
      read_text_place(in, nodes);
      for (std::size_t p = 0; p < parameters; ++p) in.text_number("a parameter");
    }
  }
  nodes.finish();
}

}  // namespace pliant
