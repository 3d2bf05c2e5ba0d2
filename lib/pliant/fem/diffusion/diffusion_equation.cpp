// lib/pliant/fem/diffusion/diffusion_equation.cpp: assembles element after element, then edge after edge.
#include "pliant/fem/diffusion/diffusion_equation.h"

#include <algorithm>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using ConditionKind = DiffusionCondition::Kind;

/// Where curves let the unknown jump.
std::vector<char> jumping_curves(const DiffusionProblem& problem) {
  std::vector<char> jumps;
  for (const int c : problem.condition_of_curve)
    jumps.push_back(c != none && problem.conditions[index(c)].kind == ConditionKind::jump);
  return jumps;
}

Space make_space(const DiffusionProblem& problem, const Mesh& mesh) {
  const std::vector<char> jumps = jumping_curves(problem);
  const bool any = std::ranges::any_of(jumps, [](char c) { return c != 0; });
  return any ? Space::by_face(mesh, mesh.degree(), jumps) : Space::continuous(mesh);
}

}  // namespace

DiffusionEquation::DiffusionEquation(const DiffusionProblem& problem, const Mesh& mesh)
    : problem_(problem), mesh_(mesh), space_(make_space(problem, mesh)), edges_(curve_edges(mesh)) {
  collect_jumps();
  const Groups kinds[] = {{space_.element_size(), space_.unknowns()}, {2 * (mesh.degree() + 1), jump_members_}};
  sparsity_ = make_sparsity(space_.size(), kinds);
  fixed_.assign(index(space_.size()), 0);
  std::vector<int> beyond(index(mesh.degree()) + 1);
  for_each_conditioned_edge([&](HalfEdgeId h, const DiffusionCondition& condition, std::span<const int> unknowns) {
    if (condition.kind == ConditionKind::robin) closed_ = false;
    if (condition.kind != ConditionKind::value) return;
    closed_ = false;
    fixes_any_ = true;
    for (const int i : unknowns) fixed_[index(i)] = 1;
    if (mesh_.twin(h) == none) return;
    gather_edge(mesh_.twin(h), beyond);
    for (const int i : beyond) fixed_[index(i)] = 1;
  });
  if (!problem.convection.empty()) closed_ = false;
}

void DiffusionEquation::gather_edge(HalfEdgeId h, std::span<int> unknowns) const {
  const auto element = space_.of(triangle_of(h));
  for (int k = 0; k <= mesh_.degree(); ++k)
    unknowns[index(k)] = element[index(mesh_.layout().edge_index(edge_of(h), k))];
}

void DiffusionEquation::collect_jumps() {
  const std::vector<char> jumps = jumping_curves(problem_);
  const std::size_t n = index(mesh_.degree()) + 1;
  std::vector<int> here(n), there(n);
  for (std::size_t c = 0; c < jumps.size(); ++c) {
    if (jumps[c] == 0) continue;
    for (const HalfEdgeId h : edges_[c]) {
      const HalfEdgeId twin = mesh_.twin(h);
      if (twin == none || mesh_.face(triangle_of(h)) == mesh_.face(triangle_of(twin))) continue;
      gather_edge(h, here);
      gather_edge(twin, there);
      std::ranges::reverse(there);
      jump_edges_.push_back(h);
      jump_members_.insert(jump_members_.end(), here.begin(), here.end());
      jump_members_.insert(jump_members_.end(), there.begin(), there.end());
    }
  }
}

void DiffusionEquation::for_each_conditioned_edge(const UseEdge& use) const {
  std::vector<int> unknowns(index(mesh_.degree()) + 1);
  for (std::size_t k = problem_.conditions.size(); k-- > 0;)
    for (std::size_t c = 0; c < edges_.size(); ++c) {
      if (problem_.condition_of_curve[c] != static_cast<int>(k) || problem_.conditions[k].kind == ConditionKind::jump)
        continue;
      for (const HalfEdgeId h : edges_[c]) {
        gather_edge(h, unknowns);
        use(h, problem_.conditions[k], unknowns);
      }
    }
}

CoarseSpace DiffusionEquation::coarse_space() const {
  std::vector<int> nets = space_.unknowns();
  for (int& unknown : nets)
    if (fixed_[index(unknown)] != 0) unknown = -1;
  return hat_functions(mesh_.degree(), nets, space_.size());
}

