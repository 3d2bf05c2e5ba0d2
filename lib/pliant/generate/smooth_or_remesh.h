// lib/pliant/generate/smooth_or_remesh.h: smoothing, and where it leaves elements invalid, a new mesh of their regions.
#pragma once
#include <functional>

#include "pliant/improve/smooth_curves.h"

namespace pliant {

/// Smooths; where that leaves elements invalid, meshes their regions anew (remesh_invalid) and smooths again. This is
/// what `smoothcurves` does.
///
/// The report is that of both smoothings together, with the value "patches_remeshed" and a note of what was replaced.
/// Elements may still be invalid in the end: the outcome tells which.
SmoothOutcome smooth_or_remesh(Mesh& mesh, const SmoothOptions& options = {});
/// The same with any smoother; `refit` is for the fields of regions that are meshed anew.
SmoothOutcome smooth_or_remesh(Mesh& mesh, const std::function<SmoothOutcome(Mesh&)>& smooth,
                               const RefitOptions& refit);

}  // namespace pliant
