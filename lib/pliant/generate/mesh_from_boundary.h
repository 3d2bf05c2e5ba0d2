// lib/pliant/generate/mesh_from_boundary.h: the first mesh of a boundary complex (paper §6).
#pragma once
#include <string>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"

namespace pliant {

struct GenerateOptions {
  int degree = 0;                ///< of the mesh; 0: the largest degree of the curves, at least 2
  Progress* progress = nullptr;  ///< told the rounds
};
struct GenerateOutcome {
  bool ok = false;
  std::string failure;  ///< why no valid mesh was reached, with the place
  PassReport report;
};

/// Meshes every face: spans are split (knot insertion) until they are tame, their chords triangulated (constrained
/// Delaunay), boundary edges curved, inner edges placed by optimal placement where elements are not valid, then split;
/// every element is certified valid. Ears that cover a smooth or reflex corner of the boundary get an inner point
/// (design: M3). No quality refinement: that is `refine`.
/// Requires check_boundary, check_boundary_geometry and check_boundary_sides to be empty.
GenerateOutcome mesh_from_boundary(const BoundaryComplex& boundary, const GenerateOptions& options, Mesh& mesh);

}  // namespace pliant
