// lib/pliant/fem/navier_stokes/given_velocities.cpp: velocities that conditions give, and their flux.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "pliant/boundary/fault.h"
#include "pliant/fem/edge_map.h"
#include "pliant/fem/navier_stokes/velocity_unknowns.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Kind = FlowCondition::Kind;

/// An enclosed flow may have this part of what crosses its boundary as a net flux: the rounding of expressions, and of
/// quadrature.
constexpr double greatest_net_flux = 1e-6;

bool is_zero(const FlowCondition& condition) {
  return condition.first.constant() == 0.0 && condition.second.constant() == 0.0;
}

}  // namespace

void VelocityUnknowns::give(const Configuration& at, std::span<double> values) const {
  std::ranges::fill(values, 0.0);
  const std::size_t n = index(mesh_.degree()) + 1;
  const double unit = mesh_.boundary().unit;
  std::vector<double> polygon(2 * n), on_edge(2 * n);
  // The last condition first, so that where curves meet the first one counts.
  for (std::size_t k = problem_.conditions.size(); k-- > 0;) {
    const FlowCondition& condition = problem_.conditions[k];
    if (condition.kind != Kind::velocity) continue;
    for (std::size_t c = 0; c < edges_.size(); ++c) {
      if (problem_.condition_of_curve[c] != static_cast<int>(k)) continue;
      for (const HalfEdgeId h : edges_[c]) {
        for (std::size_t i = 0; i < n; ++i) {
          const Point& p = at.points[index(mesh_.edge_point(h, static_cast<int>(i)))];
          polygon[2 * i] = p.x;
          polygon[2 * i + 1] = p.y;
        }
        for (std::size_t i = 0; i < n; ++i) {
          const double s = static_cast<double>(i) / mesh_.degree();
          Barycentric xi{0, 0, 0};
          xi[index(edge_of(h))] = 1 - s;
          xi[index(edge_of(next(h)))] = s;
          std::array<double, 2> x;
          evaluate_polygon(mesh_.degree(), 2, polygon, s, x);
          const CoefficientPoint there{mesh_, triangle_of(h), xi, {unit * x[0], unit * x[1]}, at.time};
          on_edge[2 * i] = evaluate_at(condition.first, there);
          on_edge[2 * i + 1] = evaluate_at(condition.second, there);
        }
        interpolate_polygon(mesh_.degree(), 2, on_edge);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t component = 0; component < 2; ++component)
            values[2 * index(mesh_.edge_point(h, static_cast<int>(i))) + component] = on_edge[2 * i + component];
      }
    }
  }
  correct_fluxes(at, values);
  for (const auto& [to, from, weight] : given_terms_)
    for (std::size_t component = 0; component < 2; ++component)
      values[2 * index(to) + component] += weight * values[2 * index(from) + component];
}

void VelocityUnknowns::correct_fluxes(const Configuration& at, std::span<double> values) const {
  if (std::ranges::none_of(enclosed_, [](char each) { return each != 0; })) return;
  // For each part: what leaves it by the functions that were given, by their interpolants, what crosses, and the
  // squares of the normals, along which the interpolants are corrected.
  struct Balance {
    double given = 0, net = 0, crossing = 0, normals = 0;
  };
  std::vector<Balance> balances(enclosed_.size());
  std::vector<Vector> normals(values.size() / 2), given_normals(values.size() / 2);
  EdgeMap map(mesh_.degree());
  const double unit = mesh_.boundary().unit;
  for (std::size_t c = 0; c < edges_.size(); ++c) {
    const int k = problem_.condition_of_curve[c];
    const FlowCondition* const condition = k == none ? nullptr : &problem_.conditions[index(k)];
    const bool crosses = condition != nullptr && condition->kind == Kind::velocity && !is_zero(*condition);
    for (const HalfEdgeId h : edges_[c]) {
      if (mesh_.twin(h) != none) continue;
      map.set(mesh_, at.points, h);
      Balance& balance = balances[index(part_of_point_[index(mesh_.origin(h))])];
      for (int q = 0; q < map.points(); ++q) {
        const Vector outward = map.weight(q) * Vector{map.along(q).y, -map.along(q).x};
        for (int i = 0; i <= mesh_.degree(); ++i) {
          const Vector normal = map.values_at(q)[index(i)] * outward;
          normals[index(mesh_.edge_point(h, i))] += normal;
          if (crosses) given_normals[index(mesh_.edge_point(h, i))] += normal;
        }
        if (!crosses) continue;
        const CoefficientPoint there{mesh_, triangle_of(h), map.xi(q), unit * map.place(q), at.time};
        const Vector velocity{evaluate_at(condition->first, there), evaluate_at(condition->second, there)};
        balance.given += dot(velocity, outward);
        balance.crossing += std::abs(dot(velocity, outward));
      }
    }
  }
  for (std::size_t p = 0; p < normals.size(); ++p) {
    Balance& balance = balances[index(part_of_point_[p])];
    balance.net += values[2 * p] * normals[p].x + values[2 * p + 1] * normals[p].y;
    balance.normals += squared_length(given_normals[p]);
  }
  for (std::size_t part = 0; part < balances.size(); ++part) {
    const Balance& balance = balances[part];
    if (enclosed_[part] == 0 || std::abs(balance.given) <= greatest_net_flux * balance.crossing) continue;
    std::ostringstream text;
    text << "the velocity is given on the whole outer boundary, but at time " << describe_number(at.time) << " "
         << describe_number(unit * std::abs(balance.given)) << " (area per time) more "
         << (balance.given > 0 ? "leaves" : "enters") << " than " << (balance.given > 0 ? "enters" : "leaves")
         << ", of " << describe_number(unit * balance.crossing)
         << " that crosses it: an incompressible fluid needs equal amounts, or a curve with outflow";
    throw InputError("/problem/navierstokes/conditions", text.str());
  }
  for (std::size_t p = 0; p < normals.size(); ++p) {
    const std::size_t part = index(part_of_point_[p]);
    if (enclosed_[part] == 0 || !(balances[part].normals > 0)) continue;
    const double by = balances[part].net / balances[part].normals;
    values[2 * p] -= by * given_normals[p].x;
    values[2 * p + 1] -= by * given_normals[p].y;
  }
}

}  // namespace pliant
