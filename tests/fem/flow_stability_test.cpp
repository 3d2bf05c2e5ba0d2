// tests/fem/flow_stability_test.cpp: the inf-sup constant of velocities and pressures, on small meshes.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "flows.h"
#include "pliant/fem/element_matrices.h"
#include "pliant/fem/element_values.h"
#include "support/mapped_meshes.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

using FlowKind = FlowCondition::Kind;

/// The integrals of products of pressures.
Eigen::MatrixXd pressure_mass(const FlowEquation& equation) {
  const Mesh& mesh = equation.mesh();
  const Space& space = equation.pressures();
  const auto n = static_cast<Eigen::Index>(mesh.net_size()), size = static_cast<Eigen::Index>(space.size());
  Eigen::MatrixXd values(n * mesh.triangle_slots(), size), mass = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    std::vector<double> unit(index(space.size()), 0.0);
    unit[static_cast<std::size_t>(i)] = 1;
    const std::vector<double> column = elevated_values(space, unit, mesh.degree());
    values.col(i) = Eigen::Map<const Eigen::VectorXd>(column.data(), values.rows());
  }
  ElementMap map(mesh.degree());
  std::vector<double> factors, pairs(index(mesh.net_size() * (mesh.net_size() + 1) / 2)),
      full(index(mesh.net_size() * mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    map.set(mesh, mesh.points(), t, Integrand::constant);
    factors.assign(index(map.points()), 1.0);
    element_mass(map, factors, pairs);
    unpack_pairs(mesh.net_size(), pairs, full);
    const Eigen::MatrixXd here = values.middleRows(t * n, n);
    mass += here.transpose() * Eigen::Map<const Eigen::MatrixXd>(full.data(), n, n) * here;
  }
  return mass;
}

struct Stability {
  int modes = 0;        // pressures that no velocity feels
  double constant = 0;  // of the others: the least, over pressures, of the greatest (div v, p) / (|v| |p|), for the
                        // norm of v in the equation, of mass and viscosity
};

Stability find_stability(const FlowProblem& problem, const Mesh& mesh, bool by_splines) {
  const FlowEquation equation(problem, mesh, by_splines);
  FlowTerms terms;
  terms.inertia = 1;
  CsrMatrix matrix;
  std::vector<double> load;
  const std::vector<double> nothing(2 * index(mesh.point_slots()), 0.0);
  equation.assemble({mesh.points(), 0}, terms, nothing, matrix, load);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(equation.unknowns(), equation.unknowns());
  for (int i = 0; i < equation.unknowns(); ++i)
    for (int k = matrix.pattern->starts[index(i)]; k < matrix.pattern->starts[index(i) + 1]; ++k)
      dense(i, matrix.pattern->columns[index(k)]) = matrix.values[index(k)];
  const Eigen::Index n = equation.velocities().size(), m = equation.pressures().size();
  const Eigen::MatrixXd a = dense.topLeftCorner(n, n), b = dense.bottomLeftCorner(m, n);
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(m, m);
  if (n > 0) schur = b * a.llt().solve(b.transpose());
  const Eigen::VectorXd values = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                     0.5 * (schur + schur.transpose()), pressure_mass(equation), Eigen::EigenvaluesOnly)
                                     .eigenvalues();
  Stability result;
  while (result.modes < m && values[result.modes] < 1e-9) ++result.modes;
  if (result.modes < m) result.constant = std::sqrt(values[result.modes]);
  return result;
}

/// A regular polygon of straight walls with `corners` corners; with `ears`, each second corner is that of a triangle
/// with two edges on walls. Inside are `rings` rings around a point in the middle.
MeshData polygon(int degree, int corners, bool ears, int rings) {
  MeshBuilder builder(degree);
  MeshData& data = builder.data();
  data.boundary = with_faces({"inside"});
  const auto on_circle = [&](double k, int count, double radius) {
    const double angle = 2 * std::numbers::pi * k / count;
    return radius * Point{std::cos(angle), std::sin(angle)};
  };
  std::vector<PointId> rim;
  for (int k = 0; k < corners; ++k) rim.push_back(builder.add_vertex(on_circle(k, corners, 1)));
  for (const PointId p : rim) data.boundary.vertices.push_back(builder.at(p));
  for (int k = 0; k < corners; ++k) {
    const int next = (k + 1) % corners;
    data.boundary.curves.push_back(open_curve(data.boundary, "wall", k, next, {}, 0));
    data.constrained_edges.push_back({static_cast<CurveId>(k), 0, builder.edge(rim[index(k)], rim[index(next)])});
  }
  elevate_curves(data.boundary, degree);
  std::vector<PointId> outer = rim;
  if (ears) {
    outer.clear();
    for (int k = 0; k < corners; k += 2) {
      outer.push_back(rim[index(k)]);
      builder.add_triangle(rim[index(k)], rim[index(k + 1)], rim[index((k + 2) % corners)], 0);
    }
  }
  const int count = static_cast<int>(outer.size());
  for (int r = 1; r <= rings; ++r) {
    std::vector<PointId> ring;
    for (int k = 0; k < count; ++k)
      ring.push_back(builder.add_vertex(on_circle(k, count, (ears ? 0.8 : 1) * (1 - r / (rings + 1.0)))));
    for (int k = 0; k < count; ++k) {
      const std::size_t i = index(k), j = index((k + 1) % count);
      builder.add_triangle(ring[i], outer[i], outer[j], 0);
      builder.add_triangle(ring[i], outer[j], ring[j], 0);
    }
    outer = ring;
  }
  const PointId middle = builder.add_vertex({0, 0});
  for (int k = 0; k < count; ++k) builder.add_triangle(middle, outer[index(k)], outer[index((k + 1) % count)], 0);
  return std::move(data);
}

