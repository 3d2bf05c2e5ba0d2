// lib/pliant/fem/measures/mesh_function.cpp: evaluates fields and expressions in elements.
#include "pliant/fem/measures/mesh_function.h"

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "pliant/boundary/fault.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"

namespace pliant {

MeshFunction::MeshFunction(const Mesh& mesh, int field, int component)
    : mesh_(&mesh), field_(field), component_(component), values_(index(mesh.net_size())) {
  assert(component < mesh.fields()[index(field)].components);
}

MeshFunction::MeshFunction(const Mesh& mesh, Coefficient coefficient)
    : mesh_(&mesh), coefficient_(std::move(coefficient)) {}

void MeshFunction::set(TriangleId t) {
  triangle_ = t;
  if (coefficient_) return;
  const Field& field = mesh_->fields()[index(field_)];
  std::size_t k = 0;
  for (const PointId p : mesh_->net(t))
    values_[k++] = field.values[index(mesh_->value_index(field_, p, mesh_->face(t)) + component_)];
}

double MeshFunction::at(const Barycentric& xi, std::span<const double> basis) const {
  if (!coefficient_) {
    double value = 0;
    for (std::size_t k = 0; k < values_.size(); ++k) value += basis[k] * values_[k];
    return value;
  }
  Point place;
  std::size_t k = 0;
  for (const PointId p : mesh_->net(triangle_)) place += basis[k++] * mesh_->point(p);
  place *= mesh_->boundary().unit;
  const double value = (*coefficient_)({*mesh_, triangle_, xi, place, mesh_->time});
  if (!std::isfinite(value))
    throw InputError("", coefficient_->name() + " is not finite at " +
                             describe_point(place, place_resolution * mesh_->boundary().unit * mesh_->size()) +
                             " and time " + describe_number(mesh_->time));
  return value;
}

double MeshFunction::at(const Barycentric& xi) const {
  std::array<double, net_size(max_degree)> basis;
  const auto used = std::span(basis).first(index(mesh_->net_size()));
  bernstein_basis(mesh_->degree(), xi, used);
  return at(xi, used);
}

}  // namespace pliant
