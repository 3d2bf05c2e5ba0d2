// lib/pliant/flow/carry_adaptively.cpp: the Dormand-Prince method of order 5(4), with one step for all points.
#include "pliant/flow/carry_adaptively.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/geometry/describe.h"

namespace pliant {
namespace {

constexpr int most_tries = 10000;
constexpr double shortest_part = 0x1p-50;  // a step that is a smaller part of dt would not change the time
constexpr double least_factor = 0.2, greatest_factor = 5;  // bounds of how one step's length differs from the last's
constexpr double margin = 0.9;    // the next step is this much shorter than the estimate allows
constexpr double retreat = 0.25;  // after a try with no finite velocity, or none at all, so much of its length

/// A point on its way: how far it has come since the start, and its velocity there.
struct Carried {
  Vector moved, velocity;
};

/// One try of one point from time t by h, and the estimate of its error.
std::pair<Carried, double> try_step(const VelocityField& velocity, const Point& from, const Carried& at, double t,
                                    double h) {
  const Point x = from + at.moved;
  const Vector& k1 = at.velocity;
  const Vector k2 = velocity(x + h * (1.0 / 5 * k1), t + 1.0 / 5 * h);
  const Vector k3 = velocity(x + h * (3.0 / 40 * k1 + 9.0 / 40 * k2), t + 3.0 / 10 * h);
  const Vector k4 = velocity(x + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3), t + 4.0 / 5 * h);
  const Vector k5 = velocity(
      x + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 - 212.0 / 729 * k4), t + 8.0 / 9 * h);
  const Vector k6 = velocity(
      x + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 - 5103.0 / 18656 * k5),
      t + h);
  const Vector step =
      h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 + 11.0 / 84 * k6);
  const Vector k7 = velocity(x + step, t + h);
  const Vector error = h * (71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 - 17253.0 / 339200 * k5 +
                            22.0 / 525 * k6 - 1.0 / 40 * k7);
  return {{at.moved + step, k7}, std::hypot(error.x, error.y)};
}

/// The greatest estimate of one try over all points, and its point.
struct Estimate {
  double error = 0;
  std::size_t worst = 0;
};

/// One try of all points into `next`. Empty where the velocity is not finite somewhere on the way.
std::optional<Estimate> try_all(const VelocityField& velocity, std::span<const Point> from, std::span<const Carried> at,
                                double t, double h, std::span<Carried> next) {
  Estimate estimate;
  for (std::size_t i = 0; i < from.size(); ++i) {
    double error = 0;
    std::tie(next[i], error) = try_step(velocity, from[i], at[i], t, h);
    if (!is_finite(next[i].moved) || !is_finite(next[i].velocity) || !std::isfinite(error)) return std::nullopt;
    if (error > estimate.error) estimate = {error, i};
  }
  return estimate;
}

std::string describe_failure(int tries, double tolerance, double time, const Point& place, double needed) {
  return (tries >= most_tries ? std::to_string(tries) + " tries of steps do not meet"
                              : "no step is short enough to meet") +
         (" the tolerance " + describe_number(tolerance)) + ": at time " + describe_number(time) +
         (std::isfinite(needed) ? " the estimate of the error near " + describe_point(place) + " is " +
                                      describe_number(std::round(needed)) + " times what it may be"
                                : " the velocity is not finite near " + describe_point(place));
}

}  // namespace

AdaptiveMotion carry_adaptively(const VelocityField& velocity, std::span<const Point> from, double time, double dt,
                                double tolerance) {
  assert(tolerance > 0);
  AdaptiveMotion motion;
  std::vector<Carried> at(from.size()), next(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    at[i].velocity = velocity(from[i], time);
    if (!is_finite(at[i].velocity)) {  // the caller sees where
      motion.moved.assign(from.size(), {});
      motion.moved[i] = at[i].velocity;
      return motion;
    }
  }
  double done = 0, part = 1;  // how much of dt is behind, and how much of it the next try is
  for (int tries = 1; done < 1 && !from.empty(); ++tries) {
    const bool last = part >= 1 - done;
    if (last) part = 1 - done;
    const double t = time + dt * done;
    std::optional<Estimate> estimate;
    std::optional<NoVelocity> nowhere;
    try {
      estimate = try_all(velocity, from, at, t, dt * part, next);
    } catch (const NoVelocity& e) {  // a shorter step may stay where there is a velocity
      nowhere = e;
    }
    const double ratio = estimate ? estimate->error / (tolerance * part) : HUGE_VAL;
    if (ratio <= 1) {
      std::swap(at, next);
      done = last ? 1 : done + part;
      ++motion.steps;
    } else if (tries >= most_tries || part <= shortest_part) {
      if (nowhere) throw NoVelocity(*nowhere);
      const std::size_t worst = estimate ? estimate->worst : 0;
      motion.why = describe_failure(tries, tolerance, t, from[worst] + at[worst].moved, ratio);
      return motion;
    }
    part *= !estimate   ? retreat
            : ratio > 0 ? std::clamp(margin * std::pow(ratio, -0.25), least_factor, greatest_factor)
                        : greatest_factor;
  }
  for (const Carried& each : at) motion.moved.push_back(each.moved);
  return motion;
}

}  // namespace pliant
