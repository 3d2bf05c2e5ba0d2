// lib/pliant/flow/advect_to.h: steps of a loop that ends at a given time.
#pragma once
#include <functional>
#include <optional>

#include "pliant/flow/advect.h"

namespace pliant {

/// One step of a loop: `advect` with the time kept round, and towards `until`, if there is one, by min(dt, until -
/// time). A step that would miss `until` by less than 1e-9 of its length ends there exactly; every other full step ends
/// at round_time. A mesh at `until` or later stays as it is (`late`). This is what the tool advect does.
///
/// Units       places, velocities and lengths of the document, also where the mesh is in another unit (normalize_unit)
/// Requires    dt > 0
/// Refuses     as advect; `no_progress` where the time has so many digits that the step would not change it
AdvectOutcome advect_to(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options,
                        std::optional<double> until = {});
/// The same with any step, for example advect_by_field; it is called at most once.
using Step = std::function<AdvectOutcome(const AdvectOptions&)>;
AdvectOutcome advect_to(Mesh& mesh, AdvectOptions options, std::optional<double> until, const Step& step);

/// The time that a step led to, without the rounding errors that steps of a round length pile up: 100 steps of 0.05
/// from 0 end at 5. It is the nearest number of at most 12 digits if that is a few bits away, else the time itself.
double round_time(double time, double dt);

}  // namespace pliant
