// lib/pliant/geometry/quadrature.cpp: symmetric rules of low degrees, and Gauss rules on the collapsed square.
#include "pliant/geometry/quadrature.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr int greatest_exact_degree = 40;
using Real = long double;  // rounded to double, nodes and weights are then right to the last bit or so

/// Pairs of a node and its weight, on [0, 1].
using Nodes = std::vector<std::pair<Real, Real>>;

/// Golub and Welsch: the orthonormal polynomials of a weight on [-1, 1] have a three-term recurrence; the nodes are the
/// eigenvalues of its symmetric tridiagonal matrix, and the squares of the eigenvectors' first components are the
/// weights, up to their sum.
Nodes gauss_nodes(const Eigen::VectorX<Real>& diagonal, const Eigen::VectorX<Real>& beside, Real sum) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixX<Real>> pairs;
  pairs.computeFromTridiagonal(diagonal, beside);
  Nodes nodes;
  for (int i = 0; i < diagonal.size(); ++i) {
    const Real first = pairs.eigenvectors()(0, i);
    nodes.emplace_back((1 + pairs.eigenvalues()[i]) / 2, sum * first * first);
  }
  return nodes;
}

Nodes gauss_legendre(int n) {
  Eigen::VectorX<Real> beside(n - 1);
  for (int k = 1; k < n; ++k) beside[k - 1] = k / std::sqrt(Real(4 * k * k - 1));
  return gauss_nodes(Eigen::VectorX<Real>::Zero(n), beside, 1);
}

/// Gauss-Jacobi for the weight 1 - y on [0, 1].
Nodes gauss_jacobi(int n) {
  Eigen::VectorX<Real> diagonal(n), beside(n - 1);
  for (int k = 0; k < n; ++k) diagonal[k] = -1 / Real((2 * k + 1) * (2 * k + 3));
  for (int k = 1; k < n; ++k) beside[k - 1] = std::sqrt(Real(k * (k + 1))) / (2 * k + 1);
  return gauss_nodes(diagonal, beside, Real(1) / 2);
}

/// Adds the three nodes that the permutations of (1 - 2a, a, a) give.
void add_orbit(std::vector<TriangleNode>& rule, double a, double weight) {
  rule.push_back({{1 - 2 * a, a, a}, weight / 2});
  rule.push_back({{a, 1 - 2 * a, a}, weight / 2});
  rule.push_back({{a, a, 1 - 2 * a}, weight / 2});
}

/// Up to degree 5 the symmetric rules with fewest points (Strang and Fix; Radon); above that Gauss rules on the unit
/// square, one side of which is collapsed to a corner.
std::vector<TriangleNode> build_triangle_rule(int degree) {
  std::vector<TriangleNode> rule;
  if (degree <= 1) {
    rule.push_back({{1.0 / 3, 1.0 / 3, 1.0 / 3}, 0.5});
  } else if (degree == 2) {
    add_orbit(rule, 1.0 / 6, 1.0 / 3);
  } else if (degree <= 4) {
    const double inner = std::sqrt(38 - 44 * std::sqrt(0.4));
    const double outer = std::sqrt(213125 - 53320 * std::sqrt(10.0));
    add_orbit(rule, (8 - std::sqrt(10.0) + inner) / 18, (620 + outer) / 3720);
    add_orbit(rule, (8 - std::sqrt(10.0) - inner) / 18, (620 - outer) / 3720);
  } else if (degree == 5) {
    const double root = std::sqrt(15.0);
    rule.push_back({{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 80});
    add_orbit(rule, (6 - root) / 21, (155 - root) / 1200);
    add_orbit(rule, (6 + root) / 21, (155 + root) / 1200);
  } else {
    const int n = degree / 2 + 1;
    const Nodes across = gauss_legendre(n);
    for (const auto& [y, weight_y] : gauss_jacobi(n)) {
      for (const auto& [x, weight_x] : across) {
        const Real xi2 = x * (1 - y);
        rule.push_back({{static_cast<double>((1 - x) * (1 - y)), static_cast<double>(xi2), static_cast<double>(y)},
                        static_cast<double>(weight_x * weight_y)});
      }
    }
  }
  return rule;
}

std::vector<SegmentNode> build_segment_rule(int degree) {
  std::vector<SegmentNode> rule;
  for (const auto& [s, weight] : gauss_legendre(degree / 2 + 1))
    rule.push_back({static_cast<double>(s), static_cast<double>(weight)});
  return rule;
}

template <class Node, std::vector<Node> build(int degree)>
std::span<const Node> rule_of(int degree) {
  static std::array<std::once_flag, greatest_exact_degree + 1> built;
  static std::array<std::vector<Node>, greatest_exact_degree + 1> rules;
  assert(degree <= greatest_exact_degree);
  const std::size_t n = index(degree < 0 ? 0 : degree);
  std::call_once(built[n], [n] { rules[n] = build(static_cast<int>(n)); });
  return rules[n];
}

}  // namespace

std::span<const TriangleNode> triangle_rule(int exact_degree) {
  return rule_of<TriangleNode, build_triangle_rule>(exact_degree);
}

std::span<const SegmentNode> segment_rule(int exact_degree) {
  return rule_of<SegmentNode, build_segment_rule>(exact_degree);
}

}  // namespace pliant