void DiffusionEquation::assemble(const Configuration& at, DiffusionSystem& system) const {
  const std::size_t entries = sparsity_.pattern->columns.size(), n = index(space_.element_size());
  for (CsrMatrix* matrix : {&system.mass, &system.stiffness}) {
    matrix->pattern = sparsity_.pattern;
    matrix->values.assign(entries, 0.0);
  }
  system.load.assign(index(space_.size()), 0.0);
  ElementTerms terms(problem_, mesh_);
  std::vector<double> full(n * n);
  const std::vector<int>& places = sparsity_.places[0];
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    terms.set(at, t);
    const auto where = std::span(places).subspan(index(t) * n * n, n * n);
    unpack_pairs(space_.element_size(), terms.mass(), full);
    scatter(where, full, system.mass.values);
    unpack_pairs(space_.element_size(), terms.diffusion(), full);
    for (std::size_t k = 0; k < terms.convection().size(); ++k) full[k] += terms.convection()[k];
    scatter(where, full, system.stiffness.values);
    const auto unknowns = space_.of(t);
    for (std::size_t i = 0; i < n; ++i) system.load[index(unknowns[i])] += terms.load()[i];
  }

  EdgeTerms edge(mesh_);
  const std::size_t m = index(mesh_.degree()) + 1;
  for_each_conditioned_edge([&](HalfEdgeId h, const DiffusionCondition& condition, std::span<const int> unknowns) {
    if (condition.kind == ConditionKind::value) return;
    edge.set(at, h, condition);
    for (std::size_t i = 0; i < m; ++i) {
      system.load[index(unknowns[i])] += edge.load()[i];
      for (std::size_t j = 0; j < m; ++j)
        system.stiffness.values[index(sparsity_.pattern->find(unknowns[i], unknowns[j]))] +=
            edge.stiffness()[i * m + j];
    }
  });
  std::vector<double> both(4 * m * m);
  for (std::size_t e = 0; e < jump_edges_.size(); ++e) {
    const CurveId c = mesh_.constraint_curve(mesh_.constraint(jump_edges_[e]));
    edge.set(at, jump_edges_[e], problem_.conditions[index(problem_.condition_of_curve[index(c)])]);
    for (std::size_t i = 0; i < 2 * m; ++i)
      for (std::size_t j = 0; j < 2 * m; ++j)
        both[i * 2 * m + j] =
            (i < m) == (j < m) ? edge.stiffness()[(i % m) * m + j % m] : -edge.stiffness()[(i % m) * m + j % m];
    scatter(std::span(sparsity_.places[1]).subspan(e * both.size(), both.size()), both, system.stiffness.values);
  }
}

void DiffusionEquation::assemble_load(const Configuration& at, std::vector<double>& load) const {
  load.assign(index(space_.size()), 0.0);
  ElementTerms terms(problem_, mesh_);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    if (!problem_.materials[index(mesh_.face(t))].source) continue;
    terms.set(at, t);
    const auto unknowns = space_.of(t);
    for (std::size_t i = 0; i < unknowns.size(); ++i) load[index(unknowns[i])] += terms.load()[i];
  }
  EdgeTerms edge(mesh_);
  for_each_conditioned_edge([&](HalfEdgeId h, const DiffusionCondition& condition, std::span<const int> unknowns) {
    if (condition.kind == ConditionKind::value) return;
    edge.set(at, h, condition);
    for (std::size_t i = 0; i < unknowns.size(); ++i) load[index(unknowns[i])] += edge.load()[i];
  });
}

void DiffusionEquation::apply(const Configuration& at, std::span<const double> values, double amount_factor,
                              std::span<double> amounts, double rate_factor, std::span<double> rates,
                              CurveFluxes* fluxes) const {
  ElementTerms terms(problem_, mesh_);
  const std::size_t n = index(space_.element_size());
  std::vector<double> amount(n), rate(n), residual(n);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    terms.set(at, t);
    terms.apply(values.subspan(index(t) * n, n), amount, rate);
    const auto unknowns = space_.of(t);
    for (std::size_t i = 0; i < n; ++i) {
      amounts[index(unknowns[i])] += amount_factor * amount[i];
      rates[index(unknowns[i])] += rate_factor * rate[i];
    }
    if (fluxes != nullptr) {
      fluxes->add_element(t, -amount_factor, amount);
      fluxes->add_element(t, -rate_factor, rate);
    }
  }

  EdgeTerms edge(mesh_);
  const std::size_t m = index(mesh_.degree()) + 1;
  std::vector<double> enters(m), here(m), there(m);
  const auto trace = [&](HalfEdgeId h, std::span<double> on_edge) {
    for (std::size_t k = 0; k < m; ++k)
      on_edge[k] =
          values[index(triangle_of(h)) * n + index(mesh_.layout().edge_index(edge_of(h), static_cast<int>(k)))];
  };
  const auto add = [&](HalfEdgeId h, std::span<const int> unknowns) {
    for (std::size_t i = 0; i < m; ++i) rates[index(unknowns[i])] += rate_factor * enters[i];
    if (fluxes != nullptr) fluxes->add_edge(h, rate_factor, enters);
  };
  for_each_conditioned_edge([&](HalfEdgeId h, const DiffusionCondition& condition, std::span<const int> unknowns) {
    if (condition.kind == ConditionKind::value) return;
    edge.set(at, h, condition);
    trace(h, here);
    for (std::size_t i = 0; i < m; ++i) {
      enters[i] = edge.load()[i];
      for (std::size_t j = 0; j < m; ++j) enters[i] -= edge.stiffness()[i * m + j] * here[j];
    }
    add(h, unknowns);
  });
  std::vector<int> beyond(m);
  for (std::size_t e = 0; e < jump_edges_.size(); ++e) {
    const HalfEdgeId h = jump_edges_[e], twin = mesh_.twin(h);
    const CurveId c = mesh_.constraint_curve(mesh_.constraint(h));
    edge.set(at, h, problem_.conditions[index(problem_.condition_of_curve[index(c)])]);
    trace(h, here);
    trace(twin, there);
    std::ranges::reverse(there);
    const auto members = std::span(jump_members_).subspan(e * 2 * m, 2 * m);
    for (std::size_t i = 0; i < m; ++i) {
      enters[i] = 0;
      for (std::size_t j = 0; j < m; ++j) enters[i] += edge.stiffness()[i * m + j] * (there[j] - here[j]);
    }
    add(h, members.first(m));
    for (double& each : enters) each = -each;
    std::ranges::reverse_copy(members.subspan(m), beyond.begin());
    std::ranges::reverse(enters);
    add(twin, beyond);
  }
}

}  // namespace pliant
