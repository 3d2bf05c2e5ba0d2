// lib/pliant/flow/carry_adaptively.h: finds where a flow carries many points, in steps that an estimate chooses.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/flow/velocity_field.h"

namespace pliant {

struct AdaptiveMotion {
  std::vector<Vector> moved;  ///< the displacement of each point; not finite where the velocity is not at the start
  int steps = 0;              ///< that were taken
  std::string why;            ///< why the end was not reached, a sentence; empty if it was
};

/// Carries points from `time` to `time + dt` by the method of Dormand and Prince, of order 5 with an error estimate of
/// order 4. All points take the same steps, those that the worst point needs: so the motion is a smooth function of
/// the point, and neighbours do not differ by the tolerance.
///
/// A step of length h is taken if the estimate of its error is at most tolerance * h / dt at every point, so that all
/// estimates of one point sum up to the tolerance at most; else it is tried again, shorter.
///
/// Units       tolerance: a length; dt may be negative
/// Refuses     more than 10000 tries, and steps too short to change the time
/// Complexity  7 velocities for each point and try; 64 bytes for each point
AdaptiveMotion carry_adaptively(const VelocityField& velocity, std::span<const Point> from, double time, double dt,
                                double tolerance);

}  // namespace pliant
