// formats/document/mesh_json.h: the mesh and boundary documents, as JSON and JSON Lines (formats/mesh.md).
#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_place.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Reads one mesh document. Checks the grammar of all of it, the types, that numbers are finite, and check_arrays.
/// Throws      InputError with a JSON pointer (or line and column of the text where it is no JSON)
/// Ensures     `doubts` holds the unknown members that look like missing ones, each kind once, few kinds
MeshData read_mesh(std::string_view json, std::vector<Doubt>* doubts = nullptr);
BoundaryComplex read_boundary(std::string_view json, std::vector<Doubt>* doubts = nullptr);

/// Appends the document, one line with its newline, numbers in shortest round-trip form. Byte-exact: what was written
/// and is read and written again is the same.
void write_mesh(const MeshData& mesh, std::string& out);
void write_boundary(const BoundaryComplex& boundary, std::string& out);

/// The documents of a stream, one at a time with memory for one: JSON Lines, or a single document over many lines.
class DocumentStream {
 public:
  /// Takes over the stream (not closed). `name` is for messages: the file, or "standard input".
  DocumentStream(std::FILE* stream, std::string name);
  ~DocumentStream();
  /// The text of the next document, valid until the next call; false at the end. Blank lines are skipped.
  /// Throws      std::system_error when reading fails
  bool next(std::string_view& document);
  /// All of a stream that starts with these bytes, valid as long as this object; empty, and nothing is passed, if it
  /// starts with others. Only before the first `next`. A regular file is mapped, not copied.
  /// Throws      std::system_error when reading fails
  std::string_view all_if(std::string_view start);
  /// The first bytes, as many as there are up to `most`, of a stream that does not start with an object; empty, without
  /// waiting for more, of one that does. Only before the first `next`.
  std::string_view head_unless_object(std::size_t most);
  long frame() const;       ///< number of the document last returned, from 0
  long first_line() const;  ///< line on which it starts, from 1
  const std::string& name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
