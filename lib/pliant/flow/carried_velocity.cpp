// lib/pliant/flow/carried_velocity.cpp: finds the edge of each span, and evaluates the field along it.
#include "pliant/flow/carried_velocity.h"

#include <algorithm>
#include <array>

#include "pliant/geometry/control_net.h"

namespace pliant {

CarriedVelocity::CarriedVelocity(const Mesh& mesh, int field)
    : CarriedVelocity(mesh, mesh.fields()[static_cast<std::size_t>(field)].values) {}

CarriedVelocity::CarriedVelocity(const Mesh& mesh, std::span<const double> values) : mesh_(mesh), values_(values) {
  const BoundaryComplex& boundary = mesh.boundary();
  for (const Curve& curve : boundary.curves) {
    breaks_.push_back(curve.spline.breaks());
    spans_.emplace_back(breaks_.back().size() - 1, none);
  }
  vertices_.assign(boundary.vertices.size(), none);
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h)) continue;
    const ConstraintId constraint = mesh.constraint(h);
    const CurveId c = mesh.constraint_curve(constraint);
    const Curve& curve = boundary.curves[static_cast<std::size_t>(c)];
    const std::size_t span = span_at(c, mesh.constraint_start(constraint));
    spans_[static_cast<std::size_t>(c)][span] = h;
    if (curve.spline.closed()) continue;
    const bool forward = mesh.runs_forward(h);
    if (span == 0) vertices_[static_cast<std::size_t>(curve.start)] = forward ? mesh.origin(h) : mesh.target(h);
    if (span + 1 == spans_[static_cast<std::size_t>(c)].size())
      vertices_[static_cast<std::size_t>(curve.end)] = forward ? mesh.target(h) : mesh.origin(h);
  }
}

Vector CarriedVelocity::at_point(PointId p) const {
  const std::size_t i = 2 * static_cast<std::size_t>(p);
  const double unit = mesh_.boundary().unit;
  return {values_[i] / unit, values_[i + 1] / unit};
}

Vector CarriedVelocity::at_vertex(int v) const {
  const PointId p = vertices_[static_cast<std::size_t>(v)];
  return p == none ? Vector{} : at_point(p);  // no curve ends at this vertex, so none needs its velocity
}

std::size_t CarriedVelocity::span_at(CurveId c, double t) const {
  const std::vector<double>& breaks = breaks_[static_cast<std::size_t>(c)];
  if (t >= breaks.back()) return mesh_.spline(c).closed() ? 0 : breaks.size() - 2;
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
  return static_cast<std::size_t>(after - breaks.begin()) - 1;
}

Vector CarriedVelocity::on_curve(CurveId c, double t) const {
  const std::vector<double>& breaks = breaks_[static_cast<std::size_t>(c)];
  const std::size_t span = span_at(c, t);
  const HalfEdgeId h = spans_[static_cast<std::size_t>(c)][span];
  const double t0 = breaks[span], t1 = breaks[span + 1];
  const double s = std::clamp(((t >= t1 && span == 0 && mesh_.spline(c).closed() ? t0 : t) - t0) / (t1 - t0), 0.0, 1.0);
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
