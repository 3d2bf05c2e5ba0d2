// lib/pliant/flow/runge_kutta.h: finds where a flow carries one point, in equal steps.
#pragma once
#include "pliant/flow/time_method.h"
#include "pliant/flow/velocity_field.h"

namespace pliant {

/// The displacement of a point that starts at `from` at `time` and is carried for `dt`, in `substeps` equal steps of a
/// method with steps of its own length. Not finite if the velocity is not.
///
/// Units       dt may be negative (back in time)
/// Requires    substeps >= 1; a method other than dopri5, which carries many points at once (carry_adaptively)
Vector carry(const VelocityField& velocity, const Point& from, double time, double dt, int substeps,
             TimeMethod method = TimeMethod::rk4);

}  // namespace pliant
