// lib/pliant/fem/element_values.cpp: gathers and puts values element by element.
#include "pliant/fem/element_values.h"

#include <cassert>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {

std::vector<double> element_values(const Mesh& mesh, int field, int component) {
  const Field& from = mesh.fields()[index(field)];
  const std::size_t components = index(from.components), c = index(component);
  std::vector<double> values;
  values.reserve(index(mesh.triangle_slots()) * index(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) {
      const std::size_t at = from.by_face ? index(mesh.value_index(field, p, mesh.face(t))) : index(p) * components;
      values.push_back(from.values[at + c]);
    }
  return values;
}

std::vector<double> element_values(const Space& space, std::span<const double> unknowns) {
  std::vector<double> values;
  values.reserve(space.unknowns().size());
  for (const int i : space.unknowns()) values.push_back(unknowns[index(i)]);
  return values;
}

std::vector<double> unknowns_of(const Space& space, std::span<const double> element_values) {
  assert(element_values.size() == space.unknowns().size());
  std::vector<double> unknowns(index(space.size()));
  for (std::size_t k = element_values.size(); k-- > 0;) unknowns[index(space.unknowns()[k])] = element_values[k];
  return unknowns;
}

std::vector<double> elevated_values(const Space& space, std::span<const double> unknowns, int degree) {
  std::vector<double> values = element_values(space, unknowns), higher;
  for (int q = space.degree(); q < degree; ++q) {
    const std::size_t from = index(net_size(q)), to = index(net_size(q + 1));
    higher.resize(values.size() / from * to);
    for (std::size_t t = 0; t < values.size() / from; ++t)
      elevate_net(q, 1, std::span(values).subspan(t * from, from), std::span(higher).subspan(t * to, to));
    values.swap(higher);
  }
  return values;
}

std::vector<double> restricted_unknowns(const Space& space, std::span<const double> element_values, int degree) {
  const int q = space.degree();
  const NetLayout& layout = NetLayout::of(q);
  const std::size_t from = index(net_size(degree)), to = index(layout.size());
  std::vector<double> values(element_values.size() / from * to), polygon(index(q) + 1);
  for (std::size_t t = 0; t < element_values.size() / from; ++t) {
    const auto net = std::span(values).subspan(t * to, to);
    for (int k = 0; k < layout.size(); ++k) {
      Barycentric xi{};
      for (std::size_t c = 0; c < 3; ++c) xi[c] = static_cast<double>(layout.exponents(k)[c]) / q;
      evaluate_net(degree, 1, element_values.subspan(t * from, from), xi, net.subspan(index(k), 1));
    }
    for (int e = 0; e < 3; ++e) {
      for (int k = 0; k <= q; ++k) polygon[index(k)] = net[index(layout.edge_index(e, k))];
      interpolate_polygon(q, 1, polygon);
      for (int k = 1; k < q; ++k) net[index(layout.edge_index(e, k))] = polygon[index(k)];
    }
    if (q > 2) interpolate_interior(q, 1, net);
  }
  return unknowns_of(space, values);
}

Field with_unknowns(const Mesh& mesh, int field, const Space& space, std::span<const double> unknowns) {
  Field to = mesh.fields()[index(field)];
  assert(to.components == 1 && space.degree() == mesh.degree());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    std::size_t k = 0;
    for (const PointId p : mesh.net(t)) {
      const std::size_t at = to.by_face ? index(mesh.value_index(field, p, mesh.face(t))) : index(p);
      to.values[at] = unknowns[index(space.of(t)[k++])];
    }
  }
  return to;
}

}  // namespace pliant
