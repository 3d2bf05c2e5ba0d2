// lib/pliant/flow/advect.cpp: tries a step, certifies it, and takes it, or a smaller one, or none.
#include "pliant/flow/advect.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "pliant/flow/boundary_gap.h"
#include "pliant/flow/carried_velocity.h"
#include "pliant/flow/carry_adaptively.h"
#include "pliant/flow/certify_motion.h"
#include "pliant/flow/hold_gaps.h"
#include "pliant/flow/keep_cusps.h"
#include "pliant/flow/move_elements.h"
#include "pliant/flow/runge_kutta.h"
#include "pliant/geometry/describe.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

constexpr int most_attempts = 20;        // so often a step is made smaller
constexpr double least_fraction = 1e-6;  // a smaller part of the asked step is not worth taking
constexpr double limit_margin = 0.9;     // this part of the safe fraction is tried next

using Status = AdvectOutcome::Status;

/// The mesh after a step of length dt, not yet taken; or why there is none.
struct Trial {
  Status status = Status::done;
  std::string note{};
  MovedBoundary boundary{};
  std::vector<Point> points{};
  int held = 0;  // places that gaps hold back
};
using MakeTrial = std::function<Trial(double dt)>;

/// The first control point of an element whose place is not finite; none if all are finite.
PointId find_not_finite(const Mesh& mesh, const std::vector<Point>& points) {
  Vector sum;  // of zeros, if all points are finite; of which elements they are does not matter then
  for (const Point& p : points) sum += 0 * p;
  if (is_finite(sum)) return none;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t))
      for (const PointId p : mesh.net(t))
        if (!is_finite(points[static_cast<std::size_t>(p)])) return p;
  return none;
}

double max_displacement(const Mesh& mesh, const std::vector<Point>& points) {
  double greatest = 0, surely_less = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t))
      for (const PointId p : mesh.net(t)) {
        const Vector moved = points[static_cast<std::size_t>(p)] - mesh.point(p);
        if (squared_length(moved) < surely_less) continue;
        greatest = std::max(greatest, length(moved));
        const double squared = greatest * greatest * (1 - 1e-12);
        surely_less = squared > 1e-280 ? squared : 0;  // near the limits of doubles squares tell nothing
      }
  return greatest;
}

std::string blocking_note(const Mesh& mesh, const MotionCertificate& certificate, double dt) {
  const Point middle =
      (mesh.point(mesh.corner(certificate.blocking, 0)) + mesh.point(mesh.corner(certificate.blocking, 1)) +
       mesh.point(mesh.corner(certificate.blocking, 2))) /
      3;
  std::ostringstream text;
  text.precision(6);
  text << "element " << certificate.blocking << " at " << describe_point(middle, place_resolution * mesh.size())
       << " is proved valid only up to " << certificate.fraction << " of a step of " << dt;
  return text.str();
}

std::string failure_note(const Mesh& mesh, const MovedBoundary& moved) {
  const std::string what = moved.status == MovedBoundary::Status::not_finite
                               ? "the velocity is not finite on "
                               : "no spline on the same knots interpolates the moved points of ";
  if (moved.place < 0) return what + "a vertex of the boundary";
  const std::string& name = mesh.boundary().curves[static_cast<std::size_t>(moved.place)].name;
  return what + "curve " + std::to_string(moved.place) + (name.empty() ? "" : " (\"" + name + "\")");
}

/// Refuses a trial with a control point that is nowhere.
void require_finite(const Mesh& mesh, Trial& trial) {
  if (trial.status != Status::done) return;
  const PointId p = find_not_finite(mesh, trial.points);
  if (p == none) return;
  std::ostringstream text;
  text.precision(17);
  text << "the velocity is not finite near control point " << p << " at (" << mesh.point(p).x << ", " << mesh.point(p).y
       << ")";
  trial.status = Status::not_finite;
  trial.note = text.str();
}

void take(Mesh& mesh, Trial trial, double dt) {
  mesh.set_points(std::move(trial.points));
  for (std::size_t c = 0; c < trial.boundary.splines.size(); ++c)
    mesh.set_boundary_motion(static_cast<CurveId>(c), std::move(trial.boundary.splines[c]));
  for (std::size_t v = 0; v < trial.boundary.vertices.size(); ++v)
    mesh.set_boundary_vertex(static_cast<int>(v), trial.boundary.vertices[v]);
  for (const LoneVertex& each : mesh.lone_vertices())  // no curve moves these: they go where the mesh vertex goes
    if (each.point != none) mesh.set_boundary_vertex(each.vertex, mesh.point(each.point));
  mesh.time += dt;
}

