// lib/pliant/fem/navier_stokes/flow_report.cpp: energy, dissipation, fluxes and forces of a flow; its vorticity.
#include <algorithm>
#include <cmath>

#include "pliant/fem/edge_map.h"
#include "pliant/fem/element_matrices.h"
#include "pliant/fem/element_values.h"
#include "pliant/fem/navier_stokes/navier_stokes.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

/// A velocity and its derivatives with respect to x and y, in lengths of the mesh.
struct VelocityThere {
  Vector value, along_x, along_y;
};

VelocityThere velocity_at(const Mesh& mesh, const ElementMap& map, TriangleId t, int q, std::span<const double> field) {
  const Vector to_2 = map.along_2(q), to_3 = map.along_3(q);
  const double det = map.det(q);
  const auto b = map.table().values_at(q), d2 = map.table().along_2_at(q), d3 = map.table().along_3_at(q);
  VelocityThere there;
  std::size_t i = 0;
  for (const PointId p : mesh.net(t)) {
    const Vector u{field[2 * index(p)], field[2 * index(p) + 1]};
    there.value += b[i] * u;
    there.along_x += ((d2[i] * to_3.y - d3[i] * to_2.y) / det) * u;
    there.along_y += ((d3[i] * to_2.x - d2[i] * to_3.x) / det) * u;
    ++i;
  }
  return there;
}

/// The name of a curve, or its number.
std::string name_of(const Mesh& mesh, CurveId c) {
  const std::string& name = mesh.boundary().curves[index(c)].name;
  return name.empty() ? std::to_string(c) : name;
}

}  // namespace

void NavierStokes::report(PassReport& report) const {
  const double unit = mesh_.boundary().unit;
  report.add("unknowns", equation_.unknowns());
  report.add("solves", counts.solves);
  report.add("residual", counts.worst_residual);
  report.add("euler_steps", counts.euler_steps);

  double energy = 0, dissipation = 0, fastest = 0, divergence = 0;
  ElementMap map(mesh_.degree());
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    map.set(mesh_, mesh_.points(), t, Integrand::varying);
    const FlowMaterial& material = problem_.materials[index(mesh_.face(t))];
    for (int q = 0; q < map.points(); ++q) {
      const VelocityThere u = velocity_at(mesh_, map, t, q, state_.velocity);
      const CoefficientPoint at{mesh_, t, map.table().xi[index(q)], unit * map.place(q), mesh_.time};
      const double shear = u.along_y.x + u.along_x.y, trace = u.along_x.x + u.along_y.y;
      energy += 0.5 * map.measure(q) * evaluate_at(material.density, at) * squared_length(u.value);
      dissipation += map.measure(q) * evaluate_at(material.viscosity, at) *
                     (2 * u.along_x.x * u.along_x.x + 2 * u.along_y.y * u.along_y.y + shear * shear);
      divergence += map.measure(q) * trace * trace;
      fastest = std::max(fastest, length(u.value));
    }
  }
  report.add("kinetic_energy", unit * unit * energy);
  report.add("dissipation", dissipation);
  report.add("divergence", std::sqrt(divergence));
  report.add("max_speed", fastest);
  const std::vector<double> pressures = elevated_values(equation_.pressures(), state_.pressure, mesh_.degree());
  const auto [least, greatest] = std::ranges::minmax(pressures);
  report.add("min_pressure", unit * least);
  report.add("max_pressure", unit * greatest);

  // Curves of one name count together.
  std::map<std::string, double> fluxes;
  EdgeMap edge(mesh_.degree());
  const auto edges = curve_edges(mesh_);
  for (std::size_t c = 0; c < edges.size(); ++c)
    for (const HalfEdgeId h : edges[c]) {
      if (mesh_.twin(h) != none) continue;
      edge.set(mesh_, mesh_.points(), h);
      double& flux = fluxes[name_of(mesh_, static_cast<CurveId>(c))];
      for (int q = 0; q < edge.points(); ++q) {
        Vector u;
        for (int k = 0; k <= mesh_.degree(); ++k) {
          const std::size_t at = 2 * index(mesh_.edge_point(h, k));
          u += edge.values_at(q)[index(k)] * Vector{state_.velocity[at], state_.velocity[at + 1]};
        }
        flux += unit * edge.weight(q) * dot(u, Vector{edge.along(q).y, -edge.along(q).x});
      }
    }
  for (const auto& [name, flux] : fluxes) report.add("flux:" + name, flux);
  for (const auto& [name, force] : forces_) {
    report.add("force_x:" + name, force.x);
    report.add("force_y:" + name, force.y);
  }
}

void NavierStokes::put_vorticity() {
  // Its projection onto the functions of the mesh's degree that are continuous in each face.
  const std::vector<char> jumps = equation_.jumping_curves();
  const bool jumps_somewhere = equation_.pressure_jumps();
  const Space space = jumps_somewhere ? Space::by_face(mesh_, mesh_.degree(), jumps) : Space::continuous(mesh_);
  const Groups groups[] = {{space.element_size(), space.unknowns()}};
  const Sparsity sparsity = make_sparsity(space.size(), groups);
  CsrMatrix mass{sparsity.pattern, std::vector<double>(sparsity.pattern->columns.size(), 0.0)};
  const std::size_t n = index(mesh_.net_size());
  std::vector<double> load(index(space.size()), 0.0), pairs(n * (n + 1) / 2), full(n * n), factors, local(n);
  const std::vector<double>& velocity = mesh_.fields()[index(find_field(mesh_, "velocity"))].values;
  ElementMap map(mesh_.degree());
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    map.set(mesh_, mesh_.points(), t, Integrand::varying);
    factors.assign(index(map.points()), 1.0);
    element_mass(map, factors, pairs);
    unpack_pairs(space.element_size(), pairs, full);
    scatter(std::span(sparsity.places[0]).subspan(index(t) * n * n, n * n), full, mass.values);
    for (int q = 0; q < map.points(); ++q) {
      const VelocityThere u = velocity_at(mesh_, map, t, q, velocity);
      factors[index(q)] = (u.along_x.y - u.along_y.x) / mesh_.boundary().unit;
    }
    element_load(map, factors, local);
    for (std::size_t i = 0; i < n; ++i) load[index(space.of(t)[i])] += local[i];
  }
  const auto solver = make_symmetric_solver(space.size(), true);
  if (const std::string why = solver->factor(mass); !why.empty()) throw NoSolution(why);
  std::vector<double> unknowns(load.size(), 0.0);
  if (const SolveOutcome outcome = solver->solve(load, unknowns, solver_tolerance); !outcome.converged)
    throw NoSolution(outcome.why);
  put_scalar("vorticity", elevated_values(space, unknowns, mesh_.degree()), jumps_somewhere);
}

}  // namespace pliant
