// lib/pliant/fem/diffusion/diffusion_values.cpp: given and initial values, and whether they determine a solution.
#include <algorithm>
#include <array>
#include <numeric>

#include "pliant/boundary/fault.h"
#include "pliant/fem/diffusion/diffusion_equation.h"
#include "pliant/fem/interpolate.h"
#include "pliant/geometry/index.h"

namespace pliant {

void DiffusionEquation::fix(const Configuration& at, std::span<double> unknowns) const {
  const std::size_t n = index(mesh_.degree()) + 1;
  std::vector<double> values(n);
  std::vector<int> beyond(n);
  for_each_conditioned_edge([&](HalfEdgeId h, const DiffusionCondition& condition, std::span<const int> on_edge) {
    if (condition.kind != DiffusionCondition::Kind::value) return;
    interpolate_edge(mesh_, at, h, std::array{&condition.first}, values);
    for (std::size_t k = 0; k < n; ++k) unknowns[index(on_edge[k])] = values[k];
    if (mesh_.twin(h) == none) return;
    gather_edge(mesh_.twin(h), beyond);
    for (std::size_t k = 0; k < n; ++k) unknowns[index(beyond[k])] = values[n - 1 - k];
  });
}

std::vector<double> DiffusionEquation::initial_unknowns(const Configuration& at) const {
  return interpolate(space_, mesh_, at,
                     [this](FaceId face) -> const Coefficient& { return *problem_.initial[index(face)]; });
}

void DiffusionEquation::require_determined() const {
  // Unknowns that no element and no jump connects have solutions of their own, each of which something must hold.
  std::vector<int> parent(index(space_.size()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while (parent[index(i)] != i) i = parent[index(i)] = parent[index(parent[index(i)])];
    return i;
  };
  const auto unite = [&](int a, int b) { parent[index(root(a))] = root(b); };
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
    for (const int i : space_.of(t)) unite(i, space_.of(t)[0]);
  const std::size_t m = 2 * (index(mesh_.degree()) + 1);
  const auto lets_through = [](const DiffusionCondition& condition) { return condition.first.constant() != 0.0; };
  for (std::size_t k = 0; k < jump_members_.size(); ++k) {
    const CurveId c = mesh_.constraint_curve(mesh_.constraint(jump_edges_[k / m]));
    if (lets_through(problem_.conditions[index(problem_.condition_of_curve[index(c)])]))
      unite(jump_members_[k], jump_members_[k - k % m]);
  }
  std::vector<char> held(parent.size(), 0);
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    if (fixed_[i] != 0) held[index(root(static_cast<int>(i)))] = 1;
  for_each_conditioned_edge([&](HalfEdgeId, const DiffusionCondition& condition, std::span<const int> unknowns) {
    if (condition.kind == DiffusionCondition::Kind::robin && lets_through(condition))
      held[index(root(unknowns[0]))] = 1;
  });
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    if (held[index(root(space_.of(t)[0]))] != 0) continue;
    std::vector<std::string> names;
    for (const Curve& curve : mesh_.boundary().curves)
      if ((curve.left == mesh_.face(t) || curve.right == mesh_.face(t)) &&
          std::ranges::find(names, curve.name) == names.end())
        names.push_back(curve.name);
    std::string curves;
    for (const std::string& name : names) curves += (curves.empty() ? "\"" : ", \"") + name + "\"";
    throw InputError(
        "/problem/diffuse/conditions",
        "a steady solution is determined up to a constant only in the part of the domain that holds face \"" +
            mesh_.boundary().faces[index(mesh_.face(t))].name +
            "\": one of its curves needs a condition \"value\" or \"robin\" (curves of this face: " + curves + ")");
  }
}

}  // namespace pliant
