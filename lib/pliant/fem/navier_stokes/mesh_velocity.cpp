// lib/pliant/fem/navier_stokes/mesh_velocity.cpp: weights of control points, or a Laplace equation for each component.
#include "pliant/fem/navier_stokes/mesh_velocity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "pliant/boundary/curve_points.h"
#include "pliant/fem/edge_map.h"
#include "pliant/fem/element_matrices.h"
#include "pliant/fem/navier_stokes/segment_tree.h"
#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/no_solution.h"
#include "pliant/fem/sparsity.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Four right-hand sides (velocity and acceleration, two components each) pay for factors, while there is memory.
constexpr int largest_direct_motion = 1'000'000;

/// The polygons of the edges on curves of one motion. `in_edges`: distances are measured in buffer widths; else in
/// lengths of the mesh.
SegmentTree collect_segments(const Mesh& mesh, std::span<const CurveMotion> motion_of_curve, CurveMotion motion,
                             bool in_edges) {
  std::vector<MeasuringSegment> segments;
  const auto edges = curve_edges(mesh);
  const int p = mesh.degree();
  std::vector<Point> polygon(index(p) + 1), places(polygon.size());
  for (std::size_t c = 0; c < edges.size(); ++c) {
    if (motion_of_curve[c] != motion) continue;
    for (const HalfEdgeId h : edges[c]) {
      mesh.gather_edge_points(h, polygon);
      double length = 0;
      for (int k = 0; k <= p; ++k) {
        places[index(k)] = bezier_point(polygon, static_cast<double>(k) / p);
        if (k > 0) length += distance(places[index(k - 1)], places[index(k)]);
      }
      if (!(length > 0)) continue;  // a point, which the edges beside it have as their end
      for (std::size_t k = 1; k < places.size(); ++k)
        segments.push_back({places[k - 1], places[k], in_edges ? blend_width * length : 1});
    }
  }
  return SegmentTree(std::move(segments));
}

double smoothstep(double t) { return t * t * (3 - 2 * t); }

/// Multiplies the weights of control points off the curves.
void fade(const Mesh& mesh, std::span<const CurveMotion> motion_of_curve, std::span<const char> is_given,
          std::span<double> weights) {
  const SegmentTree buffer = collect_segments(mesh, motion_of_curve, CurveMotion::stays, true);
  const SegmentTree staying = collect_segments(mesh, motion_of_curve, CurveMotion::stays, false);
  const SegmentTree following = collect_segments(mesh, motion_of_curve, CurveMotion::follows, false);
  const double far = 2 * mesh.box().size();
  for (std::size_t p = 0; p < weights.size(); ++p) {
    if (is_given[p] != 0 || !mesh.is_point_alive(static_cast<PointId>(p))) continue;
    const Point& place = mesh.points()[p];
    double t = buffer.least(place, 1);
    if (t >= 1) continue;
    const double d = staying.least(place, far);
    // Only what is nearer than this raises t.
    const double near = following.least(place, t > 0 ? std::min(far, d / t - d) : far);
    if (near < far && d + near > 0) t = std::clamp(d / (d + near), t, 1.0);
    weights[p] *= smoothstep(t);
  }
}

}  // namespace

MeshVelocity::MeshVelocity(const Mesh& mesh, std::span<const CurveMotion> motion_of_curve, MeshMotion motion)
    : is_given_(index(mesh.point_slots()), 0),
      weights_(index(mesh.point_slots()), motion == MeshMotion::fixed ? 0 : 1) {
  assert(mesh.is_compact() && motion_of_curve.size() == mesh.boundary().curves.size());
  if (motion == MeshMotion::fixed) return;
  const auto edges = curve_edges(mesh);
  for (std::size_t c = 0; c < edges.size(); ++c)
    for (const HalfEdgeId h : edges[c])
      for (int k = 0; k <= mesh.degree(); ++k) {
        const std::size_t p = index(mesh.edge_point(h, k));
        is_given_[p] = 1;
        if (motion_of_curve[c] == CurveMotion::stays) weights_[p] = 0;
      }
  if (motion == MeshMotion::blend) fade(mesh, motion_of_curve, is_given_, weights_);
  if (motion == MeshMotion::harmonic) prepare_harmonic(mesh);
}

void MeshVelocity::prepare_harmonic(const Mesh& mesh) {
  const Space space = Space::continuous(mesh);
  points_.assign(index(space.size()), none);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int k = 0; k < mesh.net_size(); ++k) points_[index(space.of(t)[index(k)])] = mesh.net(t)[index(k)];
  if (std::ranges::all_of(points_, [&](PointId p) { return is_given_[index(p)] != 0; })) return;

  const Groups groups[] = {{space.element_size(), space.unknowns()}};
  const Sparsity sparsity = make_sparsity(space.size(), groups);
  const CsrPattern& pattern = *sparsity.pattern;
  stiffness_ = {sparsity.pattern, std::vector<double>(pattern.columns.size(), 0.0)};
  ElementMap map(mesh.degree());
  const std::size_t n = index(mesh.net_size());
  std::vector<double> pairs(n * (n + 1) / 2), full(n * n);
  std::vector<SymmetricTensor> identity;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    map.set(mesh, mesh.points(), t, Integrand::constant);
    identity.resize(index(map.points()));
    element_stiffness(map, identity, pairs);
    unpack_pairs(space.element_size(), pairs, full);
    scatter(std::span(sparsity.places[0]).subspan(index(t) * n * n, n * n), full, stiffness_.values);
  }
  // Given values have an equation of their own.
  matrix_ = stiffness_;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      const int j = pattern.columns[index(k)];
      if (i != j && (is_given_[index(points_[index(i)])] != 0 || is_given_[index(points_[index(j)])] != 0))
        matrix_.values[index(k)] = 0;
    }
  if (space.size() <= largest_direct_motion) {
    solver_ = make_direct_symmetric();
  } else {
    std::vector<int> nets = space.unknowns();
    for (int& unknown : nets)
      if (is_given_[index(points_[index(unknown)])] != 0) unknown = -1;
    const CoarseSpace coarse = hat_functions(mesh.degree(), nets, space.size());
    solver_ = make_symmetric_solver(space.size(), false, &coarse);
  }
  if (const std::string why = solver_->factor(matrix_); !why.empty())
    throw NoSolution("the motion of the mesh: " + why);
}

std::vector<double> MeshVelocity::extend(std::span<const double> velocity) const {
  assert(velocity.size() == 2 * weights_.size());
  std::vector<double> result(velocity.size(), 0.0);
  for (std::size_t p = 0; p < weights_.size(); ++p)
    if (weights_[p] != 0 && (!solver_ || is_given_[p] != 0))
      for (std::size_t k = 2 * p; k < 2 * p + 2; ++k) result[k] = weights_[p] * velocity[k];
  if (solver_) extend_harmonically(result);
  return result;
}

void MeshVelocity::extend_harmonically(std::span<double> values) const {
  const CsrPattern& pattern = *stiffness_.pattern;
  std::vector<double> b(points_.size()), x(points_.size());
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < b.size(); ++i) {
      b[i] = x[i] = 0;
      if (is_given_[index(points_[i])] != 0) continue;
      for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k)
        b[i] -= stiffness_.values[index(k)] * values[2 * index(points_[index(pattern.columns[index(k)])]) + c];
    }
    const SolveOutcome outcome = solver_->solve(b, x, solver_tolerance);
    if (!outcome.converged) throw NoSolution("the motion of the mesh: " + outcome.why);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (is_given_[index(points_[i])] == 0) values[2 * index(points_[i]) + c] = x[i];
  }
}

}  // namespace pliant
