// lib/pliant/generate/mesh_from_boundary.h: makes the first mesh of a boundary complex (paper §6).
#pragma once
#include <string>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"

namespace pliant {

struct GenerateOptions {
  int degree = 0;                ///< the degree of the mesh; 0: the highest degree of the curves, at least 2
  Progress* progress = nullptr;  ///< is told how many rounds were made
};
struct GenerateOutcome {
  bool ok = false;
  std::string failure;  ///< why no valid mesh was reached, with the place
  PassReport report;
};

/// Meshes every face, so that every element is certified valid. The steps are these:
/// - spans are split by knot insertion until they are tame (tame_spans);
/// - their chords are triangulated (constrained Delaunay), and ears that cover a smooth or reflex corner of the
/// boundary
///   get an inner point, since no element can be valid there;
/// - boundary edges become curved, and control points are moved where elements are not valid;
/// - where that does not suffice spans are split, and all is done again.
/// The mesh is not refined for quality: `refine` does that.
///
/// Requires    check_boundary, check_boundary_geometry and check_boundary_sides to be empty.
GenerateOutcome mesh_from_boundary(const BoundaryComplex& boundary, const GenerateOptions& options, Mesh& mesh);

}  // namespace pliant
