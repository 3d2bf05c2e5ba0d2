// lib/pliant/flow/runge_kutta.cpp: the classical Runge-Kutta method, for the displacement of a point.
#include "pliant/flow/runge_kutta.h"

#include <cassert>

namespace pliant {

Vector carry(const VelocityField& velocity, const Point& from, double time, double dt, int substeps) {
  assert(substeps >= 1);
  const double h = dt / substeps;
  // The sum is of displacements, not of places, so that a small step far from the origin keeps its digits.
  Vector moved{};
  for (int step = 0; step < substeps; ++step) {
    const Point x = from + moved;
    const double t = time + dt * (static_cast<double>(step) / substeps);
    const Vector k1 = velocity(x, t);
    const Vector k2 = velocity(x + 0.5 * h * k1, t + 0.5 * h);
    const Vector k3 = velocity(x + 0.5 * h * k2, t + 0.5 * h);
    const Vector k4 = velocity(x + h * k3, t + h);
    moved += h / 6 * (k1 + 2 * (k2 + k3) + k4);
  }
  return moved;
}

}  // namespace pliant