/// Why a gap forbids a step that would end at `time`, in words.
std::string contact_note(const Mesh& mesh, const BoundaryGap& gap, double time, const AdvectOptions& options) {
  std::ostringstream text;
  text.precision(6);
  text << (time == mesh.time ? "before the step, at time " : "at time ") << time << " " << describe_gap(mesh, gap)
       << ", less than " << (options.gap == GapPolicy::hold ? "half of " : "") << "the least gap of "
       << mesh.boundary().unit * options.min_gap;
  return text.str();
}

AdvectOutcome step(Mesh& mesh, const MakeTrial& try_step, const AdvectOptions& options) {
  AdvectOutcome outcome{};
  outcome.blocking = none;
  outcome.asked_dt = options.dt;
  const double least = options.min_gap * (options.gap == GapPolicy::hold ? held_share : 1);
  const auto blocked_by = [&](const std::optional<BoundaryGap>& gap, double time) {
    if (!gap) return false;
    outcome.status = Status::contact;
    outcome.report.notes.insert(outcome.report.notes.begin(), contact_note(mesh, *gap, time, options));
    return true;
  };
  if (blocked_by(least_gap(mesh, least), mesh.time)) return outcome;
  double dt = options.dt;
  for (int attempt = 1;; ++attempt) {
    Trial trial = try_step(dt);
    require_finite(mesh, trial);
    if (trial.status != Status::done) {
      outcome.status = trial.status;
      outcome.report.notes.push_back(std::move(trial.note));
      return outcome;
    }
    const MotionCertificate certificate = certify_motion(mesh, trial.points);
    const bool safe = certificate.blocking == none;
    if (attempt == 1) outcome.fraction = certificate.fraction;
    if (!safe) {
      outcome.blocking = certificate.blocking;
      outcome.report.notes.push_back(blocking_note(mesh, certificate, dt));
    }
    if (safe || options.policy == StepPolicy::force) {
      if (blocked_by(least_gap(mesh, trial.points, least), mesh.time + dt)) return outcome;
      outcome.status = dt == options.dt ? Status::done : Status::limited;
      outcome.dt = dt;
      const double displacement = max_displacement(mesh, trial.points);
      const double offset = trial.boundary.area_offset;
      const int held = trial.held;
      take(mesh, std::move(trial), dt);
      outcome.report.add("dt", dt);
      outcome.report.add("time", mesh.time);
      outcome.report.add("safe_fraction", outcome.fraction);
      outcome.report.add("attempts", attempt);
      outcome.report.add_length("max_displacement", displacement);
      outcome.report.add("invalid", safe ? 0.0 : static_cast<double>(count_invalid(mesh)));
      if (options.gap == GapPolicy::hold) outcome.report.add("held", held);
      if (options.keep_area) outcome.report.add_length("area_offset", offset);
      mesh.compact();
      return outcome;
    }
    dt *= limit_margin * certificate.fraction;
    if (options.policy == StepPolicy::refuse || attempt == most_attempts ||
        !(std::abs(dt) >= least_fraction * std::abs(options.dt))) {
      outcome.status = Status::unsafe;
      return outcome;
    }
    if (mesh.time + dt == mesh.time) {
      outcome.status = Status::no_progress;
      return outcome;
    }
  }
}

/// Moves the elements with curves that gaps have held back from the `free` places: the other control points, and less
/// and less those that are farther away, are held back with them.
void move_held_elements(const Mesh& mesh, Trial& trial, const std::vector<Point>& free) {
  trial.points = move_elements(mesh, trial.boundary, [&](std::span<char> known, std::span<double> displacements) {
    std::vector<Vector> corrections(free.size());
    for (std::size_t p = 0; p < free.size(); ++p)
      if (known[p])
        corrections[p] =
            mesh.point(static_cast<PointId>(p)) + Vector{displacements[2 * p], displacements[2 * p + 1]} - free[p];
    spread_corrections(mesh, known, corrections);
    for (std::size_t p = 0; p < free.size(); ++p) {
      if (known[p]) continue;
      const Vector by = free[p] + corrections[p] - mesh.point(static_cast<PointId>(p));
      displacements[2 * p] = by.x;
      displacements[2 * p + 1] = by.y;
    }
  });
}

