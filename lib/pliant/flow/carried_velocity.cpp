#include "pliant/flow/carried_velocity.h"  // lib/pliant/flow/carried_velocity.cpp

#include <algorithm>
#include <array>

#include "pliant/geometry/control_net.h"

namespace pliant {

CarriedVelocity::CarriedVelocity(const Mesh& mesh, int field)
    : mesh_(mesh), field_(mesh.fields()[static_cast<std::size_t>(field)]) {
  const BoundaryComplex& boundary = mesh.boundary();
  for (const Curve& curve : boundary.curves)
    spans_.emplace_back(static_cast<std::size_t>(curve.spline.span_count()), none);
  vertices_.assign(boundary.vertices.size(), none);
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h)) continue;
    const ConstraintId constraint = mesh.constraint(h);
    const CurveId c = mesh.constraint_curve(constraint);
    const Curve& curve = boundary.curves[static_cast<std::size_t>(c)];
    const int span = curve.spline.span_at(mesh.constraint_start(constraint));
    spans_[static_cast<std::size_t>(c)][static_cast<std::size_t>(span)] = h;
    if (curve.spline.closed()) continue;
    const bool forward = mesh.runs_forward(h);
    if (span == 0) vertices_[static_cast<std::size_t>(curve.start)] = forward ? mesh.origin(h) : mesh.target(h);
    if (span == curve.spline.span_count() - 1)
      vertices_[static_cast<std::size_t>(curve.end)] = forward ? mesh.target(h) : mesh.origin(h);
  }
}

Vector CarriedVelocity::at_point(PointId p) const {
  const std::size_t i = 2 * static_cast<std::size_t>(p);
  const double unit = mesh_.boundary().unit;
  return {field_.values[i] / unit, field_.values[i + 1] / unit};
}

Vector CarriedVelocity::at_vertex(int v) const {
  const PointId p = vertices_[static_cast<std::size_t>(v)];
  return p == none ? Vector{} : at_point(p);  // a vertex without a curve carries nothing
}

Vector CarriedVelocity::on_curve(CurveId c, double t) const {
  const BSpline& spline = mesh_.spline(c);
  const int span = spline.span_at(t);
  const HalfEdgeId h = spans_[static_cast<std::size_t>(c)][static_cast<std::size_t>(span)];
  const double t0 = mesh_.constraint_start(mesh_.constraint(h));
  const double s = std::clamp((t - t0) / (spline.span_end(t0) - t0), 0.0, 1.0);
  std::array<double, 2 * (max_degree + 1)> polygon;
  const int degree = mesh_.degree();
  for (int k = 0; k <= degree; ++k) {
    const Vector v = at_point(mesh_.edge_point(h, k));
    polygon[2 * static_cast<std::size_t>(k)] = v.x;
    polygon[2 * static_cast<std::size_t>(k) + 1] = v.y;
  }
  std::array<double, 2> value;
  evaluate_polygon(degree, 2, std::span(polygon).first(2 * static_cast<std::size_t>(degree + 1)),
                   mesh_.runs_forward(h) ? s : 1 - s, value);
  return {value[0], value[1]};
}

}  // namespace pliant
