// lib/pliant/fem/navier_stokes/flow_equation.cpp: groups of unknowns, and their matrices summed.
#include "pliant/fem/navier_stokes/flow_equation.h"

#include <algorithm>
#include <cassert>

#include "pliant/fem/element_matrices.h"
#include "pliant/fem/element_values.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

bool are_alike(const Coefficient& a, const Coefficient& b) {
  return a.constant() && b.constant() && *a.constant() == *b.constant();
}

/// Where the pressure jumps: across curves between different fluids, where surface tension acts, and across walls.
std::vector<char> find_jumping(const FlowProblem& problem, const Mesh& mesh) {
  std::vector<char> jumps;
  const auto& curves = mesh.boundary().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const FaceId left = curves[c].left, right = curves[c].right;
    bool jumps_here = false;
    if (problem.pressure_by_face && left != outside && right != outside && left != right) {
      const FlowMaterial& here = problem.materials[index(left)];
      const FlowMaterial& there = problem.materials[index(right)];
      const int k = problem.condition_of_curve[c];
      jumps_here = k != none || problem.tensions[c].has_value() || !are_alike(here.density, there.density) ||
                   !are_alike(here.viscosity, there.viscosity);
    }
    jumps.push_back(jumps_here);
  }
  return jumps;
}

}  // namespace

FlowEquation::FlowEquation(const FlowProblem& problem, const Mesh& mesh, bool by_splines)
    : problem_(problem),
      mesh_(mesh),
      form_(choose_form(problem, mesh)),
      jumping_(find_jumping(problem, mesh)),
      velocities_(problem, mesh, jumping_, by_splines),
      jumps_(std::ranges::any_of(jumping_, [](char each) { return each != 0; })),
      pressures_(Space::by_face(mesh, mesh.degree() - 1, jumping_)) {
  make_groups();
  std::vector<Groups> groups;
  for (const Kind& kind : kinds_) groups.push_back({kind.size, kind.members});
  sparsity_ = make_sparsity(unknowns(), groups);
}

void FlowEquation::make_groups() {
  const int n = mesh_.net_size();
  kinds_.push_back({2 * n + pressures_.element_size(), {}});
  kinds_[0].members.reserve(index(mesh_.triangle_slots()) * index(kinds_[0].size));
  std::vector<int> unknowns;
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    unknowns.clear();
    bool is_plain = true;
    for (int component = 0; component < 2; ++component)
      for (const PointId p : mesh_.net(t)) {
        is_plain = is_plain && velocities_.is_plain(p, component);
        for (const auto& term : velocities_.terms(p, component)) unknowns.push_back(term.unknown);
      }
    if (!is_plain) {
      std::ranges::sort(unknowns);
      unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
    }
    for (const int pressure : pressures_.of(t)) unknowns.push_back(velocities_.size() + pressure);
    std::size_t kind = 0;
    if (!is_plain) {
      const int size = static_cast<int>(unknowns.size());
      kind = 1;
      while (kind < kinds_.size() && kinds_[kind].size != size) ++kind;
      if (kind == kinds_.size()) kinds_.push_back({size, {}});
    }
    kind_of_.push_back(static_cast<int>(kind));
    place_of_.push_back(static_cast<int>(kinds_[kind].members.size()) / kinds_[kind].size);
    kinds_[kind].members.insert(kinds_[kind].members.end(), unknowns.begin(), unknowns.end());
  }
}

std::span<const int> FlowEquation::members(TriangleId t) const {
  const Kind& kind = kinds_[index(kind_of_[index(t)])];
  return std::span(kind.members).subspan(index(place_of_[index(t)]) * index(kind.size), index(kind.size));
}

std::vector<bool> FlowEquation::multipliers() const {
  std::vector<bool> result(index(unknowns()), false);
  std::fill(result.begin() + velocities_.size(), result.end(), true);
  return result;
}

void FlowEquation::fill_sums(TriangleId t, std::span<const int> unknowns, std::vector<double>& sums) const {
  const std::size_t n = index(mesh_.net_size()), count = unknowns.size();
  sums.assign(2 * n * count, 0.0);
  const auto net = mesh_.net(t);
  for (int component = 0; component < 2; ++component)
    for (std::size_t i = 0; i < n; ++i)
      for (const auto& term : velocities_.terms(net[i], component)) {
        const auto at = std::ranges::lower_bound(unknowns, term.unknown) - unknowns.begin();
        sums[(index(component) * n + i) * count + index(at)] += term.weight;
      }
}

