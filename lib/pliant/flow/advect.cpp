// lib/pliant/flow/advect.cpp: tries a step, certifies it, and takes it, or a smaller one, or none.
#include "pliant/flow/advect.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "pliant/flow/carried_velocity.h"
#include "pliant/flow/move_elements.h"
#include "pliant/flow/runge_kutta.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/validity/swept_validity.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

constexpr int most_attempts = 20;        // so often a step is made smaller
constexpr double least_fraction = 1e-6;  // a smaller part of the asked step is not worth taking
constexpr double limit_margin = 0.9;     // this part of the safe fraction is tried next

/// The mesh after a step of length dt, not yet taken.
struct Trial {
  MovedBoundary boundary;
  std::vector<Point> points;
};
using MakeTrial = std::function<Trial(double dt)>;

/// The fraction of a motion that is proved to keep every element valid, and the element that limits it.
struct Certificate {
  double fraction = 1;
  TriangleId blocking = none;
};

Certificate certify_motion(const Mesh& mesh, const std::vector<Point>& points) {
  Certificate result;
  std::vector<Point> from(static_cast<std::size_t>(mesh.net_size()));
  std::vector<Point> to(from.size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, from);
    const auto net = mesh.net(t);
    for (std::size_t i = 0; i < net.size(); ++i) to[i] = points[static_cast<std::size_t>(net[i])];
    const double fraction = safe_fraction(mesh.degree(), from, to);
    if (fraction < result.fraction) result = {fraction, t};
  }
  return result;
}

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

long count_invalid(const Mesh& mesh) {
  long count = 0;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    if (certify(mesh.degree(), net) != Validity::valid) ++count;
  }
  return count;
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

std::string blocking_note(const Mesh& mesh, const Certificate& certificate, double dt) {
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

AdvectOutcome step(Mesh& mesh, const MakeTrial& make_trial, const AdvectOptions& options) {
  using Status = AdvectOutcome::Status;
  AdvectOutcome outcome{};
  outcome.blocking = none;
  outcome.asked_dt = options.dt;
  double dt = options.dt;
  for (int attempt = 1;; ++attempt) {
    Trial trial = make_trial(dt);
    if (trial.boundary.status != MovedBoundary::Status::done) {
      outcome.status =
          trial.boundary.status == MovedBoundary::Status::not_finite ? Status::not_finite : Status::not_interpolable;
      outcome.report.notes.push_back(failure_note(mesh, trial.boundary));
      return outcome;
    }
    if (const PointId p = find_not_finite(mesh, trial.points); p != none) {
      std::ostringstream text;
      text.precision(17);
      text << "the velocity is not finite near control point " << p << " at (" << mesh.point(p).x << ", "
           << mesh.point(p).y << ")";
      outcome.status = Status::not_finite;
      outcome.report.notes.push_back(text.str());
      return outcome;
    }
    const Certificate certificate = certify_motion(mesh, trial.points);
    const bool safe = certificate.blocking == none;
    if (attempt == 1) outcome.fraction = certificate.fraction;
    if (!safe) {
      outcome.blocking = certificate.blocking;
      outcome.report.notes.push_back(blocking_note(mesh, certificate, dt));
    }
    if (safe || options.policy == StepPolicy::force) {
      outcome.status = dt == options.dt ? Status::done : Status::limited;
      outcome.dt = dt;
      const double displacement = max_displacement(mesh, trial.points);
      const double offset = trial.boundary.area_offset;
      take(mesh, std::move(trial), dt);
      outcome.report.add("dt", dt);
      outcome.report.add("time", mesh.time);
      outcome.report.add("safe_fraction", outcome.fraction);
      outcome.report.add("attempts", attempt);
      outcome.report.add_length("max_displacement", displacement);
      outcome.report.add("invalid", safe ? 0.0 : static_cast<double>(count_invalid(mesh)));
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

}  // namespace

AdvectOutcome advect(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options) {
  const BoundaryComplex& boundary = mesh.boundary();
  const auto make_trial = [&](double dt) {
    const auto displacement = [&](const Point& from) { return carry(velocity, from, mesh.time, dt, options.substeps); };
    Trial trial;
    trial.boundary = move_curves(
        boundary,
        {[&](int c, double t) { return displacement(boundary.curves[static_cast<std::size_t>(c)].spline.evaluate(t)); },
         [&](int v) { return displacement(boundary.vertices[static_cast<std::size_t>(v)]); }},
        options.keep_area);
    if (trial.boundary.status != MovedBoundary::Status::done) return trial;
    const NodeFunction at_node = [&](const Point& place, std::span<double> value) {
      const Vector moved = displacement(place);
      value[0] = moved.x;
      value[1] = moved.y;
    };
    trial.points = move_elements(mesh, trial.boundary, [&](std::span<char> known, std::span<double> displacements) {
      interpolate_nodes(mesh, none, 2, at_node, known, displacements);
    });
    return trial;
  };
  return step(mesh, make_trial, options);
}

AdvectOutcome advect_by_field(Mesh& mesh, int field, const AdvectOptions& options) {
  const CarriedVelocity velocity(mesh, field);
  const auto make_trial = [&](double dt) {
    Trial trial;
    trial.boundary = move_curves(mesh.boundary(),
                                 {[&](int c, double t) { return dt * velocity.on_curve(c, t); },
                                  [&](int v) { return dt * velocity.at_vertex(v); }},
                                 options.keep_area);
    if (trial.boundary.status != MovedBoundary::Status::done) return trial;
    trial.points = move_elements(mesh, trial.boundary, [&](std::span<char> known, std::span<double> displacements) {
      for (std::size_t p = 0; p < known.size(); ++p) {
        if (known[p]) continue;
        const Vector moved = dt * velocity.at_point(static_cast<PointId>(p));
        displacements[2 * p] = moved.x;
        displacements[2 * p + 1] = moved.y;
      }
    });
    return trial;
  };
  return step(mesh, make_trial, options);
}

}  // namespace pliant
