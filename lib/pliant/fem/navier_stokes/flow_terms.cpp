// lib/pliant/fem/navier_stokes/flow_terms.cpp: sums over the points of an element's rule.
#include "pliant/fem/navier_stokes/flow_terms.h"

#include <algorithm>
#include <cmath>

#include "pliant/fem/element_matrices.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

bool is_constant(const Coefficient& c) { return c.constant().has_value(); }

bool is_zero(const std::array<Coefficient, 2>& force) {
  return force[0].constant() == 0.0 && force[1].constant() == 0.0;
}

}  // namespace

FlowForm choose_form(const FlowProblem& problem, const Mesh& mesh) {
  using Kind = FlowCondition::Kind;
  bool is_one_fluid = true, has_stress = false, has_outflow = false;
  for (const FlowMaterial& material : problem.materials)
    is_one_fluid = is_one_fluid && is_constant(material.viscosity) &&
                   material.viscosity.constant() == problem.materials[0].viscosity.constant();
  for (std::size_t c = 0; c < mesh.boundary().curves.size(); ++c) {
    const int k = problem.condition_of_curve[c];
    const Curve& curve = mesh.boundary().curves[c];
    const bool is_outer = curve.left == outside || curve.right == outside;
    if (problem.tensions[c] || (k == none && is_outer)) has_stress = true;
    if (k == none) continue;
    const Kind kind = problem.conditions[index(k)].kind;
    if (kind == Kind::slip || kind == Kind::traction) has_stress = true;
    if (kind == Kind::outflow) has_outflow = true;
  }
  const bool is_stress = has_stress || !is_one_fluid;
  return {is_stress, !is_stress || !has_outflow};
}

FlowElement::FlowElement(const FlowProblem& problem, const Mesh& mesh, const FlowForm& form, int pressure_degree)
    : problem_(problem),
      mesh_(mesh),
      form_(form),
      unit_(mesh.boundary().unit),
      n_(mesh.net_size()),
      m_(net_size(pressure_degree)),
      size_(2 * n_ + m_),
      has_force_(!is_zero(problem.force) || !is_zero(problem.gravity)),
      map_(mesh.degree()),
      edge_(mesh.degree()),
      pressure_degree_(pressure_degree) {
  const auto varies = [](const std::array<Coefficient, 2>& force) {
    return !is_constant(force[0]) || !is_constant(force[1]);
  };
  const bool forces_vary = varies(problem.force) || varies(problem.gravity);
  for (const FlowMaterial& material : problem.materials)
    varying_.push_back(forces_vary || !is_constant(material.density) || !is_constant(material.viscosity));
  const std::size_t n = index(n_), size = index(size_);
  matrix_.resize(size * size);
  load_.resize(size);
  along_x_.resize(n * index(m_));
  along_y_.resize(n * index(m_));
  for (auto* each : {&xx_, &xy_, &yx_, &yy_}) each->resize(n * n);
  gx_.resize(n);
  gy_.resize(n);
}

double FlowElement::value(const Coefficient& coefficient, int q) const {
  if (coefficient.constant()) return *coefficient.constant();
  return evaluate_at(coefficient, {mesh_, triangle_, map_.table().xi[index(q)], unit_ * map_.place(q), time_});
}

double FlowElement::checked(const Coefficient& coefficient, int q, bool may_be_zero) const {
  const double it = value(coefficient, q);
  if (!(it > 0) && !(may_be_zero && it == 0))
    refuse_value(coefficient, it, unit_ * map_.place(q), time_, may_be_zero ? "at least 0" : "positive");
  return it;
}

void FlowElement::evaluate_materials() {
  const FlowMaterial& material = problem_.materials[index(mesh_.face(triangle_))];
  density_.resize(index(map_.points()));
  viscosity_.resize(index(map_.points()));
  for (int q = 0; q < map_.points(); ++q) {
    density_[index(q)] = checked(material.density, q, true);
    viscosity_[index(q)] = checked(material.viscosity, q, false) / (unit_ * unit_);
  }
}

void FlowElement::set(std::span<const Point> points, double time, TriangleId t, const FlowTerms& terms) {
  points_ = points;
  triangle_ = t;
  time_ = time;
  // Convection is a product of three functions.
  const bool varies = varying_[index(mesh_.face(t))] != 0 || !terms.convecting.empty();
  map_.set(mesh_, points, t, varies ? Integrand::varying : Integrand::constant);
  std::ranges::fill(matrix_, 0.0);
  std::ranges::fill(load_, 0.0);
  evaluate_materials();
  add_volume(terms);
  add_pressure();
  if (!terms.projects) add_edges(terms);
}