void FlowEquation::assemble(const Configuration& at, const FlowTerms& terms, std::span<const double> given,
                            CsrMatrix& matrix, std::vector<double>& load) const {
  matrix.pattern = sparsity_.pattern;
  matrix.values.assign(sparsity_.pattern->columns.size(), 0.0);
  load.assign(index(unknowns()), 0.0);
  FlowElement element(problem_, mesh_, form_, pressures_.degree());
  const std::size_t rows = 2 * index(mesh_.net_size()), m = index(pressures_.element_size()), full = rows + m;
  std::vector<double> sums, part, reduced, known(full);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    element.set(at.points, at.time, t, terms);
    const std::size_t kind = index(kind_of_[index(t)]), size = index(kinds_[kind].size);
    const auto where = std::span(sparsity_.places[kind]).subspan(index(place_of_[index(t)]) * size * size, size * size);
    const auto unknowns = members(t);
    if (kind == 0) {
      scatter(where, element.matrix(), matrix.values);
      for (std::size_t i = 0; i < size; ++i) load[index(unknowns[i])] += element.load()[i];
      continue;
    }
    // Velocities are sums: the matrix is transpose(sums) matrix sums, the load transpose(sums) (load - matrix given).
    const std::size_t count = size - m;
    fill_sums(t, unknowns.first(count), sums);
    const auto net = mesh_.net(t);
    for (std::size_t i = 0; i < rows; ++i) known[i] = given[2 * index(net[i % net.size()]) + i / net.size()];
    const auto whole = element.matrix();
    part.assign(full * size, 0.0);  // matrix sums
    for (std::size_t i = 0; i < full; ++i) {
      for (std::size_t j = 0; j < rows; ++j)
        if (const double entry = whole[i * full + j]; entry != 0)
          for (std::size_t k = 0; k < count; ++k) part[i * size + k] += entry * sums[j * count + k];
      for (std::size_t j = 0; j < m; ++j) part[i * size + count + j] = whole[i * full + rows + j];
    }
    reduced.assign(size * size, 0.0);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t k = 0; k < count; ++k)
        if (const double weight = sums[i * count + k]; weight != 0)
          for (std::size_t j = 0; j < size; ++j) reduced[k * size + j] += weight * part[i * size + j];
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < size; ++j) reduced[(count + i) * size + j] = part[(rows + i) * size + j];
    scatter(where, reduced, matrix.values);
    for (std::size_t i = 0; i < full; ++i) {
      double rest = element.load()[i];
      for (std::size_t j = 0; j < rows; ++j) rest -= whole[i * full + j] * known[j];
      if (i >= rows)
        load[index(unknowns[count + i - rows])] += rest;
      else
        for (std::size_t k = 0; k < count; ++k) load[index(unknowns[k])] += sums[i * count + k] * rest;
    }
  }
}

void FlowEquation::pin_pressures(CsrMatrix& matrix, std::vector<double>& load) const {
  std::vector<char> pinned(velocities_.enclosed().size(), 0);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    const std::size_t part = index(velocities_.part_of(t));
    if (!velocities_.is_enclosed(velocities_.part_of(t)) || pinned[part] != 0) continue;
    pinned[part] = 1;
    const int row = velocities_.size() + pressures_.of(t)[0];
    const CsrPattern& pattern = *matrix.pattern;
    for (int k = pattern.starts[index(row)]; k < pattern.starts[index(row) + 1]; ++k) {
      const int column = pattern.columns[index(k)];
      matrix.values[index(k)] = column == row ? 1 : 0;
      if (column != row) matrix.values[index(pattern.find(column, row))] = 0;
    }
    load[index(row)] = 0;
  }
}

FlowState FlowEquation::state(const Configuration& at, std::span<const double> unknowns,
                              std::span<const double> given) const {
  FlowState state;
  state.velocity.assign(given.begin(), given.end());
  velocities_.expand(unknowns.first(index(velocities_.size())), state.velocity);
  state.pressure.assign(unknowns.begin() + velocities_.size(), unknowns.end());
  const std::vector<char>& enclosed = velocities_.enclosed();
  if (std::ranges::none_of(enclosed, [](char each) { return each != 0; })) return state;

  std::vector<double> amounts(enclosed.size(), 0.0), areas(enclosed.size(), 0.0);
  ElementMap map(mesh_.degree());
  std::vector<double> factors, load(index(mesh_.net_size()));
  const std::vector<double> values = elevated_values(pressures_, state.pressure, mesh_.degree());
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    map.set(mesh_, at.points, t, Integrand::constant);
    factors.assign(index(map.points()), 1.0);
    element_load(map, factors, load);
    const std::size_t part = index(velocities_.part_of(t));
    for (std::size_t i = 0; i < load.size(); ++i) {
      areas[part] += load[i];
      amounts[part] += load[i] * values[index(t) * load.size() + i];
    }
  }
  std::vector<char> done(state.pressure.size(), 0);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    const std::size_t part = index(velocities_.part_of(t));
    if (enclosed[part] == 0) continue;
    for (const int i : pressures_.of(t)) {
      if (done[index(i)] == 0) state.pressure[index(i)] -= amounts[part] / areas[part];
      done[index(i)] = 1;
    }
  }
  return state;
}

std::vector<double> FlowEquation::reactions(const Configuration& at, const FlowTerms& terms,
                                            const FlowState& state) const {
  FlowElement element(problem_, mesh_, form_, pressures_.degree());
  const std::size_t n = index(mesh_.net_size()), m = index(pressures_.element_size());
  std::vector<double> x(2 * n + m), rest(2 * n + m), sums(state.velocity.size(), 0.0);
  const double unit = mesh_.boundary().unit;
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    const auto net = mesh_.net(t);
    if (std::ranges::none_of(net, [&](PointId p) { return velocities_.has_given(p); })) continue;
    element.set(at.points, at.time, t, terms);
    for (std::size_t i = 0; i < 2 * n; ++i) x[i] = state.velocity[2 * index(net[i % n]) + i / n];
    for (std::size_t i = 0; i < m; ++i) x[2 * n + i] = state.pressure[index(pressures_.of(t)[i])];
    element.residual(x, rest);
    for (std::size_t i = 0; i < 2 * n; ++i) sums[2 * index(net[i % n]) + i / n] += unit * unit * rest[i];
  }
  return sums;
}

}  // namespace pliant
