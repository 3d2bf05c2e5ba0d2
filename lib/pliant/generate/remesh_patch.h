// lib/pliant/generate/remesh_patch.h: takes tangled elements out and meshes their region anew, as the last resort.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct RemeshPatchCounts {
  long patches = 0;           ///< regions meshed anew
  long triangles_before = 0;  ///< triangles in these regions before
  long triangles_after = 0;   ///< and afterwards
  long edges_split = 0;       ///< edges on the borders of these regions that were split
  long left = 0;  ///< elements that are still not valid: no region around them, up to their whole face, could be meshed
};

/// Replaces invalid elements by a new first mesh of the region around them (mesh_from_boundary), for which the edges on
/// the region's border are curves of a boundary complex. A region is a connected set of invalid elements with a ring
/// around it. It grows, at most to its whole face, until its border is in order (no edges cross, and the region lies
/// inside) and all new elements are valid.
///
/// The border keeps its shape. Where its edges turn too much or come too near each other they are split, together with
/// the elements outside; on curves knots are inserted. All others keep their control points bit for bit. Lone vertices
/// stay. Every region is a transaction of its own: one that fails leaves the mesh as it was.
///
/// Fields are carried over by PatchFields: the integral of each component over the mesh stays, and linear functions
/// stay what they are.
///
/// A mesh without invalid elements stays as it is; any other is compacted.
///
/// Complexity  O(triangles) to certify. An attempt costs what a first mesh of the region costs. A region grows ever
///             faster, so the number of attempts is about the logarithm of the number of rings in its face
RemeshPatchCounts remesh_invalid(Mesh& mesh, const RefitOptions& refit = {});

}  // namespace pliant
