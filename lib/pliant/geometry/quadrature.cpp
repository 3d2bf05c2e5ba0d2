// lib/pliant/geometry/quadrature.cpp: symmetric rules of low degrees, and Gauss rules on the collapsed square.
#include "pliant/geometry/quadrature.h"

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

/// A polynomial's value and derivative at a point of [-1, 1].
struct Value {
  Real value, slope;
};

Value legendre(int n, Real x) {
  Value before{0, 0};
  Value now{1, 0};
  for (int m = 1; m <= n; ++m) {
    const Value next{((2 * m - 1) * x * now.value - (m - 1) * before.value) / m,
                     before.slope + (2 * m - 1) * now.value};
    before = std::exchange(now, next);
  }
  return now;
}

/// All n roots in (-1, 1), ascending, of a polynomial with real roots only. `outside` is one more root, which is known,
/// or 0 if there is none. Newton's method runs on the polynomial divided by the known roots; coming from the left, it
/// climbs to the next root without passing it.
template <class Polynomial>
std::vector<Real> roots_of(int n, const Polynomial& polynomial, Real outside) {
  std::vector<Real> roots;
  while (roots.size() < index(n)) {
    Real x = roots.empty() ? -1 : roots.back() + 1e-6L;
    for (int step = 0; step < 200; ++step) {
      const Value f = polynomial(x);
      Real poles = outside != 0 ? 1 / (x - outside) : 0;
      for (const Real root : roots) poles += 1 / (x - root);
      const Real change = f.value / (f.slope - f.value * poles);
      x -= change;
      if (std::fabs(change) < 1e-18L) break;
    }
    roots.push_back(x);
  }
  return roots;
}

/// Pairs of a node and its weight, on [0, 1].
using Nodes = std::vector<std::pair<Real, Real>>;

Nodes gauss_legendre(int n) {
  Nodes nodes;
  for (const Real x : roots_of(
           n, [n](Real t) { return legendre(n, t); }, 0)) {
    const Real slope = legendre(n, x).slope;
    nodes.emplace_back((1 + x) / 2, 1 / ((1 - x * x) * slope * slope));
  }
  return nodes;
}

/// Gauss-Jacobi for the weight 1 - y on [0, 1]: the inner nodes of the Radau rule with n + 1 points, the roots of
/// (P_n - P_{n+1}) / (1 - x).
Nodes gauss_jacobi(int n) {
  const auto radau = [n](Real t) {
    const Value a = legendre(n, t);
    const Value b = legendre(n + 1, t);
    return Value{a.value - b.value, a.slope - b.slope};
  };
  Nodes nodes;
  for (const Real x : roots_of(n, radau, 1)) {
    const Real value = (n + 1) * legendre(n, x).value;
    nodes.emplace_back((1 + x) / 2, (1 - x) * (1 + x) / (4 * value * value));
  }
  return nodes;
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
