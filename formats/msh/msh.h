// formats/msh/msh.h: reads Gmsh's MSH files, versions 1 to 4.1, text and binary (formats/msh.md).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The tags that Gmsh gave to a sequence of elements or nodes, kept as runs of successive numbers.
class TagRuns {
 public:
  /// Adds the tag of the next thing of the sequence.
  void add(std::uint64_t tag) {
    if (runs_.empty() || tag != next_) runs_.push_back({tag, count_});
    next_ = tag + 1;
    ++count_;
  }
  /// Adds `count` things, whose tags follow each other.
  void add(std::uint64_t tag, std::size_t count) {
    if (count == 0) return;
    add(tag);
    next_ += count - 1;
    count_ += count - 1;
  }
  struct Run {
    std::uint64_t tag;
    std::size_t first;  ///< place of the run's first thing in the sequence
  };
  const std::vector<Run>& runs() const { return runs_; }
  std::size_t size() const { return count_; }
  /// The tag of thing number `index`, which must exist.   Complexity O(log runs)
  std::uint64_t tag_of(std::size_t index) const;

 private:
  std::vector<Run> runs_;
  std::uint64_t next_ = 0;
  std::size_t count_ = 0;
};

struct MshOptions {
  bool orient = false;  ///< turn elements so that neighbours agree and every connected part has a positive area
  std::optional<int> step = {};  ///< which time step of each view is read, from 0; -1: the last. Absent: the first
};

struct MshImport {
  MeshData mesh;
  std::vector<std::string> warnings;  ///< what was left out or looks wrong, a sentence each
  std::vector<std::string> notes;     ///< what was left out without loss: points of the geometry
  TagRuns elements;                   ///< Gmsh's tag of each triangle
  TagRuns nodes;        ///< Gmsh's tag of each point; points that elevation made have the tags behind the greatest
  std::string no_step;  ///< if a view lacks the step that was asked for: which view, and how many steps it has
};

/// The section that says how the others are written. Sections that are passed over may stand before it.
inline constexpr std::string_view msh_magic = "$MeshFormat";

/// Reads the mesh of a file: Lagrange nodes become Bézier control points, and physical groups become faces and names of
/// curves. Edges with one triangle, or between two faces, become constrained edges. Views become fields, and the time
/// of the first of them is that of the mesh.
///
/// Ensures     check_arrays of the mesh is empty. No more is promised: structure (M1, M2, M5) and validity are those
///             of the file, for `check_structure` and `find_invalid` to judge
/// Throws      InputError with "line N" (text) or "byte N" (binary) in place of a pointer
/// Complexity  O(bytes); never allocates more than a small multiple of the file's size
MshImport read_msh(std::string_view bytes, const MshOptions& options = {});

/// A fault of the mesh in the words of the file that it was read from: where its place and text have triangles and
/// points by number, the result has elements and nodes by tag.
Fault in_msh_words(const MshImport& import, const Fault& fault);

}  // namespace pliant
