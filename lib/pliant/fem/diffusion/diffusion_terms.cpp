// lib/pliant/fem/diffusion/diffusion_terms.cpp: evaluates coefficients at quadrature points and sums.
#include "pliant/fem/diffusion/diffusion_terms.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

bool is_constant(const DiffusionMaterial& material) {
  const auto constant = [](const Coefficient& c) { return c.constant().has_value(); };
  return std::ranges::all_of(material.diffusivity, constant) && constant(material.capacity) &&
         (!material.source || constant(*material.source));
}

}  // namespace

ElementTerms::ElementTerms(const DiffusionProblem& problem, const Mesh& mesh)
    : problem_(problem), mesh_(mesh), unit_(mesh.boundary().unit), map_(mesh.degree()) {
  const std::size_t n = index(mesh.net_size());
  const bool moving = std::ranges::any_of(problem.convection, [](const auto& c) { return !c.constant(); });
  for (const DiffusionMaterial& material : problem.materials) varying_.push_back(moving || !is_constant(material));
  mass_.resize(n * (n + 1) / 2);
  diffusion_.resize(n * (n + 1) / 2);
  load_.resize(n);
  product_.resize(n);
  if (!problem.convection.empty()) convection_.resize(n * n);
}

void ElementTerms::refuse(const Coefficient& coefficient, double value, int q, const char* what) const {
  refuse_value(coefficient, value, unit_ * map_.place(q), time_, what);
}

double ElementTerms::value(const Coefficient& coefficient, int q) const {
  if (coefficient.constant()) return *coefficient.constant();
  const double value = coefficient({mesh_, triangle_, map_.table().xi[index(q)], unit_ * map_.place(q), time_});
  if (!std::isfinite(value)) refuse(coefficient, value, q, "a finite number");
  return value;
}

double ElementTerms::positive(const Coefficient& coefficient, int q) const {
  const double it = value(coefficient, q);
  if (!(it > 0)) refuse(coefficient, it, q, "positive");
  return it;
}

SymmetricTensor ElementTerms::tensor(const DiffusionMaterial& material, int q) const {
  const double scale = 1 / (unit_ * unit_);
  if (material.diffusivity.size() == 1) {
    const double k = positive(material.diffusivity[0], q) * scale;
    return {k, 0, k};
  }
  const double xx = positive(material.diffusivity[0], q), xy = value(material.diffusivity[1], q);
  const double yy = positive(material.diffusivity[2], q);
  if (!(xx * yy - xy * xy > 0)) refuse(material.diffusivity[1], xy, q, "so small that the tensor is positive definite");
  return {xx * scale, xy * scale, yy * scale};
}

void ElementTerms::set(const Configuration& at, TriangleId t) {
  const DiffusionMaterial& material = problem_.materials[index(mesh_.face(t))];
  triangle_ = t;
  time_ = at.time;
  map_.set(mesh_, at.points, t, varying_[index(mesh_.face(t))] ? Integrand::varying : Integrand::constant);
  const std::size_t m = index(map_.points());
  factors_.resize(m);
  tensors_.resize(m);
  for (int q = 0; q < map_.points(); ++q) {
    factors_[index(q)] = positive(material.capacity, q);
    tensors_[index(q)] = tensor(material, q);
  }
  element_mass(map_, factors_, mass_);
  element_stiffness(map_, tensors_, diffusion_);
  if (!convection_.empty()) {
    velocities_.resize(m);
    for (int q = 0; q < map_.points(); ++q)
      velocities_[index(q)] =
          (factors_[index(q)] / unit_) * Vector{value(problem_.convection[0], q), value(problem_.convection[1], q)};
    element_convection(map_, velocities_, convection_);
  }
  if (material.source) {
    for (int q = 0; q < map_.points(); ++q) factors_[index(q)] = value(*material.source, q);
    element_load(map_, factors_, load_);
  } else {
    std::ranges::fill(load_, 0.0);
  }
}

void ElementTerms::apply(std::span<const double> x, std::span<double> amount, std::span<double> rate) {
  multiply_pairs(mass_, x, amount);
  multiply_pairs(diffusion_, x, product_);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < convection_.size() / x.size(); ++j) product_[i] += convection_[i * x.size() + j] * x[j];
    rate[i] = load_[i] - product_[i];
  }
}

EdgeTerms::EdgeTerms(const Mesh& mesh) : mesh_(mesh), unit_(mesh.boundary().unit), map_(mesh.degree()) {
  const std::size_t n = index(mesh.degree()) + 1;
  load_.resize(n);
  lengths_.resize(n);
  stiffness_.resize(n * n);
}

double EdgeTerms::value(const Coefficient& coefficient, int q, bool may_be_negative) const {
  const double value = coefficient.constant()
                           ? *coefficient.constant()
                           : coefficient({mesh_, triangle_of(half_edge_), map_.xi(q), unit_ * map_.place(q), time_});
  if (!std::isfinite(value)) refuse_value(coefficient, value, unit_ * map_.place(q), time_, "a finite number");
  if (!may_be_negative && value < 0) refuse_value(coefficient, value, unit_ * map_.place(q), time_, "at least 0");
  return value;
}

void EdgeTerms::set(const Configuration& at, HalfEdgeId h, const DiffusionCondition& condition) {
  using Kind = DiffusionCondition::Kind;
  half_edge_ = h;
  time_ = at.time;
  map_.set(mesh_, at.points, h);
  std::ranges::fill(load_, 0.0);
  std::ranges::fill(lengths_, 0.0);
  std::ranges::fill(stiffness_, 0.0);
  const std::size_t n = load_.size();
  for (int q = 0; q < map_.points(); ++q) {
    const auto b = map_.values_at(q);
    const double measure = map_.measure(q);
    double enters = 0, transfer = 0;
    if (condition.kind == Kind::flux) {
      enters = value(condition.first, q, true);
    } else if (condition.kind == Kind::robin) {
      transfer = value(condition.first, q, false);
      enters = transfer * value(condition.second, q, true);
    } else if (condition.kind == Kind::jump) {
      transfer = value(condition.first, q, false);
    }
    enters *= measure / unit_;
    transfer *= measure / unit_;
    for (std::size_t i = 0; i < n; ++i) {
      lengths_[i] += measure * b[i];
      load_[i] += enters * b[i];
      for (std::size_t j = 0; j < n; ++j) stiffness_[i * n + j] += transfer * b[i] * b[j];
    }
  }
}

}  // namespace pliant
