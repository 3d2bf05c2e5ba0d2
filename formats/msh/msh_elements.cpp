// formats/msh/msh_elements.cpp: the section $Elements of MSH 2.2 and 4.1.
#include <algorithm>

#include "formats/msh/msh_file.h"

namespace pliant {
namespace {

/// A block of the file: elements of one type on one entity.
struct Block {
  std::int64_t type;
  int entity, physical;
  const MshElementType& of;
};

/// Takes the elements of a file one by one.
class ElementSink {
 public:
  ElementSink(const MshCursor& in, MshFile& file) : in_(in), file_(file), triangles_(file.triangle_tags.size()) {}

  /// Is it one of the types that a mesh is made of?
  static bool is_read(const MshElementType& of) { return of.order > 0; }
  void leave_out(std::int64_t type, std::uint64_t count) { file_.left_out[static_cast<std::size_t>(type)] += count; }

  /// Prepares for `count` elements of this block, which come next.
  void begin(const Block& block, std::size_t count) {
    if (block.of.family != MshElementType::triangle) return;
    const bool continues = !file_.blocks.empty() && file_.blocks.back().order == block.of.order &&
                           file_.blocks.back().entity == block.entity && file_.blocks.back().physical == block.physical;
    if (!continues) file_.blocks.push_back({block.of.order, block.entity, block.physical, 0});
    file_.blocks.back().count += count;
    triangles_ += count;
    if (triangles_ > std::numeric_limits<TriangleId>::max() / 3)
      in_.fail("these are more triangles than can be numbered");
  }
  /// The node of that tag.
  PointId node(std::uint64_t tag, const char* where) const {
    const PointId found = file_.tags.find(tag);
    if (found == none) in_.fail_at(where, "there is no node of tag " + std::to_string(tag));
    return found;
  }
  void line(const Block& block, PointId from, PointId to) {
    file_.lines.push_back({from, to, block.entity, block.physical});
  }