/// Moves the curves, then the elements by `fill`.
Trial make_trial(const Mesh& mesh, const BoundaryDisplacement& on_boundary, const FillDisplacements& fill,
                 const AdvectOptions& options) {
  Trial trial;
  BoundaryDisplacements displacements = sample_displacements(mesh.boundary(), on_boundary);
  const auto move_boundary = [&] {
    trial.boundary = move_curves(mesh.boundary(), displacements, options.keep_area);
    if (trial.boundary.status == MovedBoundary::Status::done) keep_cusps(mesh, trial.boundary);
    return trial.boundary.status == MovedBoundary::Status::done;
  };
  if (move_boundary()) {
    trial.points = move_elements(mesh, trial.boundary, fill);
    if (options.gap == GapPolicy::stop || !(options.min_gap > 0)) return trial;
    trial.held = hold_gaps(mesh.boundary(), displacements, options.min_gap);
    if (trial.held == 0) return trial;
    if (move_boundary()) {
      const std::vector<Point> free = std::move(trial.points);
      move_held_elements(mesh, trial, free);
      return trial;
    }
  }
  trial.status =
      trial.boundary.status == MovedBoundary::Status::not_finite ? Status::not_finite : Status::not_interpolable;
  trial.note = failure_note(mesh, trial.boundary);
  return trial;
}

/// The mesh moved by the displacements of places. Which places these are, and in which order, does not depend on how
/// they move. (A template, since it is called for every place of the mesh.)
template <class Displace>
Trial displace(const Mesh& mesh, const Displace& displacement, const AdvectOptions& options) {
  const BoundaryComplex& boundary = mesh.boundary();
  const NodeFunction at_node = [&](const Point& place, std::span<double> value) {
    const Vector moved = displacement(place);
    value[0] = moved.x;
    value[1] = moved.y;
  };
  return make_trial(
      mesh,
      {[&](int c, double t) { return displacement(boundary.curves[static_cast<std::size_t>(c)].spline.evaluate(t)); },
       [&](int v) { return displacement(boundary.vertices[static_cast<std::size_t>(v)]); }},
      [&](std::span<char> known, std::span<double> displacements) {
        interpolate_nodes(mesh, none, 2, at_node, known, displacements);
      },
      options);
}

/// The mesh carried by dopri5: all places are collected first, then carried together, then used in the same order.
Trial displace_adaptively(const Mesh& mesh, const VelocityField& velocity, double dt, const AdvectOptions& options) {
  constexpr double default_tolerance = 1e-9;  // of the mesh's size
  std::vector<Point> places;
  const auto collect = [&places](const Point& place) {
    places.push_back(place);
    return Vector{};
  };
  displace(mesh, collect, {});
  AdaptiveMotion motion = carry_adaptively(velocity, places, mesh.time, dt,
                                           options.tolerance ? *options.tolerance : default_tolerance * mesh.size());
  if (!motion.why.empty()) return {Status::too_many_steps, std::move(motion.why)};
  std::size_t next = 0;
  return displace(
      mesh, [&](const Point&) { return motion.moved[next++]; }, options);
}

}  // namespace

AdvectOutcome advect(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options) {
  const auto carried = [&](double dt) -> Trial {
    try {
      if (options.method == TimeMethod::dopri5) return displace_adaptively(mesh, velocity, dt, options);
      return displace(
          mesh,
          [&](const Point& from) { return carry(velocity, from, mesh.time, dt, options.substeps, options.method); },
          options);
    } catch (const NoVelocity& e) {
      return {Status::no_velocity, e.what()};
    }
  };
  return step(mesh, carried, options);
}

AdvectOutcome advect_by_field(Mesh& mesh, int field, const AdvectOptions& options, int acceleration) {
  const auto values = [&mesh](int k) -> std::span<const double> {
    return k == none ? std::span<const double>() : mesh.fields()[static_cast<std::size_t>(k)].values;
  };
  return advect_by_values(mesh, values(field), values(acceleration), options);
}

AdvectOutcome advect_by_values(Mesh& mesh, std::span<const double> velocity_values,
                               std::span<const double> acceleration, const AdvectOptions& options) {
  const CarriedVelocity velocity(mesh, velocity_values);
  std::optional<CarriedVelocity> change;
  if (!acceleration.empty()) change.emplace(mesh, acceleration);
  const auto carried = [&](double dt) {
    const auto moved = [&](const auto& at) {
      const Vector straight = dt * at(velocity);
      return change ? straight + 0.5 * dt * (dt * at(*change)) : straight;
    };
    return make_trial(
        mesh,
        {[&](int c, double t) { return moved([&](const CarriedVelocity& v) { return v.on_curve(c, t); }); },
         [&](int v) { return moved([&](const CarriedVelocity& field_of) { return field_of.at_vertex(v); }); }},
        [&](std::span<char> known, std::span<double> displacements) {
          for (std::size_t p = 0; p < known.size(); ++p) {
            if (known[p]) continue;
            const Vector by = moved([&](const CarriedVelocity& v) { return v.at_point(static_cast<PointId>(p)); });
            displacements[2 * p] = by.x;
            displacements[2 * p + 1] = by.y;
          }
        },
        options);
  };
  return step(mesh, carried, options);
}

}  // namespace pliant