void FlowElement::add_volume(const FlowTerms& terms) {
  const std::size_t n = index(n_);
  const bool couples = form_.is_stress || terms.newton;  // the components
  for (auto* each : {&xx_, &xy_, &yx_, &yy_}) std::ranges::fill(*each, 0.0);
  const auto net = mesh_.net(triangle_);
  for (int q = 0; q < map_.points(); ++q) {
    const Vector to_2 = map_.along_2(q), to_3 = map_.along_3(q);
    const double det = map_.det(q), measure = map_.measure(q), density = density_[index(q)];
    const auto b = map_.table().values_at(q), d2 = map_.table().along_2_at(q), d3 = map_.table().along_3_at(q);
    for (std::size_t i = 0; i < n; ++i) {
      gx_[i] = (d2[i] * to_3.y - d3[i] * to_2.y) / det;
      gy_[i] = (d3[i] * to_2.x - d2[i] * to_3.x) / det;
    }
    // What acts on the fluid here, and velocities with their gradients.
    Vector load, history, convecting, along_x, along_y;
    const auto sum = [&](std::span<const double> field, Vector& value) {
      for (std::size_t i = 0; i < n; ++i)
        value += b[i] * Vector{field[2 * index(net[i])], field[2 * index(net[i]) + 1]};
    };
    if (!terms.history.empty()) sum(terms.history, history);
    if (!terms.convecting.empty()) sum(terms.convecting, convecting);
    if (terms.newton)
      for (std::size_t i = 0; i < n; ++i) {
        const Vector u{terms.convecting[2 * index(net[i])], terms.convecting[2 * index(net[i]) + 1]};
        along_x += gx_[i] * u;
        along_y += gy_[i] * u;
      }
    const double weight = terms.projects ? std::max(density, terms.least_weight) : density;
    const double inertia = measure * weight, convection = inertia * terms.convection / unit_;
    load = inertia * history;
    if (has_force_ && !terms.projects) {
      load += inertia * Vector{value(problem_.gravity[0], q), value(problem_.gravity[1], q)};
      load += measure * Vector{value(problem_.force[0], q), value(problem_.force[1], q)};
    }
    if (terms.newton) load += convection * (convecting.x * along_x + convecting.y * along_y);
    for (std::size_t i = 0; i < n; ++i) {
      load_[i] += b[i] * load.x;
      load_[n + i] += b[i] * load.y;
    }

    const double mass = terms.projects ? inertia : inertia * terms.inertia;
    const double viscous = terms.projects ? 0 : measure * viscosity_[index(q)];
    const double stress = form_.is_stress ? viscous : 0;
    const Vector carried = convection * convecting;
    for (std::size_t i = 0; i < n; ++i) {
      double* const xx = xx_.data() + i * n;
      double* const xy = xy_.data() + i * n;
      double* const yx = yx_.data() + i * n;
      double* const yy = yy_.data() + i * n;
      const double ax = viscous * gx_[i] + b[i] * carried.x, ay = viscous * gy_[i] + b[i] * carried.y;
      const double mb = mass * b[i], sx = stress * gx_[i], sy = stress * gy_[i];
      if (!couples) {
        for (std::size_t j = 0; j < n; ++j) xx[j] += mb * b[j] + ax * gx_[j] + ay * gy_[j];
        continue;
      }
      const double change = terms.newton ? b[i] * convection : 0;
      const Vector by_x = change * along_x, by_y = change * along_y;
      for (std::size_t j = 0; j < n; ++j) {
        const double both = mb * b[j] + ax * gx_[j] + ay * gy_[j];
        xx[j] += both + sx * gx_[j] + by_x.x * b[j];
        xy[j] += sy * gx_[j] + by_y.x * b[j];
        yx[j] += sx * gy_[j] + by_x.y * b[j];
        yy[j] += both + sy * gy_[j] + by_y.y * b[j];
      }
    }
  }
  for (int i = 0; i < n_; ++i)
    for (int j = 0; j < n_; ++j) {
      const std::size_t k = index(i * n_ + j);
      entry(i, j) = xx_[k];
      entry(n_ + i, n_ + j) = couples ? yy_[k] : xx_[k];
      if (!couples) continue;
      entry(i, n_ + j) = xy_[k];
      entry(n_ + i, j) = yx_[k];
    }
}

void FlowElement::add_pressure() {
  element_divergence(map_, pressure_degree_, along_x_, along_y_);
  for (int i = 0; i < m_; ++i)
    for (int j = 0; j < n_; ++j) {
      const std::size_t k = index(i * n_ + j);
      entry(2 * n_ + i, j) = entry(j, 2 * n_ + i) = -along_x_[k];
      entry(2 * n_ + i, n_ + j) = entry(n_ + j, 2 * n_ + i) = -along_y_[k];
    }
}

void FlowElement::residual(std::span<const double> x, std::span<double> r) const {
  for (std::size_t i = 0; i < index(size_); ++i) {
    r[i] = load_[i];
    for (std::size_t j = 0; j < index(size_); ++j) r[i] -= matrix_[i * index(size_) + j] * x[j];
  }
}

}  // namespace pliant
