// lib/pliant/flow/time_method.h: the methods by which points are carried along in time.
#pragma once

namespace pliant {

/// How a point is carried through a step, with the order of the error in time.
enum class TimeMethod {
  euler,     ///< 1: by the velocity at the start
  midpoint,  ///< 2: by the velocity half way
  rk4,       ///< 4: the classical Runge-Kutta method
  dopri5     ///< 5: Dormand and Prince's method, in steps that keep the estimate of its error below a tolerance
};

}  // namespace pliant
