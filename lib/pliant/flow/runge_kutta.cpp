// lib/pliant/flow/runge_kutta.cpp: Runge-Kutta methods of fixed steps, for the displacement of a point.
#include "pliant/flow/runge_kutta.h"

#include <cassert>

namespace pliant {
namespace {

/// Carries through `substeps` equal steps; `advance(x, t, h)` gives the displacement in one of them.
template <class Advance>
Vector in_equal_steps(const Point& from, double time, double dt, int substeps, const Advance& advance) {
  const double h = dt / substeps;
  // The sum is of displacements, not of places, so that a small step far from the origin keeps its digits.
  Vector moved{};
  for (int step = 0; step < substeps; ++step)
    moved += advance(from + moved, time + dt * (static_cast<double>(step) / substeps), h);
  return moved;
}

}  // namespace

Vector carry(const VelocityField& velocity, const Point& from, double time, double dt, int substeps,
             TimeMethod method) {
  assert(substeps >= 1 && method != TimeMethod::dopri5);
  switch (method) {
    case TimeMethod::euler:
      return in_equal_steps(from, time, dt, substeps,
                            [&](const Point& x, double t, double h) { return h * velocity(x, t); });
    case TimeMethod::midpoint:
      return in_equal_steps(from, time, dt, substeps, [&](const Point& x, double t, double h) {
        return h * velocity(x + 0.5 * h * velocity(x, t), t + 0.5 * h);
      });
    default:
      return in_equal_steps(from, time, dt, substeps, [&](const Point& x, double t, double h) {
        const Vector k1 = velocity(x, t);
        const Vector k2 = velocity(x + 0.5 * h * k1, t + 0.5 * h);
        const Vector k3 = velocity(x + 0.5 * h * k2, t + 0.5 * h);
        const Vector k4 = velocity(x + h * k3, t + h);
        return h / 6 * (k1 + 2 * (k2 + k3) + k4);
      });
  }
}

}  // namespace pliant
