// formats/msh/msh_file.h: what an MSH file says, before it becomes a mesh.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/msh/msh.h"
#include "formats/msh/msh_cursor.h"
#include "pliant/geometry/point.h"
#include "pliant/mesh/ids.h"

namespace pliant {

inline constexpr std::size_t msh_point_type = 15;
inline constexpr int msh_type_count = 141;  ///< one more than the last element type

/// One of Gmsh's element types.
struct MshElementType {
  enum Family : char { unknown, point, line, triangle, quadrangle, tetrahedron, hexahedron, prism, pyramid, other };
  Family family = unknown;
  int nodes = 0;  ///< 0 where the number is not known, or differs between elements
  int order = 0;  ///< the order of a line or triangle with all its nodes; 0 for types that are not read
};

/// The type with this number; `unknown` for a number that Gmsh does not use.
const MshElementType& msh_element_type(std::int64_t type);
/// Elements as words: "12 quadrangles of 4 nodes (type 3)".
std::string describe_left_out(std::int64_t type, std::uint64_t count);
/// The place in NetLayout of each node of a triangle of this order. Gmsh lists the corners, then the nodes of edges 12,
/// 23 and 31, and then the inner ones as a triangle of order - 3.
std::vector<int> msh_net_order(int order);

/// Finds nodes by their tags.
class MshNodeTags {
 public:
  /// Adds the next node, with its tag.
  void add(std::uint64_t tag) { tags_.add(tag); }
  void add(std::uint64_t tag, std::size_t count) { tags_.add(tag, count); }
  /// Prepares the search: all nodes, or all of this section, have been added. The result is a tag that two nodes share,
  /// if there is one.
  const std::uint64_t* prepare();
  std::size_t size() const { return tags_.size(); }
  const TagRuns& all() const { return tags_; }
  std::uint64_t highest() const;
  std::uint64_t tag_of(PointId node) const { return tags_.tag_of(static_cast<std::size_t>(node)); }
  /// The number of the node with this tag, or none.
  PointId find(std::uint64_t tag) const {
    const std::uint64_t place = tag - lowest_;
    if (is_one_run_) return place < tags_.size() ? static_cast<PointId>(place) : none;
    if (!table_.empty()) return place < table_.size() ? table_[static_cast<std::size_t>(place)] : none;
    return search(tag);
  }

 private:
  struct Range {
    std::uint64_t tag, last;  ///< tags of the first node and of the last
    std::size_t first;        ///< number of the first node
  };
  PointId search(std::uint64_t tag) const;
  TagRuns tags_;
  std::uint64_t lowest_ = 0, twice_ = 0;
  bool is_one_run_ = false;
  std::vector<PointId> table_;  ///< nodes by tag - lowest_, where tags are dense
  std::vector<Range> ranges_;   ///< sorted ranges, where tags are sparse
};

/// Triangles that follow each other in the file, of one order and on one surface.
struct MshTriangles {
  int order;
  int entity;
  int physical;  ///< 0: none
  std::size_t count;
};

/// A line element: its ends, group and entity.
struct MshLine {
  PointId from, to;
  int entity, physical;
};

/// A geometrical entity: its first physical group (0 for none), and whether it has more.
struct MshEntity {
  int physical = 0;
  bool has_more = false;
  int parent = 0;  ///< the entity that it is a partition of; 0: none
};

/// The part of a section $InterpolationScheme that is about triangles: value i of an element is the factor of the
/// polynomial that has row i of `coefficients` before the monomials u^a v^b. The reference triangle has the corners
/// (0, 0), (1, 0), (0, 1).
struct MshScheme {
  std::size_t count = 0;             ///< how many values an element has; 0 if there is nothing for triangles
  std::vector<double> coefficients;  ///< count rows, a number for each monomial
  std::vector<double> exponents;     ///< two for each monomial
};

/// The head of a section with values: $NodeData, $ElementData or $ElementNodeData.
struct MshDataSection {
  enum Kind : char { node, element, element_node };
  Kind kind = node;
  std::string view, scheme;
  std::string mark;  ///< the third string tag, in which export-msh says what Gmsh has no tag for
  double time = 0;
  std::int32_t step = 0, components = 1, partition = 0;
  std::uint64_t entries = 0;
  MshCursor in;  ///< stands before the first entry
};
const char* section_name(MshDataSection::Kind kind);

struct MshFile {
  std::vector<Point> nodes;
  std::vector<double> z;  ///< z of each node; empty where all are `plane`
  double plane = 0;
  MshNodeTags tags;
  std::vector<MshTriangles> blocks;
  std::vector<PointId> triangle_nodes;  ///< nodes of the triangles of all blocks, in Gmsh's order
  TagRuns triangle_tags;
  std::vector<MshLine> lines;
  std::map<std::pair<int, int>, std::string> names;      ///< names of physical groups, by dimension and tag
  std::map<std::pair<int, int>, MshEntity> entities;     ///< by dimension and tag
  std::array<std::uint64_t, msh_type_count> left_out{};  ///< how many elements of each type are not read
  std::vector<std::string> skipped;                      ///< names of sections that are not read
  std::vector<MshDataSection> data;                      ///< sections with values, in the order of the file
  std::map<std::string, MshScheme> schemes;              ///< by name; of two with one name the first
};

/// The largest coordinate that is read: beyond it a control point could overflow.
inline constexpr double msh_largest = 1e300;

/// Reads all sections.   Throws InputError
MshFile read_msh_file(std::string_view bytes);

// The bulk sections, one reader each (msh_nodes.cpp, msh_elements.cpp): the cursor stands behind "$Nodes" and its line
// end, and is left where "$EndNodes" must follow.
void read_nodes_1(MshCursor& in, MshFile& file);
void read_nodes_2(MshCursor& in, MshFile& file, bool parametric);
void read_nodes_4(MshCursor& in, MshFile& file, bool is_4_0);
void read_elements_1(MshCursor& in, MshFile& file);
void read_elements_2(MshCursor& in, MshFile& file);
void read_elements_4(MshCursor& in, MshFile& file, bool is_4_0);

// Sections with values (msh_views.cpp): the cursor stands behind the line of the section's name, and is left behind the
// section. Values themselves are read later, when the triangles are known.
void read_data_head(MshCursor& in, MshFile& file, MshDataSection::Kind kind, const char* start);
void read_scheme(MshCursor& in, MshFile& file);

}  // namespace pliant