 private:
  const MshCursor& in_;
  MshFile& file_;
  std::uint64_t triangles_;  ///< number of triangles in this section and those before it
};

/// Reads elements of a binary file. An element's tag stands at `at` and its nodes `behind` bytes later; all are of type
/// `Tag`.
template <class Tag, bool swap>
void read_binary(const MshCursor& in, MshFile& file, ElementSink& sink, const Block& block, const char* at,
                 std::size_t count, std::size_t behind) {
  const auto nodes = static_cast<std::size_t>(block.of.nodes);
  const auto value = [](const char* p) { return static_cast<std::uint64_t>(load<Tag, swap>(p)); };
  const std::size_t stride = behind + nodes * sizeof(Tag);
  sink.begin(block, count);
  if (block.of.family == MshElementType::line) {
    for (std::size_t k = 0; k < count; ++k, at += stride) {
      const char* ends = at + behind;
      const PointId from = sink.node(value(ends), ends);
      sink.line(block, from, sink.node(value(ends + sizeof(Tag)), ends + sizeof(Tag)));
    }
    return;
  }
  const std::size_t old = file.triangle_nodes.size();
  file.triangle_nodes.resize(old + count * nodes);
  PointId* out = file.triangle_nodes.data() + old;
  for (std::size_t k = 0; k < count; ++k) {
    file.triangle_tags.add(value(at));
    at += behind;
    for (std::size_t n = 0; n < nodes; ++n, at += sizeof(Tag)) {
      const PointId node = file.tags.find(value(at));
      if (node == none) in.fail_at(at, "there is no node of tag " + std::to_string(value(at)));
      *out++ = node;
    }
  }
}

template <class Tag>
void read_binary(const MshCursor& in, MshFile& file, ElementSink& sink, const Block& block, const char* at,
                 std::size_t count, std::size_t behind) {
  in.swapped ? read_binary<Tag, true>(in, file, sink, block, at, count, behind)
             : read_binary<Tag, false>(in, file, sink, block, at, count, behind);
}

/// Reads the nodes of an element of a text file, whose tag has been read.
void read_text(MshCursor& in, MshFile& file, ElementSink& sink, const Block& block, std::uint64_t tag) {
  sink.begin(block, 1);
  const auto next = [&] {
    in.skip_space();
    const char* where = in.at();
    return sink.node(in.text_size("a node tag"), where);
  };
  if (block.of.family == MshElementType::line) {
    const PointId from = next();
    sink.line(block, from, next());
    for (int n = 2; n < block.of.nodes; ++n) next();
    return;
  }
  file.triangle_tags.add(tag);
  for (int n = 0; n < block.of.nodes; ++n) file.triangle_nodes.push_back(next());
}

const MshElementType& known_type(const MshCursor& in, std::int64_t type) {
  const MshElementType& of = msh_element_type(type);
  if (of.family == MshElementType::unknown)
    in.fail("expected the number of an element type, found " + std::to_string(type));
  if (in.binary && of.nodes == 0)
    in.fail("elements of type " + std::to_string(type) + " have no fixed size in a binary file, and are not read");
  return of;
}

constexpr int most_tags = 10000;

void read_binary_2(MshCursor& in, MshFile& file, ElementSink& sink, std::uint64_t count) {
  for (std::uint64_t done = 0; done < count;) {
    const std::int32_t type = in.int32("an element type"), here = in.int32("a number of elements"),
                       tags = in.int32("a number of tags");
    const MshElementType& of = known_type(in, type);
    if (here < 1 || static_cast<std::uint64_t>(here) > count - done || tags < 0 || tags > most_tags)
      in.fail("expected a block of 1 to " + std::to_string(count - done) + " elements with 0 to " +
              std::to_string(most_tags) + " tags, found " + std::to_string(here) + " elements and " +
              std::to_string(tags) + " tags");
    const std::size_t behind = 4 * (1 + static_cast<std::size_t>(tags));
    const std::size_t stride = behind + 4 * static_cast<std::size_t>(of.nodes);
    const char* at = in.take(static_cast<std::size_t>(here), stride, "elements");
    done += static_cast<std::uint64_t>(here);
    if (!ElementSink::is_read(of)) {
      sink.leave_out(type, static_cast<std::uint64_t>(here));
      continue;
    }
    const auto tag = [&](int k, const char* element) {
      const char* p = element + 4 + 4 * static_cast<std::size_t>(k);
      return k >= tags ? 0 : in.swapped ? load<std::int32_t, true>(p) : load<std::int32_t, false>(p);
    };
    for (std::int32_t k = 0; k < here;) {
      const Block block{type, tag(1, at), tag(0, at), of};
      const char* first = at;
      const std::int32_t start = k;
      for (; k < here && tag(1, at) == block.entity && tag(0, at) == block.physical; ++k) at += stride;
      read_binary<std::int32_t>(in, file, sink, block, first, static_cast<std::size_t>(k - start), behind);
    }
  }
}

void read_text_2(MshCursor& in, MshFile& file, ElementSink& sink, std::uint64_t count) {
  for (std::uint64_t done = 0; done < count; ++done) {
    const std::uint64_t tag = in.text_size("an element number");
    const std::int32_t type = in.text_int("an element type");
    const MshElementType& of = known_type(in, type);
    const std::int32_t tags = in.text_int("a number of tags");
    if (tags < 0 || tags > most_tags) in.fail("expected a number of tags, found " + std::to_string(tags));
    int physical = 0, entity = 0;
    for (int k = 0; k < tags; ++k) {
      const std::int32_t value = in.text_int("a tag");
      if (k == 0) physical = value;
      if (k == 1) entity = value;
    }
    if (ElementSink::is_read(of)) {
      read_text(in, file, sink, {type, entity, physical, of}, tag);
    } else {
      sink.leave_out(type, 1);
      in.line();
    }
  }
}

}  // namespace

void read_elements_1(MshCursor& in, MshFile& file) {
  const std::uint64_t count = in.text_size("the number of elements");
  in.room_for(count, 6, "elements");
  ElementSink sink(in, file);
  for (std::uint64_t done = 0; done < count; ++done) {
    const std::uint64_t tag = in.text_size("an element number");
    const std::int32_t type = in.text_int("an element type");
    const MshElementType& of = known_type(in, type);
    const std::int32_t physical = in.text_int("a physical tag"), entity = in.text_int("an entity's tag");
    const std::int32_t nodes = in.text_int("a number of nodes");
    if (of.nodes != 0 && nodes != of.nodes)
      in.fail("elements of type " + std::to_string(type) + " have " + std::to_string(of.nodes) + " nodes, not " +
              std::to_string(nodes));
    if (ElementSink::is_read(of)) {
      read_text(in, file, sink, {type, entity, physical, of}, tag);
    } else {
      sink.leave_out(type, 1);
      in.line();
    }
  }
}

void read_elements_2(MshCursor& in, MshFile& file) {
  const std::uint64_t count = in.text_size("the number of elements");
  in.end_line("the number of elements");
  in.room_for(count, in.binary ? 8 : 6, "elements");
  ElementSink sink(in, file);
  in.binary ? read_binary_2(in, file, sink, count) : read_text_2(in, file, sink, count);
}

void read_elements_4(MshCursor& in, MshFile& file, bool is_4_0) {
  const std::uint64_t blocks = in.size("the number of blocks");
  const std::uint64_t count = in.size("the number of elements");
  if (!is_4_0) {
    in.size("the least element tag");
    in.size("the greatest element tag");
  }
  const std::size_t tag_size = is_4_0 ? 4 : 8;
  in.room_for(count, in.binary ? 2 * tag_size : 4, "elements");
  ElementSink sink(in, file);
  std::uint64_t done = 0;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    std::int32_t entity = in.int32(is_4_0 ? "an entity's tag" : "a block's dimension");
    const std::int32_t second = in.int32(is_4_0 ? "a block's dimension" : "an entity's tag");
    if (!is_4_0) entity = second;
    const std::int32_t type = in.int32("an element type");
    const MshElementType& of = known_type(in, type);
    const std::uint64_t here = in.size("the block's number of elements");
    if (here > count - done)
      in.fail("the section announces " + std::to_string(count) +
              " elements, but its blocks hold more: " + std::to_string(done) + " and then " + std::to_string(here));
    done += here;
    const Block block{type, entity, 0, of};
    if (in.binary) {
      const std::size_t stride = tag_size * (1 + static_cast<std::size_t>(of.nodes));
      const char* at = in.take(static_cast<std::size_t>(here), stride, "elements");
      // Elements of this header may fill the rest of the file, but no more than that.
      if (of.family == MshElementType::triangle && file.triangle_nodes.empty())
        file.triangle_nodes.reserve(
            std::min(static_cast<std::size_t>(count - done + here) * static_cast<std::size_t>(of.nodes),
                     (static_cast<std::size_t>(in.at() - at) + in.left()) / tag_size));
      if (!ElementSink::is_read(of))
        sink.leave_out(type, here);
      else if (is_4_0)
        read_binary<std::int32_t>(in, file, sink, block, at, static_cast<std::size_t>(here), 4);
      else
        read_binary<std::uint64_t>(in, file, sink, block, at, static_cast<std::size_t>(here), 8);
      continue;
    }
    if (!ElementSink::is_read(of)) sink.leave_out(type, here);
    for (std::uint64_t e = 0; e < here; ++e) {
      const std::uint64_t tag = in.text_size("an element tag");
      if (ElementSink::is_read(of))
        read_text(in, file, sink, block, tag);
      else
        in.line();
    }
  }
  if (done != count)
    in.fail("the section announces " + std::to_string(count) + " elements, but its blocks hold " +
            std::to_string(done));
}

}  // namespace pliant
