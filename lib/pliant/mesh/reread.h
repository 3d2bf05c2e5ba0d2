// lib/pliant/mesh/reread.h: a mesh as it would be if it had been written to a document and read again.
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Makes a mesh that a pass has left what a reader of its document gets (numbering, size, unit of length), so that a
/// pass over it does what it would do in a process of its own.
///
/// Throws      std::domain_error where a number of it is not finite, so that no document can hold it; InputError as
///             normalize_unit does where the mesh has grown or shrunk out of range
/// Complexity  one look at each number; where the pass has not renumbered the mesh, or the unit of length changes, the
///             mesh is made anew
void reread(Mesh& mesh);

}  // namespace pliant
