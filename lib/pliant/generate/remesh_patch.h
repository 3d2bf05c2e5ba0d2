// lib/pliant/generate/remesh_patch.h: tangled elements are taken out and their region is meshed anew, as the last
// resort.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct RemeshPatchCounts {
  long patches = 0;           ///< regions meshed anew
  long triangles_before = 0;  ///< in these regions
  long triangles_after = 0;
  long edges_split = 0;  ///< on the borders of these regions
  long left = 0;  ///< elements that are still not valid: no region around them, up to their whole face, could be meshed
};

/// Replaces the elements that are not valid, in connected regions with a ring around them, by a first mesh of the
/// region (mesh_from_boundary): the edges of its border are the curves of a boundary complex. A region grows, at most
/// to its face, until its border is in order (nothing crosses, the region lies inside) and all new elements are valid.
///
/// The border keeps its control points bit for bit; where its edges turn too much or come too near each other, they
/// are split, together with the elements outside (on curves: knots are inserted). Lone vertices stay. Every change is
/// a transaction of its own: a region that fails leaves the mesh as it was.
///
/// Fields: see PatchFields. The integral of each component over the mesh stays; linear functions stay themselves.
///
/// A mesh without invalid elements stays as it is; any other is compacted.
///
/// Complexity  O(mesh) to certify; a region costs what its first mesh costs, and it grows ever faster, so that the
///             attempts for one region are some log of the number of rings in its face
RemeshPatchCounts remesh_invalid(Mesh& mesh, const RefitOptions& refit = {});

}  // namespace pliant
