// lib/pliant/flow/runge_kutta.h: finds where a flow carries one point.
#pragma once
#include "pliant/flow/velocity_field.h"

namespace pliant {

/// The displacement of a point that starts at `from` at `time` and is carried for `dt`, by the classical Runge-Kutta
/// method of order 4 in `substeps` equal steps. Not finite if the velocity is not.
///
/// Units       dt may be negative (back in time)
/// Requires    substeps >= 1
Vector carry(const VelocityField& velocity, const Point& from, double time, double dt, int substeps);

}  // namespace pliant
