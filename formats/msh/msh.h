// formats/msh/msh.h: reads Gmsh's MSH files, versions 1 to 4.1, text and binary (formats/msh.md).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Numbers that Gmsh gave to a sequence of things, kept as runs of successive ones.
class TagRuns {
 public:
  /// The next thing of the sequence has this tag.
  void add(std::uint64_t tag) {
    if (runs_.empty() || tag != next_) runs_.push_back({tag, count_});
    next_ = tag + 1;
    ++count_;
  }
  /// The same for `count` things with successive tags.
  void add(std::uint64_t tag, std::size_t count) {
    if (count == 0) return;
    add(tag);
    next_ += count - 1;
    count_ += count - 1;
  }
  struct Run {
    std::uint64_t tag;
    std::size_t first;  ///< place in the sequence
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
};

struct MshImport {
  MeshData mesh;
  std::vector<std::string> warnings;  ///< what was left out or looks wrong, a sentence each
  std::vector<std::string> notes;     ///< what was left out and is no loss: points of the geometry
  TagRuns elements;                   ///< Gmsh's tag of each triangle
  TagRuns nodes;                      ///< and of each point; of those that elevation made the first free ones
};

/// The section that says how the others are written; sections that mean nothing may stand before it.
inline constexpr std::string_view msh_magic = "$MeshFormat";

/// The mesh of a file: Lagrange nodes become Bézier control points, physical groups faces and names of curves; edges
/// with one triangle, or between two faces, become constrained edges.
///
/// Ensures     check_arrays of the mesh is empty. No more is promised: structure (M1, M2, M5) and validity are as in
/// the
///             file, for `check_structure` and `find_invalid` to judge
/// Throws      InputError with "line N" (text) or "byte N" (binary) in place of a pointer
/// Complexity  O(bytes); never allocates more than a small multiple of the file's size
MshImport read_msh(std::string_view bytes, const MshOptions& options = {});

/// A fault of the mesh in the words of the file it was read from: triangles and points of its place and text become
/// elements and nodes by their tags.
Fault in_msh_words(const MshImport& import, const Fault& fault);

}  // namespace pliant
