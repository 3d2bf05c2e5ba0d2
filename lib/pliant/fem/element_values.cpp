// lib/pliant/fem/element_values.cpp: gathers and puts values element by element.
#include "pliant/fem/element_values.h"

#include <cassert>

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
