// lib/pliant/generate/smooth_or_remesh.h: smoothing, and where it leaves elements invalid, a new mesh of their regions.
#pragma once
#include <functional>

#include "pliant/improve/smooth_curves.h"

namespace pliant {

/// Smooths the mesh. If elements are still invalid, regions around them are meshed anew (remesh_invalid); if any was,
/// the mesh is smoothed again. This is what the tool smoothcurves does without --keep-going.
///
/// The report counts the work of both smoothings together. Its value "patches_remeshed" is the number of regions that
/// were meshed anew, and a note says how many elements they had before and have now. Elements may be invalid even
/// then: the outcome tells which.
SmoothOutcome smooth_or_remesh(Mesh& mesh, const SmoothOptions& options = {});

/// The same with another smoother. `refit` says how regions that are meshed anew get the values of their fields.
SmoothOutcome smooth_or_remesh(Mesh& mesh, const std::function<SmoothOutcome(Mesh&)>& smooth,
                               const RefitOptions& refit);

}  // namespace pliant
