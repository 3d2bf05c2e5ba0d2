// lib/pliant/geometry/dense/solve_dense.h: small square systems, by elimination with full pivoting.
#pragma once
#include <span>

namespace pliant {

/// Solves matrix * x = right by elimination with full pivoting; x takes the place of `right`.
/// What the matrix does not determine, to rounding, is 0. Up to n = 96 nothing is allocated.
///
/// Shapes      matrix: n x n, right: n x columns, both row after row
/// Complexity  O(n^3)
void solve_dense(int n, std::span<const double> matrix, int columns, std::span<double> right);

}  // namespace pliant