/// A drop with a round interface of so many spans, each of which is an edge of a triangle with a corner in the middle;
/// around it walls with as many corners.
MeshData drop(int degree, int spans, bool has_outside) {
  MeshBuilder builder(degree);
  MeshData& data = builder.data();
  data.boundary = with_faces({"drop"});
  if (has_outside) data.boundary.faces.push_back({"around", {}});
  Curve interface = closed_curve("interface", round_spline(degree, spans, {0, 0}, 1), 0, has_outside ? 1 : outside);
  const std::vector<double> breaks = interface.spline.breaks();
  std::vector<std::vector<Point>> edges(index(spans), std::vector<Point>(index(degree + 1)));
  std::vector<PointId> rim, walls;
  for (int k = 0; k < spans; ++k) {
    interface.spline.extract(breaks[index(k)], edges[index(k)]);
    rim.push_back(builder.add_vertex(edges[index(k)][0]));
  }
  data.boundary.curves.push_back(std::move(interface));
  const auto next = [&](int k) { return index((k + 1) % spans); };
  for (int k = 0; k < spans; ++k)
    data.constrained_edges.push_back({0, k, builder.curved_edge(rim[index(k)], rim[next(k)], edges[index(k)])});
  const PointId middle = builder.add_vertex({0, 0});
  for (int k = 0; k < spans; ++k) builder.add_triangle(middle, rim[index(k)], rim[next(k)], 0);
  if (!has_outside) return std::move(data);
  for (int k = 0; k < spans; ++k) walls.push_back(builder.add_vertex(4 * builder.at(rim[index(k)])));
  for (const PointId p : walls) data.boundary.vertices.push_back(builder.at(p));
  for (int k = 0; k < spans; ++k) {
    data.boundary.curves.push_back(open_curve(data.boundary, "wall", k, static_cast<int>(next(k)), {}, 1));
    data.constrained_edges.push_back({k + 1, 0, builder.edge(walls[index(k)], walls[next(k)])});
    builder.add_triangle(rim[index(k)], walls[index(k)], walls[next(k)], 1);
    builder.add_triangle(rim[index(k)], walls[next(k)], rim[next(k)], 1);
  }
  elevate_curves(data.boundary, degree);
  return std::move(data);
}

Stability of_walls(const MeshData& data, const std::vector<std::string>& walls) {
  const Mesh mesh(data);
  FlowProblem problem = flow_problem(mesh, 1, 1);
  for (const std::string& wall : walls) set_condition(problem, mesh, wall, {});
  return find_stability(problem, mesh, false);
}

Stability of_drop(const MeshData& data) {
  const Mesh mesh(data);
  FlowProblem problem = flow_problem(mesh, 1, 1);
  problem.tensions[0] = Coefficient(1);
  problem.motion_of_curve[0] = CurveMotion::follows;
  set_condition(problem, mesh, "wall", {});
  return find_stability(problem, mesh, true);
}

}  // namespace

TEST_CASE("triangles in corners of walls leave no pressure that no velocity feels", "[navier_stokes]") {
  // Each of these meshes has triangles with two edges on walls; what they cost is the same on fine meshes.
  const int degree = GENERATE(2, 3, 4);
  const double least = degree == 2 ? 0.32 : degree == 3 ? 0.21 : 0.16;
  const auto as_it_is = [](double x, double y) { return Point{x, y}; };
  for (const int n : {2, 3, 4}) {
    const Stability square = of_walls(mapped_square(degree, n, as_it_is), {"south", "east", "north", "west"});
    CHECK(square.modes == 1);
    CHECK(square.constant > least);
    CHECK(square.constant < 2 * least);
  }
  for (const int corners : {6, 8, 12})
    for (const int rings : {0, 1, 2}) {
      const Stability with = of_walls(polygon(degree, corners, true, rings), {"wall"});
      CHECK(with.modes == 1);
      CHECK(with.constant > least);
      const Stability without = of_walls(polygon(degree, corners, false, rings), {"wall"});
      CHECK(without.modes == 1);
      if (rings > 0) CHECK(without.constant > 0.53);
    }
}

TEST_CASE("two triangles between walls are too few", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 4);
  const auto as_it_is = [](double x, double y) { return Point{x, y}; };
  CHECK(of_walls(mapped_square(degree, 1, as_it_is), {"south", "east", "north", "west"}).modes == 2);
}

TEST_CASE("drops whose interface has few spans feel every pressure", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 4);
  for (const int spans : {3, 4, 5, 6, 8}) {
    if (spans < degree) continue;  // no closed spline
    const Stability alone = of_drop(drop(degree, spans, false));
    CHECK(alone.modes == 0);
    CHECK(alone.constant > 0.26);
    if (spans < 5) continue;  // with walls around elements are not valid
    const Stability around = of_drop(drop(degree, spans, true));
    CHECK(around.modes == 1);
    CHECK(around.constant > 0.26);
  }
}
