// lib/pliant/improve/global/minimize_deformation.cpp: the elements as cost functions of Ceres, and its options.
#include "pliant/improve/global/minimize_deformation.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <unordered_map>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

/// The squares of one element's energy, as a cost function of the blocks that move.
class ElementCost final : public ceres::CostFunction {
 public:
  ElementCost(const FreePoints& points, TriangleId t, const DeformationEnergy& energy,
              const DeformationEnergy::Target& target)
      : points_(points), energy_(energy), triangle_(t), target_(target) {
    set_num_residuals(energy_.residual_count());
  }
  /// Makes the points of this block parameters, in the block's order.
  void add_block(const FreePoints::Block& block) {
    const auto ids = points_.mesh().net(triangle_);
    for (int j = 0; j < block.count; ++j)
      moving_.push_back(
          static_cast<std::int8_t>(std::find(ids.begin(), ids.end(), points_.point_in(block.first + j)) - ids.begin()));
    mutable_parameter_block_sizes()->push_back(2 * block.count);
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    FreePoints::Net net;
    const std::span<const Point> points = points_.gather(triangle_, net);
    std::size_t m = 0;
    const auto& sizes = parameter_block_sizes();
    for (std::size_t b = 0; b < sizes.size(); ++b)
      for (int j = 0; j < sizes[b]; j += 2) net[index(moving_[m++])] = {parameters[b][j], parameters[b][j + 1]};
    const auto count = index(num_residuals()), columns = 2 * moving_.size();
    thread_local std::vector<double> all;
    all.resize(count * columns);
    if (!energy_.evaluate(points, target_, {residuals, count}, moving_, jacobians ? all.data() : nullptr)) return false;
    if (target_.smoothing == 0 && !points_.is_valid(points)) return false;
    if (!jacobians) return true;
    std::size_t first = 0;
    for (std::size_t b = 0; b < sizes.size(); first += index(sizes[b++]))
      if (jacobians[b])
        for (std::size_t r = 0; r < count; ++r)
          std::copy_n(all.data() + r * columns + first, sizes[b], jacobians[b] + r * index(sizes[b]));
    return true;
  }

 private:
  const FreePoints& points_;
  const DeformationEnergy& energy_;
  TriangleId triangle_;
  DeformationEnergy::Target target_;
  std::vector<std::int8_t> moving_;
};

/// The energy with many nodes where det J is far from even, since it may be negative between few of them.
const DeformationEnergy& energy_for(const FreePoints& points, TriangleId t) {
  constexpr double even = 0.2;
  const int degree = points.mesh().degree();
  FreePoints::Net net;
  std::array<double, net_size(jacobian_degree(max_degree))> coefficients;
  const std::span<double> used{coefficients.data(), index(net_size(jacobian_degree(degree)))};
  jacobian_net(degree, points.gather(t, net), used);
  const auto [least, greatest] = std::minmax_element(used.begin(), used.end());
  return DeformationEnergy::of(
      degree, *least > even * *greatest ? DeformationEnergy::Nodes::few : DeformationEnergy::Nodes::many);
}

/// The corners between two edges on curves, as bits: nothing that moves changes det F there, and it is 0 in a cusp.
unsigned fixed_corners(const Mesh& mesh, TriangleId t) {
  unsigned fixed = 0;
  for (int c = 0; c < 3; ++c)
    if (mesh.is_constrained(half_edge(t, c)) && mesh.is_constrained(half_edge(t, (c + 2) % 3))) fixed |= 1u << c;
  return fixed;
}

}  // namespace

MinimizeOutcome minimize_deformation(FreePoints& points, std::span<const TriangleId> elements,
                                     std::span<const WantedShape> wanted, const MinimizeOptions& options) {
  FLAGS_minloglevel = 3;  // else glog would write to standard error about steps that fail
  const Mesh& mesh = points.mesh();
  std::unordered_map<int, int> uses;  // how many of these elements contain each block
  uses.reserve(2 * elements.size());
  const auto for_blocks = [&](TriangleId t, auto&& use) {
    int last = none;
    for (const PointId p : mesh.net(t))
      if (const int b = points.block_of(p); b != none && b != last) use(last = b);
  };
  for (const TriangleId t : elements) for_blocks(t, [&](int b) { ++uses[b]; });

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;
  ceres::Problem problem(ownership);
  std::deque<ElementCost> costs;
  std::vector<double*> parameters;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const TriangleId t = elements[k];
    costs.emplace_back(
        points, t, energy_for(points, t),
        DeformationEnergy::Target{wanted[k], options.any_area, fixed_corners(mesh, t), options.smoothing});
    parameters.clear();
    for_blocks(t, [&](int b) {
      const FreePoints::Block& block = points.blocks()[index(b)];
      if (uses[b] < block.elements || (block.is_vertex && !options.vertices)) return;
      costs.back().add_block(block);
      parameters.push_back(points.coordinates(block.first));
    });
    if (!parameters.empty()) problem.AddResidualBlock(&costs.back(), nullptr, parameters);
  }
  MinimizeOutcome outcome;
  if (problem.NumParameterBlocks() == 0) return outcome;

  ceres::Solver::Options solver;
  solver.linear_solver_type = options.direct ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::CGNR;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  solver.preconditioner_type = ceres::JACOBI;
  solver.max_linear_solver_iterations = 100;
  solver.max_num_iterations = options.max_iterations;
  // These options would else make the outcome depend on the unit of length.
  solver.jacobi_scaling = false;
  solver.min_lm_diagonal = std::numeric_limits<double>::min();
  solver.gradient_tolerance = std::numeric_limits<double>::min();
  solver.function_tolerance = options.tolerance;
  solver.parameter_tolerance = 1e-14;  // steps are short where an element is about to tangle
  solver.max_num_consecutive_invalid_steps = 40;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  const bool has_begun = summary.termination_type != ceres::FAILURE;
  outcome.energy_before = has_begun ? summary.initial_cost : std::numeric_limits<double>::quiet_NaN();
  outcome.energy_after = has_begun ? summary.final_cost : std::numeric_limits<double>::quiet_NaN();
  outcome.iterations = summary.num_successful_steps;
  return outcome;
}

}  // namespace pliant
