// lib/pliant/fem/navier_stokes/given_velocities.cpp: velocities that conditions give, and their flux.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "pliant/boundary/fault.h"
#include "pliant/fem/edge_map.h"
#include "pliant/fem/interpolate.h"
#include "pliant/fem/navier_stokes/velocity_unknowns.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Kind = FlowCondition::Kind;

/// An enclosed flow may have this part of what crosses its boundary as a net flux: the rounding of expressions, and of
/// quadrature.
constexpr double greatest_net_flux = 1e-6;
/// What glides along its boundary crosses it by the rounding of places, by this part of what glides.
constexpr double greatest_net_rounding = 1e-10;

constexpr int most_sweeps = 100;  // over parts that share walls

bool is_zero(const FlowCondition& condition) {
  return condition.first.constant() == 0.0 && condition.second.constant() == 0.0;
}

}  // namespace

void VelocityUnknowns::give(const Configuration& at, std::span<double> values) const {
  std::ranges::fill(values, 0.0);
  const std::size_t n = index(mesh_.degree()) + 1;
  std::vector<double> on_edge(2 * n);
  // The last condition first, so that where curves meet the first one counts.
  for (std::size_t k = problem_.conditions.size(); k-- > 0;) {
    const FlowCondition& condition = problem_.conditions[k];
    if (condition.kind != Kind::velocity) continue;
    for (std::size_t c = 0; c < edges_.size(); ++c) {
      if (problem_.condition_of_curve[c] != static_cast<int>(k)) continue;
      for (const HalfEdgeId h : edges_[c]) {
        interpolate_edge(mesh_, at, h, std::array{&condition.first, &condition.second}, on_edge);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t component = 0; component < 2; ++component)
            values[2 * index(mesh_.edge_point(h, static_cast<int>(i))) + component] = on_edge[2 * i + component];
      }
    }
  }
  correct_fluxes(at, values);
}

/// What leaves one part of the mesh by the functions that were given, and by the values of its control points: the sum
/// of values times normals. The values of those with given normals may be corrected. `crossing` sums what crosses in
/// either direction, `passing` the speed.
struct VelocityUnknowns::Balance {
  double given = 0, crossing = 0, passing = 0;
  std::map<PointId, Vector> normals, given_normals;
  FaceId face = none;
};

std::vector<VelocityUnknowns::Balance> VelocityUnknowns::balance_fluxes(const Configuration& at) const {
  std::vector<Balance> balances(enclosed_.size());
  EdgeMap map(mesh_.degree());
  const double unit = mesh_.boundary().unit;
  for (const HalfEdgeId h : mesh_.half_edges()) {
    const HalfEdgeId twin = mesh_.twin(h);
    const int part = part_of(triangle_of(h));
    if (enclosed_[index(part)] == 0 || (twin != none && part_of(triangle_of(twin)) == part)) continue;
    const int k = problem_.condition_of_curve[index(mesh_.constraint_curve(mesh_.constraint(h)))];
    const FlowCondition* const condition = k == none ? nullptr : &problem_.conditions[index(k)];
    const bool crosses = condition != nullptr && condition->kind == Kind::velocity && !is_zero(*condition);
    map.set(mesh_, at.points, h);
    Balance& balance = balances[index(part)];
    balance.face = mesh_.face(triangle_of(h));
    for (int q = 0; q < map.points(); ++q) {
      const Vector outward = map.weight(q) * Vector{map.along(q).y, -map.along(q).x};
      for (int i = 0; i <= mesh_.degree(); ++i) {
        const Vector normal = map.values_at(q)[index(i)] * outward;
        balance.normals[mesh_.edge_point(h, i)] += normal;
        if (crosses) balance.given_normals[mesh_.edge_point(h, i)] += normal;
      }
      if (!crosses) continue;
      const CoefficientPoint there{mesh_, triangle_of(h), map.xi(q), unit * map.place(q), at.time};
      const Vector velocity{evaluate_at(condition->first, there), evaluate_at(condition->second, there)};
      balance.given += dot(velocity, outward);
      balance.crossing += std::abs(dot(velocity, outward));
      balance.passing += length(velocity) * length(outward);
    }
  }
  return balances;
}

void VelocityUnknowns::correct_fluxes(const Configuration& at, std::span<double> values) const {
  if (std::ranges::none_of(enclosed_, [](char each) { return each != 0; })) return;
  const double unit = mesh_.boundary().unit;
  const std::vector<Balance> balances = balance_fluxes(at);
  for (const Balance& balance : balances) {
    if (std::abs(balance.given) <=
        std::max(greatest_net_flux * balance.crossing, greatest_net_rounding * balance.passing))
      continue;
    std::ostringstream text;
    text << "the velocity is given on the whole "
         << (balances.size() > 1 ? "boundary of the face \"" + mesh_.boundary().faces[index(balance.face)].name + "\""
                                 : "outer boundary")
         << ", but at time " << describe_number(at.time) << " " << describe_number(unit * std::abs(balance.given))
         << " (area per time) more " << (balance.given > 0 ? "leaves" : "enters") << " than "
         << (balance.given > 0 ? "enters" : "leaves") << ", of " << describe_number(unit * balance.crossing)
         << " that crosses it: an incompressible fluid needs equal amounts, or a curve with outflow";
    throw InputError("/problem/navierstokes/conditions", text.str());
  }
  // Parts share walls, whose values count for both: one part is corrected after the other until none needs it.
  bool changes = true;
  for (int sweep = 0; sweep < most_sweeps && changes; ++sweep) {
    changes = false;
    for (const Balance& balance : balances) {
      double net = 0, squares = 0;
      for (const auto& [p, normal] : balance.normals)
        net += values[2 * index(p)] * normal.x + values[2 * index(p) + 1] * normal.y;
      for (const auto& [p, normal] : balance.given_normals) squares += squared_length(normal);
      if (!(squares > 0)) continue;
      changes = changes || std::abs(net) > 0x1p-50 * balance.passing;
      for (const auto& [p, normal] : balance.given_normals) {
        values[2 * index(p)] -= net / squares * normal.x;
        values[2 * index(p) + 1] -= net / squares * normal.y;
      }
    }
    if (balances.size() == 1) return;
  }
}

}  // namespace pliant
