// lib/pliant/mesh/documents/reread.h: a mesh as it would be if it had been written to a document and read again.
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Changes a mesh that a pass has left to what a reader of its document would get (numbering, size, unit of length).
/// The next pass then does the same as in a process of its own.
///
/// Throws      std::domain_error if a number is not finite, so that no document can hold it; InputError, the same as
///             normalize_unit, if the mesh has grown or shrunk out of range
/// Complexity  one look at each number; if the pass has not compacted the mesh, or the unit of length changes, the mesh
///             is made anew
void reread(Mesh& mesh);

}  // namespace pliant
