// lib/pliant/fem/navier_stokes/edge_terms.cpp: outflow, traction and surface tension on the edges of one element.
#include <algorithm>
#include <cmath>

#include "pliant/fem/navier_stokes/flow_terms.h"
#include "pliant/geometry/index.h"

namespace pliant {

using Kind = FlowCondition::Kind;

void FlowElement::add_edges(const FlowTerms& terms) {
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(triangle_, e);
    if (!mesh_.is_constrained(h)) continue;
    const CurveId c = mesh_.constraint_curve(mesh_.constraint(h));
    const int k = problem_.condition_of_curve[index(c)];
    if (k != none && mesh_.twin(h) == none) {
      const FlowCondition& condition = problem_.conditions[index(k)];
      if (condition.kind == Kind::outflow) add_outflow(h, terms);
      if (condition.kind == Kind::traction) add_traction(h, condition);
    }
    // An edge with two triangles pulls once.
    if (problem_.tensions[index(c)] && (mesh_.runs_forward(h) || mesh_.twin(h) == none))
      add_tension(h, *problem_.tensions[index(c)], terms);
  }
}

double FlowElement::edge_value(HalfEdgeId h, const Coefficient& coefficient, int q, bool may_be_negative) const {
  const double it = coefficient.constant()
                        ? *coefficient.constant()
                        : evaluate_at(coefficient, {mesh_, triangle_of(h), edge_.xi(q), unit_ * edge_.place(q), time_});
  if (!may_be_negative && it < 0) refuse_value(coefficient, it, unit_ * edge_.place(q), time_, "at least 0");
  return it;
}

Vector FlowElement::at_edge(HalfEdgeId h, std::span<const double> field, int q) const {
  Vector value;
  const auto b = edge_.values_at(q);
  for (int k = 0; k <= mesh_.degree(); ++k) {
    const std::size_t at = 2 * index(mesh_.edge_point(h, k));
    value += b[index(k)] * Vector{field[at], field[at + 1]};
  }
  return value;
}

void FlowElement::add_outflow(HalfEdgeId h, const FlowTerms& terms) {
  edge_.set(mesh_, points_, h);
  const FlowMaterial& material = problem_.materials[index(mesh_.face(triangle_))];
  const int n = mesh_.degree() + 1;
  const auto local = [&](int k) { return mesh_.layout().edge_index(edge_of(h), k); };
  for (int q = 0; q < edge_.points(); ++q) {
    const auto b = edge_.values_at(q), db = edge_.derivatives_at(q);
    // What flows in brings no energy: half of what convection would bring of momentum is taken away.
    double inflow = 0;
    if (!terms.convecting.empty()) {
      const Vector outward = edge_.weight(q) * Vector{edge_.along(q).y, -edge_.along(q).x};
      inflow = -std::min(dot(at_edge(h, terms.convecting, q), outward), 0.0);
      inflow *= 0.5 * terms.convection * edge_value(h, material.density, q, false) / unit_;
    }
    // The stress without viscosity (grad u)^T n. As div u = 0, that is viscosity (du/ds turned back by a right angle),
    // along the boundary: of the velocity inside nothing is needed.
    const double turned =
        form_.is_stress ? edge_.weight(q) * edge_value(h, material.viscosity, q, false) / (unit_ * unit_) : 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double back = inflow * b[index(i)] * b[index(j)], along = turned * b[index(i)] * db[index(j)];
        entry(local(i), local(j)) += back;
        entry(n_ + local(i), n_ + local(j)) += back;
        entry(local(i), n_ + local(j)) += along;
        entry(n_ + local(i), local(j)) -= along;
      }
  }
}

void FlowElement::add_traction(HalfEdgeId h, const FlowCondition& condition) {
  edge_.set(mesh_, points_, h);
  for (int q = 0; q < edge_.points(); ++q) {
    const Vector stress{edge_value(h, condition.first, q, true), edge_value(h, condition.second, q, true)};
    const Vector load = (edge_.measure(q) / unit_) * stress;
    for (int k = 0; k <= mesh_.degree(); ++k) {
      const int i = mesh_.layout().edge_index(edge_of(h), k);
      load_[index(i)] += edge_.values_at(q)[index(k)] * load.x;
      load_[index(n_ + i)] += edge_.values_at(q)[index(k)] * load.y;
    }
  }
}

void FlowElement::add_tension(HalfEdgeId h, const Coefficient& tension, const FlowTerms& terms) {
  edge_.set(mesh_, points_, h);
  const int n = mesh_.degree() + 1;
  const auto local = [&](int k) { return mesh_.layout().edge_index(edge_of(h), k); };
  for (int q = 0; q < edge_.points(); ++q) {
    const double length_of_unit = length(edge_.along(q));
    const double pull = edge_.weight(q) * edge_value(h, tension, q, false) / (unit_ * unit_ * length_of_unit);
    const double later = pull * terms.tension_time / unit_;
    const auto db = edge_.derivatives_at(q);
    // d/ds of the place, and of the velocity before that the implicit part is relative to.
    Vector along = pull * edge_.along(q);
    if (later != 0)
      for (int k = 0; k < n; ++k) {
        const std::size_t at = 2 * index(mesh_.edge_point(h, k));
        along -= later * db[index(k)] * Vector{terms.before[at], terms.before[at + 1]};
      }
    for (int i = 0; i < n; ++i) {
      load_[index(local(i))] -= db[index(i)] * along.x;
      load_[index(n_ + local(i))] -= db[index(i)] * along.y;
      for (int j = 0; j < n; ++j) {
        const double held = later * db[index(i)] * db[index(j)];
        entry(local(i), local(j)) += held;
        entry(n_ + local(i), n_ + local(j)) += held;
      }
    }
  }
}

}  // namespace pliant
